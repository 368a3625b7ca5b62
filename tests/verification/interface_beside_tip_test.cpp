// K and T of a crack whose tip is a fraction of an element from another metal.
#include <gtest/gtest.h>

#include <cmath>
#include <fmt/format.h>

#include "coarse/fracture/nominal_solution.hpp"
#include "coarse/model/rings.hpp"
#include "tests/support/layered_plates.hpp"
#include "tests/support/sent_analysis.hpp"
#include "tests/support/specimens.hpp"

namespace stria::test {
namespace {

/// A crack at a fraction of an element from another metal, straight ahead or behind an inclined line.
Case close_to_another(double size, PlaneState plane, bool inclined, double E) {
    Case input = edge_crack(0.394, 2.0, End::Pulled);
    input.mesh.size = 0.02;
    if (size < input.mesh.size)
        input.mesh.grading = {{.at = {Vec2(0.394, 1.0)}, .size = size, .outer_size = size, .radius = 0.03}};
    input.model.plane = plane;
    if (inclined) {
        input.cracks[0].points = {{0.0, 0.81}, {0.394, 1.013}};
        if (size < input.mesh.size) input.mesh.grading[0].at = {Vec2(0.394, 1.013)};
    }
    input.regions = {region_of({{0.4, -1.0}, {2.0, 3.0}}, E, 0.2)};
    return input;
}

class CloseToAnother : public testing::TestWithParam<std::tuple<PlaneState, bool>> {};

/// Elements of 0.02 mm at the tip, 0.3 of them from the other metal, and others that its rings of one metal resolve. In
/// such rings alone K came out as 0 on the first ones.
TEST_P(CloseToAnother, KAndTAreThoseOfSmallElements) {
    const auto [plane, inclined] = GetParam();
    const double E = plane == PlaneState::Strain ? 100e3 : 400e3;
    const auto rings = [](const ElasticSolution& solution) { return coarse::rings_about(solution.scene, 0); };
    const ElasticSolution coarse(close_to_another(0.02, plane, inclined, E));
    const ElasticSolution across(close_to_another(0.002, plane, inclined, E));
    const ElasticSolution fine(close_to_another(0.0005, plane, inclined, E));
    const coarse::TipResult &tip = coarse.tips[0], &near = across.tips[0], &exact = fine.tips[0];
    const double stress = exact.K_I / std::sqrt(0.006);  // at the other metal
    EXPECT_TRUE(std::isnan(tip.J));
    EXPECT_TRUE(rings(fine).back().one_metal);
    EXPECT_TRUE(rings(across).front().one_metal);
    EXPECT_FALSE(rings(across).back().one_metal);
    EXPECT_NEAR(near.J, exact.J, 0.01 * exact.J);
    EXPECT_NEAR(near.K_I, exact.K_I, 1e-3 * exact.K_I);
    EXPECT_NEAR(near.K_II, exact.K_II, 1e-3 * exact.K_I);
    EXPECT_NEAR(near.T_stress, exact.T_stress, 1e-3 * stress);
    EXPECT_NEAR(tip.K_I, exact.K_I, 0.01 * exact.K_I);
    EXPECT_NEAR(tip.K_II, exact.K_II, 0.01 * exact.K_I);
    EXPECT_NEAR(tip.T_stress, exact.T_stress, 0.02 * stress);
    EXPECT_LT(tip.K_spread, 1e-3);
}
INSTANTIATE_TEST_SUITE_P(Metal, CloseToAnother,
                         testing::Combine(testing::Values(PlaneState::Strain, PlaneState::Stress), testing::Bool()),
                         [](const auto& parameters) {
                             return fmt::format(
                                 "{}{}", std::get<0>(parameters.param) == PlaneState::Strain ? "strain" : "stress",
                                 std::get<1>(parameters.param) ? "Inclined" : "Straight");
                         });

// An initial stress that jumps between metals: K_initial, from rings that hold both.
TEST(SeveralMaterials, AnInitialStressThatJumpsCloseToATip) {
    const auto K_initial = [](double size) {
        Case input = close_to_another(size, PlaneState::Strain, false, 100e3);
        input.initial_stress.emplace().sigma_y = StressProfile{{0.0, 0.5, 1.0}, {20.0, -20.0, 20.0}};
        input.regions[0].initial_stress = MisfitStress{.xx = 15.0, .yy = -30.0};
        return coarse::solve_nominal(coarse::refined_scene(input)).tips[0].K_initial;
    };
    const double fine = K_initial(0.0005);
    EXPECT_NEAR(K_initial(0.02), fine, 0.005 * std::abs(fine));
}

/// The zone's share in rings across metals is that of the structure.
TEST(SeveralMaterials, AZoneTellsTheKOfBoth) {
    for (const bool initially : {false, true}) {
        Case input = close_to_another(0.02, PlaneState::Strain, true, 100e3);
        input.material.yield_stress = input.regions[0].material.yield_stress = 1e6;
        input.fine.radius = 0.05;
        input.load = {.steps = 2, .blocks = {{.cycles = 0, .max = 100.0, .min = 0.0}}};
        if (initially) input.regions[0].initial_stress = MisfitStress{.xx = 15.0, .yy = -30.0};
        const RunHistory history = run_direct(input);
        const Followed& last = history.increments.back();
        EXPECT_GT(last.zone.points, 100);
        const coarse::TipResult whole = ElasticSolution(input).tips[0];
        EXPECT_NEAR(last.tips[0].K_I, 100.0 * whole.K_I + whole.K_initial, 1e-3 * last.tips[0].K_I);
    }
}

}  // namespace
}  // namespace stria::test
