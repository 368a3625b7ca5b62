// From values of a load history to load factors, whatever is controlled.
#include "coarse/load/load_scale.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <tuple>

#include "common/error.hpp"

namespace stria::coarse {
namespace {

const UnitResponse nominal{.K_I = {20.0, 30.0}, .displacement = {0.5, 0.6}};

Case history(Control control) {
    Case input;
    input.load = {.blocks = {{.cycles = 3, .max = 100.0, .min = 10.0}}, .scale = 2.0, .control = control};
    return input;
}

TEST(LoadScale, OfLoadsIsOne) {
    const Case input = history(Control::Load);
    EXPECT_EQ(target_of_unit(input.load, nominal.K_I, 1.0), 1.0);
    EXPECT_EQ(range_of_load(input, nominal).largest, 200.0);
    EXPECT_EQ(largest_K(input, nominal), (std::vector<double>{4000.0, 6000.0}));
}

// Tension opens the crack and shears it; pressure closes it, and what friction leaves of the shear still slides.
TEST(LoadScale, AZoneIsOfTensionAndShear) {
    Case input;
    input.load.blocks = {{.max = 2.0, .min = -5.0}};
    UnitResponse sheared{.K_I = {40.0}, .K_II = {-10.0 / std::sqrt(3.0)}};
    EXPECT_DOUBLE_EQ(largest_K(input, sheared).front(), std::hypot(80.0, 20.0));
    sheared.K_II_initial = {-30.0 / std::sqrt(3.0)};  // slides the same way as the load
    EXPECT_DOUBLE_EQ(largest_K(input, sheared).front(), std::hypot(80.0, 50.0));
    sheared.K_II_initial.clear();
    sheared.K_I = {4.0};
    EXPECT_DOUBLE_EQ(largest_K(input, sheared).front(), 50.0);  // at the minimum, of faces that overlap
    sheared.friction = {0.0};
    EXPECT_DOUBLE_EQ(largest_K(input, sheared).front(), 50.0);
    sheared.friction = {0.7};
    EXPECT_DOUBLE_EQ(largest_K(input, sheared).front(), 50.0 - 14.0 * std::sqrt(3.0));
    sheared.friction = {1.0};  // slides less than tension opens and shears it
    EXPECT_DOUBLE_EQ(largest_K(input, sheared).front(), std::hypot(8.0, 20.0));
    input.load.blocks.front().max = 0.0;
    sheared.friction = {1.5};
    EXPECT_EQ(largest_K(input, sheared).front(), 0.0);  // sticks
}

// 10 MPa sqrt(mm) of K_I and of K_II per unit of a load case that goes from 3 to -4.
TEST(LoadScale, AddsWhatLoadCasesMayAddAtOnce) {
    Case input;
    input.load.blocks = {{.max = 1.0, .min = 0.0}};
    LoadCaseSection& shear = input.load_cases.emplace_back();
    shear.name = "shear";
    shear.blocks = {{.cycles = 1, .at_max = 3.0, .at_min = -4.0}};
    const UnitResponse unit{.K_I = {100.0}, .K_II = {0.0}, .K_I_of_cases = {{10.0}}, .K_II_of_cases = {{10.0}}};
    EXPECT_DOUBLE_EQ(largest_K(input, unit).front(), std::sqrt(130.0 * 130.0 + 3.0 * 40.0 * 40.0));
}

// Two of three positions press the faces together.
TEST(LoadScale, APressureThatTravelsCountsWhereItOpensTheCrack) {
    Case input;
    input.load.steps = 2;
    input.load.blocks = {{.max = 0.0, .min = -1.0}};
    input.boundaries.emplace_back().travelling.emplace();
    ASSERT_EQ(CaseHistories(input).count(), 3);
    UnitResponse unit{
        .K_I = {0.0}, .K_II = {0.0}, .K_I_of_cases = {{-9.0, 3.0, -1.0}}, .K_II_of_cases = {{50.0, -4.0, 8.0}}};
    EXPECT_DOUBLE_EQ(largest_K(input, unit).front(), std::sqrt(9.0 + 3.0 * 2500.0));
    unit.friction = {0.0};
    EXPECT_DOUBLE_EQ(largest_K(input, unit).front(), std::sqrt(9.0 + 3.0 * 16.0));
}

TEST(LoadScale, WhatOpensNothingIsNoKOfTheUsualCycles) {
    Case input;
    input.load.blocks = {{.max = 2.0, .min = 0.0}};
    UnitResponse unit{.K_I = {30.0, -30.0}, .K_II = {30.0, 10.0}};
    EXPECT_EQ(common_K_I(input, unit), (std::vector<double>{60.0, 0.0}));
    unit.K_I.back() = 1e-3;  // of the mesh
    EXPECT_EQ(common_K_I(input, unit), (std::vector<double>{60.0, 0.0}));
}

TEST(LoadScale, IncrementsAreEqualWhereTheLoadPressesRoughFaces) {
    Case input;
    input.load.blocks = {{.max = 1.0, .min = -1.0}};
    UnitResponse unit{.K_I = {10.0}, .K_II = {0.0}, .friction = {0.3}};
    const auto is_graded = [&] { return !graded_load(input, unit).grading; };
    EXPECT_FALSE(is_graded());
    EXPECT_EQ(*graded_load(input, unit).grading, 1.0);
    unit.friction = {0.0};
    EXPECT_TRUE(is_graded());
    unit.friction = {std::nullopt};
    EXPECT_TRUE(is_graded());
    unit.friction = {0.3};
    input.load.blocks.front().min = 0.0;
    EXPECT_TRUE(is_graded());
    input.load.blocks.front().min = -1.0;
    input.load.steps = 20;
    EXPECT_FALSE(is_graded());
    input.load_cases = {test::lagging_load("shear", 1.0, 90.0)};
    EXPECT_TRUE(is_graded()) << "by the angle";
    input.load_cases.clear();
    input.load.grading = 0.7;
    EXPECT_EQ(*graded_load(input, unit).grading, 0.7);
}

// One load case presses the faces, another one shears them to and fro: what the first would do at its best opens
// nothing.
TEST(LoadScale, IncrementsAreEqualWhereALoadCasePressesRoughFaces) {
    Case input;
    input.load.blocks = {{.max = 1.0, .min = 0.0}};
    for (const auto& [name, at_max, at_min] : {std::tuple{"press", 0.0, -2.0}, {"shear", 1.0, -1.0}}) {
        LoadCaseSection& load_case = input.load_cases.emplace_back();
        load_case.name = name;
        load_case.blocks = {{.cycles = 1, .at_max = at_max, .at_min = at_min}};
    }
    UnitResponse unit{.K_I = {0.0},
                      .K_II = {0.0},
                      .K_I_of_cases = {{10.0, -1e-3}},  // of the mesh
                      .K_II_of_cases = {{0.0, 30.0}},
                      .friction = {0.3}};
    EXPECT_EQ(graded_load(input, unit).grading, 1.0);
    unit.friction = {0.0};
    EXPECT_EQ(graded_load(input, unit).grading, std::nullopt);
    unit.friction = {0.3};
    input.load_cases.front().blocks.front().at_min = 0.0;
    EXPECT_EQ(graded_load(input, unit).grading, std::nullopt) << "sheared alone";
    input.load_cases.front().blocks.clear();
    input.load_cases.front().constant = -2.0;
    EXPECT_EQ(graded_load(input, unit).grading, 1.0);
    unit.K_initial = {30.0};
    EXPECT_EQ(graded_load(input, unit).grading, std::nullopt) << "held open";
}

// One peak in ten cycles makes more than half of the growth where its exponent is 4: 16 of 25 parts.
TEST(LoadScale, APeakStandsForTheCyclesWhereItMakesHalfOfTheGrowth) {
    Case input;
    input.load = {.blocks = {{9, 50.0, 0.0}, {1, 100.0, 0.0}}, .scale = 2.0};
    EXPECT_EQ(common_K_I(input, nominal), (std::vector<double>{4000.0, 6000.0}));  // nothing grows
    input.growth = GrowthSection{.increment = 0.1};
    EXPECT_EQ(common_K_I(input, nominal), (std::vector<double>{2000.0, 3000.0}));
    input.growth->law = GrowthLaw::Paris;
    input.growth->m = 3.0;
    EXPECT_EQ(common_K_I(input, nominal).front(), 2000.0);
    input.growth->m = 4.0;
    EXPECT_EQ(common_K_I(input, nominal).front(), 4000.0);
    input.growth->law = GrowthLaw::Ctod;
    input.growth->m = 2.0;
    EXPECT_EQ(common_K_I(input, nominal).front(), 4000.0);
}

TEST(LoadScale, OfDisplacementsIsThatOfTheNominalBody) {
    const Case input = history(Control::Displacement);
    EXPECT_EQ(target_of_unit(input.load, nominal.K_I, 1.0), 1.0);  // a target is a displacement
    EXPECT_EQ(range_of_load(input, nominal).largest, 400.0);
    EXPECT_THROW(static_cast<void>(range_of_load(input, {.displacement = {0.0, 0.6}})), CaseError);
}

/// 40 MPa sqrt(mm) per mm of the boundary, and 30 with 0.2 mm per unit of a load case.
struct HeldBoundary {
    Case input;
    UnitResponse unit{.K_I = {20.0},
                      .K_I_of_cases = {{30.0}},
                      .K_II_of_cases = {{0.0}},
                      .displacement = {.mean = 0.5, .largest = 1.0, .of_cases = {0.2}}};

