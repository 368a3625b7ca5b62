// A tip opens as its own K rises, whatever [load] does: faces of an elastic body part, and meet, where K_I is zero.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "tests/support/load_cases.hpp"
#include "tests/support/sent_analysis.hpp"
#include "tests/support/specimens.hpp"

namespace stria::test {
namespace {

/// Without loads.
Case plate(std::vector<std::vector<Vec2>> cracks) {
    Case input = specimen("plate", 40.0, cracks.front());
    input.mesh.width = 40.0;
    input.mesh.size = 2.0;
    input.cracks.clear();
    for (std::vector<Vec2>& crack : cracks)
        input.cracks.push_back({.points = std::move(crack), .contact = ContactSection{0.3}});
    input.closure.distance = 1.0;
    return input;
}

constexpr double precision = 0.002;  // of the largest load

void expect_opening_where_K_is_zero(const coarse::CycleResult& cycle, double K_max, double K_min) {
    EXPECT_NEAR(cycle.K_max, K_max, 1e-3 * K_max);
    EXPECT_NEAR(cycle.K_min, K_min, 1e-3 * K_max);
    EXPECT_NEAR(cycle.opening.K_op, 0.0, precision * K_max);
    EXPECT_NEAR(cycle.opening.K_cl, 0.0, precision * K_max);
    EXPECT_FALSE(cycle.opening.lost);
}

// The one that [load] closes as it grows was said to open at its largest K: nothing was left to drive it.
TEST(OpeningDirections, OfTwoCracksInABentPlateOneClosesAsTheOtherOpens) {
    Case input = plate({{{0.0, 20.3}, {9.0, 20.3}}, {{40.0, 20.3}, {31.0, 20.3}}});
    input.boundaries = {at_end("top", End::Pulled, 1.0), at_end("bottom", End::Pulled, -1.0)};
    for (BoundarySection& boundary : input.boundaries) {
        boundary.origin = {20.0, 0.0};
        boundary.traction_gradient(1, 0) = -0.05 * boundary.traction->y();
        boundary.traction->setZero();
    }
    input.load = {.steps = 16, .blocks = {{.cycles = 2, .max = 80.0, .min = -40.0}}};
    const std::vector<coarse::CycleResult> cycles = run_cycles(input);
    ASSERT_EQ(cycles.size(), 4U);
    const coarse::CycleResult &left = cycles[2], &right = cycles[3];
    expect_opening_where_K_is_zero(left, left.K_max, -0.5 * left.K_max);
    expect_opening_where_K_is_zero(right, 0.5 * left.K_max, -left.K_max);
}

// K follows a load that lags, and shear is the load of [load]. Where it lags by a quarter of a cycle K is zero at the
// turns of [load], which hardly changes there: openings were up to 2.7 % of K_max off. Where it lags by more the crack
// opens as [load] falls, and K_op was K where [load] is least.
TEST(OpeningDirections, ACrackWhoseKLagsOpensAsKRises) {
    for (const double phase : {0.0, 70.0, 90.0, 110.0, 180.0, 250.0}) {
        SCOPED_TRACE(phase);
        Case input = plate({{{0.0, 20.3}, {9.0, 20.3}}});
        input.load = {.steps = 24, .blocks = {{.cycles = 3, .max = 40.0, .min = -40.0}}};
        for (const auto& [on, traction] : {std::pair("top", Vec2(1.0, 0.0)), std::pair("bottom", Vec2(-1.0, 0.0)),
                                           std::pair("right", Vec2(0.0, 1.0)), std::pair("left", Vec2(0.0, -1.0))}) {
            BoundarySection shear;
            shear.on = on;
            shear.traction = traction;
            input.boundaries.push_back(shear);
        }
        input.load_cases = {lagging_load("pull", 1.0, phase)};
        input.boundaries.push_back(pulled_in_case("pull", "top", {0.0, 1.0}));
        input.boundaries.push_back(pulled_in_case("pull", "bottom", {0.0, -1.0}));
        const coarse::CycleResult last = run_cycles(input).back();
        expect_opening_where_K_is_zero(last, last.K_max, -last.K_max);
    }
}

// A load case is all that opens and closes the crack, in whole increments of [load] that are less than 0.002 of it.
TEST(OpeningDirections, ALoadCaseMayDoItAllWhileTheLoadHardlyChanges) {
    Case input = plate({{{0.0, 20.3}, {9.0, 20.3}}});
    input.load = {.steps = 4, .blocks = {{.cycles = 2, .max = 10.0, .min = 9.999}}};
    for (const auto& [on, sign] : {std::pair("left", 1.0), std::pair("right", -1.0)}) {
        BoundarySection squeezed;
        squeezed.on = on;
        squeezed.traction = Vec2(sign, 0.0);
        input.boundaries.push_back(squeezed);
    }
    input.load_cases = {own_load("pull", {{.cycles = 2, .at_max = -30.0, .at_min = 70.0}})};
    input.boundaries.push_back(pulled_in_case("pull", "top", {0.0, 1.0}));
    input.boundaries.push_back(pulled_in_case("pull", "bottom", {0.0, -1.0}));
    const coarse::CycleResult last = run_cycles(input).back();
    expect_opening_where_K_is_zero(last, last.K_max, -3.0 / 7.0 * last.K_max);
}

}  // namespace
}  // namespace stria::test
