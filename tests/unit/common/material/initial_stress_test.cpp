// The stress before any load as a case gives it: values, slopes, and the file of a grid.
#include "common/material/initial_stress.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <numbers>

#include "common/case/schema/region_schema.hpp"
#include "common/error.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria {
namespace {

Case two_materials() {
    Case input;
    input.material.poisson = 0.3;
    input.regions.resize(1);
    input.regions[0].material.poisson = 0.2;
    input.regions[0].initial_stress = MisfitStress{.xx = 1.0, .yy = 2.0, .xy = 4.0};
    return input;
}

InitialStressSection profiles() {
    InitialStressSection given;
    given.sigma_x = StressProfile{.at = {0.0, 10.0}, .stress = {5.0, -5.0}};
    given.sigma_y = StressProfile{.at = {0.0, 1.0, 4.0}, .stress = {0.0, 30.0, 0.0}};
    return given;
}

TEST(InitialStressField, PartsAddUp) {
    Case input = two_materials();
    EXPECT_FALSE(InitialStress().any());
    EXPECT_TRUE(InitialStress(input).any());
    input.initial_stress = profiles();
    const InitialStress stress(input);
    const double root = std::numbers::sqrt2;
    EXPECT_LT((stress.at({2.0, 3.0}, 0) - Mandel(2.0, 20.0, 0.3 * 22.0, 0.0)).norm(), 1e-13);
    EXPECT_LT((stress.at({2.0, 3.0}, 1) - Mandel(3.0, 22.0, 0.2 * 25.0, 4.0 * root)).norm(), 1e-13);
    const Vec2 along = Vec2(0.6, 0.8);
    EXPECT_LT((stress.slope({2.0, 3.0}, 0, along) - Mandel(-0.8, -6.0, 0.3 * -6.8, 0.0)).norm(), 1e-13);
    input.model.plane = PlaneState::Stress;
    EXPECT_EQ(InitialStress(input).at({2.0, 3.0}, 0)[2], 0.0);
}

TEST(InitialStressField, ABilinearGridIsExactForBilinearFields) {
    Case input;
    StressGrid grid{.x = {0.0, 1.0, 4.0}, .y = {-1.0, 0.5, 2.0}, .xx = {}, .yy = {}, .xy = {}};
    const auto field = [](const Vec2& x) { return 3.0 + 2.0 * x.x() - x.y() + 0.5 * x.x() * x.y(); };
    for (const double y : grid.y) {
        for (const double x : grid.x) {
            grid.xx.push_back(field({x, y}));
            grid.yy.push_back(2.0 * field({x, y}));
            grid.xy.push_back(-field({x, y}));
        }
    }
    input.initial_stress.emplace().grid = grid;
    const InitialStress stress(input);
    for (const Vec2& x : {Vec2(0.3, -0.2), Vec2(3.1, 1.7), Vec2(0.0, -1.0), Vec2(4.0, 2.0)}) {
        const Mandel there = stress.at(x, 0), slope = stress.slope(x, 0, {1.0, 0.0});
        EXPECT_NEAR(there[0], field(x), 1e-13);
        EXPECT_NEAR(there[1], 2.0 * field(x), 1e-13);
        EXPECT_NEAR(there[3], -std::numbers::sqrt2 * field(x), 1e-13);
        EXPECT_NEAR(slope[0], 2.0 + 0.5 * x.y(), 1e-13);
        EXPECT_NEAR(stress.slope(x, 0, {0.0, 1.0})[0], -1.0 + 0.5 * x.x(), 1e-13);
    }
}

// A point of integration may lie where a profile bends, and rounding puts it on either side: K of a plate in other
// units was off by 3 %.
TEST(InitialStressField, HasTheMeanSlopeOfBothSidesWhereItBends) {
    Case input;
    input.initial_stress = profiles();
    StressGrid& grid = input.initial_stress->grid.emplace();
    grid = {.x = {0.0, 1.0, 4.0}, .y = {0.0, 1.0}, .xx = {}, .yy = {}, .xy = {}};
    grid.xx = grid.yy = grid.xy = {0.0, 6.0, 0.0, 0.0, 6.0, 0.0};
    const InitialStress stress(input);
    for (const double rounding : {-1e-15, 0.0, 1e-15}) {
        const Mandel slope = stress.slope({1.0 + rounding, 0.4}, 0, {1.0, 0.0});
        EXPECT_NEAR(slope[0], 0.5 * (6.0 - 2.0), 1e-12);
        EXPECT_NEAR(slope[1], 0.5 * (30.0 - 10.0) + 0.5 * (6.0 - 2.0), 1e-12);
    }
    EXPECT_NEAR(stress.slope({0.99, 0.4}, 0, {1.0, 0.0})[1], 36.0, 1e-12);
    EXPECT_NEAR(stress.slope({0.0, 0.4}, 0, {1.0, 0.0})[1], 36.0, 1e-12);
    EXPECT_NEAR(stress.slope({4.0, 0.4}, 0, {1.0, 0.0})[1], -12.0, 1e-12);
}

class GridFile : public testing::Test {
protected:
    std::string complaint(const std::string& text) {
        std::ofstream(folder_ / "grid.csv") << text;
        const std::string said = test::refusal_of([&] { grid = read_stress_grid(folder_ / "grid.csv"); });
        return said.substr(said.starts_with('/') ? said.find("grid.csv") + std::string("grid.csv").size() : 0);
    }
    StressGrid grid;
    test::TemporaryFolder folder_;
};

TEST_F(GridFile, NodesMayComeInAnyOrder) {
    ASSERT_EQ(complaint("x,y,sxx,syy,sxy\n1,0,2,20,0\n0,0,1,10,0\n0,3,3,30,0\n1,3,4,40,7\n"), "accepted");
    EXPECT_EQ(grid.x, (std::vector<double>{0.0, 1.0}));
    EXPECT_EQ(grid.y, (std::vector<double>{0.0, 3.0}));
    EXPECT_EQ(grid.xx, (std::vector<double>{1.0, 2.0, 3.0, 4.0}));
    EXPECT_EQ(grid.xy, (std::vector<double>{0.0, 0.0, 0.0, 7.0}));
}

TEST_F(GridFile, WhatIsNoGridIsRefusedWithItsLine) {
    const std::string head = "x,y,sxx,syy,sxy\n";
    EXPECT_EQ(complaint("x,y,sxx,syy\n0,0,1,1\n"), ":1: initial_stress.file: has no column sxy");
    EXPECT_EQ(complaint(head + "0,0,1,1,nought\n"), ":2: initial_stress.file: must be numbers");
    EXPECT_EQ(complaint(head + "0,0,1,1,1\n0,0,1,1,1\n"), ":3: initial_stress.file: repeats a node");
    EXPECT_EQ(complaint(head + "0,0,1,1,1\n\n\n0,0,1,1,1\n"), ":5: initial_stress.file: repeats a node");
    EXPECT_EQ(complaint("\nx,y,sxx,syy,sxy,x\n0,0,1,1,1,3\n"), ":2: initial_stress.file: column x is given twice");
    EXPECT_EQ(complaint(head + "0,0,1,1,1\n1,0,1,1,1\n0,1,1,1,1\n"),
              ": initial_stress.file: 3 nodes are no grid of 2 columns and 2 rows");
    EXPECT_THROW(read_stress_grid(folder_ / "missing.csv"), CaseError);
}

}  // namespace
}  // namespace stria
