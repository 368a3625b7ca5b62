// A start that a predictor says is given up, or stayed with, in all modes alike: by what the nodes feel.
#include <gtest/gtest.h>

#include <tuple>

#include "app/run/fine_side.hpp"
#include "app/run/monolithic/monolithic.hpp"
#include "coarse/equilibrium/condensed/condensed_factory.hpp"
#include "tests/support/sent_analysis.hpp"
#include "tests/support/specimens.hpp"

namespace stria::test {
namespace {

/// The crack has grown around a bend, and the faces behind it slide: what was so a cycle ago misleads. Condensed onto
/// Gamma the fourth state from there is 1.4 times the forces away from equilibrium. At its nodes it is 0.06 of them.
Case plate_with_a_bent_crack() {
    Case input = specimen("plate", 20.0, {{0.0, 9.29014}, {2.67554, 10.1566}, {4.17554, 9.91944}});
    input.mesh.width = 10.0;
    input.material.yield_stress = 161.59775;
    input.material.isotropic = {.law = HardeningLaw::Power, .n = 10.83, .alpha = 0.8415};
    input.cracks[0].contact = ContactSection{0.407};
    const double shear = -0.0144259;
    for (const auto& [edge, traction] :
         {std::tuple{"top", Vec2(shear, 1.0)}, std::tuple{"bottom", Vec2(-shear, -1.0)},
          std::tuple{"right", Vec2(0.0, shear)}, std::tuple{"left", Vec2(0.0, -shear)}}) {
        input.boundaries.emplace_back().on = edge;
        input.boundaries.back().traction = traction;
    }
    input.load.steps = 4;
    input.load.grading = 0.6;
    input.load.blocks = {{.cycles = 2, .max = 52.6143, .min = -0.666 * 52.6143}};
    input.fine.radius = 1.38;
    input.growth = GrowthSection{.increment = 0.265};
    input.solver.tolerance = 1e-12;
    return input;
}

/// Of the states that a predictor led to first: where nothing was known all modes begin with other ones.
std::vector<coarse::NewtonIteration> predicted(const coarse::NewtonReport& report) {
    return report.was_misled() ? report.lost : report.iterations;
}

void expect_same_starts(const RunHistory& one, const RunHistory& other) {
    constexpr double rounding = 1e-9;
    ASSERT_EQ(other.attempts.size(), one.attempts.size());
    for (std::size_t k = 0; k < one.attempts.size(); ++k) {
        const coarse::NewtonReport &a = one.attempts[k].second, &b = other.attempts[k].second;
        EXPECT_EQ(a.converged, b.converged) << "attempt " << k;
        ASSERT_EQ(a.was_misled(), b.was_misled()) << "attempt " << k;
        const auto first = predicted(a), second = predicted(b);
        for (std::size_t i = 1; i < std::min({first.size(), second.size(), std::size_t{4}}); ++i) {
            const coarse::Residual &p = first[i].residual, &q = second[i].residual;
            if (p.closed != q.closed) break;  // a trial where faces are about to part: its pressure is rounding
            EXPECT_NEAR(p.scale, q.scale, rounding * p.scale);
            EXPECT_NEAR(p.largest_nodal(), q.largest_nodal(), rounding * std::max(p.scale, p.largest_nodal()))
                << "attempt " << k << ", state " << i;
        }
    }
}

TEST(PredictedStart, IsStayedWithInAllModesAlike) {
    const Case input = plate_with_a_bent_crack();
    const RunHistory condensed = run_direct(input);
    MonolithicFactory factory(input);
    expect_same_starts(condensed, run_analysis(input, factory));
    FineSide fine(input, 2);
    coarse::CondensedFactory shared(&fine.scale(), input);
    expect_same_starts(condensed, run_analysis(input, shared));
}

/// Elements of 0.77 mm and a zone of 1.9: about a tip that has grown it has nodes where it had none before, so that it
/// forgets its increments, while the whole mesh comes to lie on itself there and the structure keeps its own.
Case plate_with_a_zone_of_few_elements() {
    Case input = specimen("mt", 30.0, {{2.56531, 15.1}, {7.43469, 15.1}});
    input.mesh.width = 10.0;
    input.mesh.size = 0.7692;
    input.model.plane = PlaneState::Stress;
    input.material.young = 200e3;
    input.material.poisson = 0.0;
    input.material.yield_stress = 173.53;
    input.material.kinematic = {{.C = 38626.0, .gamma = 0.0}};
    for (const auto& [edge, pull] : {std::tuple{"top", 1.0}, std::tuple{"bottom", -1.0}}) {
        input.boundaries.emplace_back().on = edge;
        input.boundaries.back().traction = Vec2(0.0, pull);
    }
    input.load.steps = 4;
    input.load.blocks = {{.cycles = 2, .max = 78.2, .min = 0.0}};
    input.fine.enrichment = Enrichment::None;
    input.fine.radius = 1.904;
    input.growth = GrowthSection{.increment = 0.331, .direction = GrowthDirection::Straight};
    input.solver.tolerance = 1e-12;
    return input;
}

TEST(PredictedStart, OfAZoneThatForgetsItsIncrementsIsTheSameInOneMatrix) {
    const Case input = plate_with_a_zone_of_few_elements();
    const RunHistory condensed = run_direct(input);
    MonolithicFactory factory(input);
    expect_same_starts(condensed, run_analysis(input, factory));
    EXPECT_EQ(condensed.increments.size(), 12U);
}

}  // namespace
}  // namespace stria::test