    explicit HeldBoundary(const LoadCaseSection& load_case) {
        input.load.control = Control::Displacement;
        input.load_cases = {load_case};
    }
    [[nodiscard]] double largest(double max, double min) {
        input.load.blocks = {{.max = max, .min = min}};
        return largest_K(input, unit).front();
    }
    [[nodiscard]] double least(double max, double min) {
        input.load.blocks = {{.max = max, .min = min}};
        return least_K_I(input, unit).front();
    }
};

// The zone was that of a load which moves the boundary all of the way, with the dead load besides: 170 in place of 146.
TEST(LoadScale, ADisplacementIsPartlyThatOfADeadLoad) {
    HeldBoundary held(test::dead_load("dead", 3.0));
    EXPECT_DOUBLE_EQ(held.largest(2.0, 1.0), 40.0 * (2.0 - 0.6) + 90.0);
    EXPECT_DOUBLE_EQ(range_of_load(held.input, held.unit).largest, 2.8);
    EXPECT_DOUBLE_EQ(held.largest(0.3, 0.1), 90.0) << "as the dead load has come on";
    EXPECT_EQ(held.least(2.0, -1.0), 0.0) << "held open by the dead load";
    EXPECT_DOUBLE_EQ(held.least(2.0, -2.0), 40.0 * (-2.0 - 0.6) + 90.0);
    held.unit.displacement.initial = 0.1;
    held.unit.K_initial = {5.0};
    EXPECT_DOUBLE_EQ(held.largest(2.0, 1.0), 40.0 * (2.0 - 0.7) + 95.0);
    EXPECT_DOUBLE_EQ(held.largest(0.3, 0.1), 95.0);
}

// What another load moves the boundary by meanwhile the load factor takes back: 30 - 8 per unit.
TEST(LoadScale, AHeldBoundaryTakesBackWhatALoadCaseMovesIt) {
    HeldBoundary held(test::own_load("own", {{.cycles = 1, .at_max = 1.0, .at_min = -1.0}}));
    EXPECT_DOUBLE_EQ(held.largest(2.0, 1.0), 80.0 + 22.0);
}

// At its first position it has moved the boundary by 0.1 mm.
TEST(LoadScale, AHeldBoundaryTakesBackWhatAPressureThatTravelsMovesIt) {
    HeldBoundary held({});
    held.input.load_cases.clear();
    held.input.load.steps = 2;
    held.input.boundaries.emplace_back().travelling.emplace();
    held.unit.K_I_of_cases = {{4.0, 5.0, 6.0}};
    held.unit.K_II_of_cases = {{0.0, 0.0, 0.0}};
    held.unit.displacement.of_cases = {0.1, -0.1, 0.0};
    EXPECT_DOUBLE_EQ(held.largest(0.0, -1.0), 40.0 * 0.1 + 9.0) << "at the second one";
}

// Ranges count from where the load is none.
TEST(LoadScale, TheCyclesThatMakeHalfOfTheGrowthCountFromTheDeadLoad) {
    HeldBoundary held(test::dead_load("dead", 3.0));
    held.input.growth = GrowthSection{.increment = 0.1};
    held.input.load.blocks = {{9, 1.6, 0.6}, {1, 2.6, 0.6}};
    EXPECT_DOUBLE_EQ(common_K_I(held.input, held.unit).front(), 40.0 * 1.0 + 90.0);
    held.input.load.blocks = {{1, -1.0, -2.0}};
    EXPECT_DOUBLE_EQ(common_K_I(held.input, held.unit).front(), 90.0);
}

TEST(LoadScale, OfStressIntensitiesFollowsTheFirstTipAndTheGradient) {
    const Case input = history(Control::StressIntensity);
    EXPECT_EQ(range_of_load(input, nominal).largest, 10.0);
    EXPECT_EQ(largest_K(input, nominal).front(), 200.0);
    LoadSection load = input.load;
    load.K_gradient = -0.08;
    EXPECT_DOUBLE_EQ(target_of_unit(load, nominal.K_I, 2.0), std::exp(-0.16) / 20.0);
    EXPECT_THROW(static_cast<void>(target_of_unit(load, {-1.0, 30.0}, 0.0)), CaseError);
    EXPECT_THROW(static_cast<void>(target_of_unit(load, {}, 0.0)), CaseError);
}

}  // namespace
}  // namespace stria::coarse
