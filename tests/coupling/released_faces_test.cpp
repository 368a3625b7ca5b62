// A growing crack sends stress where no half cycle before has sent it: what rests in the zone is looked at in every
// iterate, so that two components go the same way as one matrix. What has flowed where it cuts stays dissipated.
#include <gtest/gtest.h>

#include "app/run/fine_side.hpp"
#include "app/run/monolithic/monolithic.hpp"
#include "coarse/equilibrium/condensed/condensed_factory.hpp"
#include "tests/support/pulled_plate.hpp"
#include "tests/support/sent_analysis.hpp"
#include "tests/support/specimens.hpp"

namespace stria::test {
namespace {

/// Four increments to a cycle, and growth at each of two maxima.
Case growing_twice(Case input, double max, double min, double radius, double increment) {
    input.load.steps = 4;
    input.load.blocks = {{.cycles = 2, .max = max, .min = min}};
    input.fine.radius = radius;
    input.growth = GrowthSection{.increment = increment};
    input.solver.tolerance = 1e-12;
    return input;
}

/// Near its limit load; the crack grows twice by most of a large element.
Case plate_near_its_limit() {
    Case input = pulled_plate(2.0, true, false);
    input.material.kinematic = {{.C = 10e3, .gamma = 0.0}};
    input.fine.refine = 2;
    return growing_twice(input, 120.0, 0.0, 3.0, 0.9);
}

/// Inclined, without contact. Nothing flows in the second cycle, so all rests when the crack grows again.
Case plate_at_rest() {
    Case input = specimen("sent", 20.0, {{0.0, 10.4111}, {2.04564, 11.004}, {3.54564, 11.0332}});
    input.mesh.width = 10.0;
    input.mesh.size = 0.9091;
    input.material.poisson = 0.0;
    input.material.yield_stress = 374.47646;
    input.material.isotropic = {.law = HardeningLaw::Linear, .modulus = 1000.0};
    input.material.kinematic = {{.C = 3407.0, .gamma = 0.0}};
    input.boundaries = {at_end("top", End::Pulled, 1.0), at_end("bottom", End::Pulled, -1.0)};
    return growing_twice(input, 82.2925, 25.84, 1.702, 0.252);
}

/// Two forces near the other edge open the tip and press the faces at the mouth together, all the time.
Case plate_that_is_bent() {
    Case input = specimen("plate", 20.0, {{0.0, 8.9}, {3.0, 9.7}});
    input.mesh.width = 10.0;
    input.material.yield_stress = 360.0;
    input.cracks[0].contact = ContactSection{};
    for (const double side : {1.0, -1.0}) {
        BoundarySection pulled;
        pulled.on = "point";
        pulled.at = Vec2(8.0, 11.0 + 6.0 * side);
        pulled.force = Vec2(0.0, 6.0 * side);
        input.boundaries.push_back(pulled);
    }
    input.fine.refine = 2;
    return growing_twice(input, 40.0, 12.0, 1.8, 0.52);
}

/// Two metals: of two ranks the one that the crack does not cross has points on the yield surface when it grows.
Case plate_of_two_metals() {
    Case input = specimen("sent", 20.0, {{0.0, 8.03855}, {2.26393, 8.50924}, {3.76393, 8.6352}});
    input.mesh.width = 10.0;
    input.mesh.size = 0.9091;
    input.material.yield_stress = 313.0;
    input.material.isotropic = {.law = HardeningLaw::Power, .n = 4.522, .alpha = 0.9854};
    input.regions = {
        {.outline = {{5.8, -1.0}, {20.0, -1.0}, {20.0, 31.0}, {1.8, 31.0}}, .material = {}, .initial_stress = {}}};
    input.regions[0].material.young = 70e3;
    input.regions[0].material.poisson = 0.0;
    input.cracks[0].contact = ContactSection{};
    input.boundaries = {at_end("top", End::Pulled, 1.0), at_end("bottom", End::Pulled, -1.0)};
    input.fine.refine = 2;
    return growing_twice(input, 80.0, 24.0, 1.462, 0.318);
}

/// Each with a rank of its own. They grow where the faces of both press.
Case plate_with_two_cracks() {
    Case input = specimen("plate", 20.0, {{0.0, 9.87475}, {3.08922, 9.97591}, {4.58922, 10.3991}});
    input.cracks.push_back({.points = {{10.0, 16.0622}, {7.74967, 15.6426}}, .contact = {}});
    for (CrackSection& crack : input.cracks) crack.contact = ContactSection{};
    input.mesh.width = 10.0;
    input.mesh.size = 0.8333;
    input.material.yield_stress = 253.0;
    input.material.isotropic = {.law = HardeningLaw::Linear, .modulus = 1000.0};
    input.boundaries = {at_end("top", End::Pulled, 1.0), at_end("bottom", End::Pulled, -1.0)};
    input.fine.refine = 2;
    Case growing = growing_twice(input, 42.4, 1.2, 1.551, 0.173);
    growing.growth->at = GrowthAt::Minimum;
    return growing;
}

/// Linear, each crack with a rank of its own, and faces of the slower one come apart when the other one grows.
Case plate_with_a_crack_that_waits() {
    Case input = specimen("plate", 20.0, {{0.0, 8.7}, {5.733, 7.947}});
    input.cracks.push_back({.points = {{20.0, 14.448}, {11.873, 12.0}}, .contact = {}});
    for (CrackSection& crack : input.cracks) crack.contact = ContactSection{};
    input.mesh.width = 20.0;
    input.mesh.size = 0.8;
    input.boundaries = {at_end("top", End::Pulled, 1.0), at_end("bottom", End::Pulled, -1.0)};
    Case growing = growing_twice(input, 55.69, 0.0, 0.0, 0.6);
    growing.load.blocks[0].cycles = 6;
    growing.growth->law = GrowthLaw::Paris;
    growing.growth->C = 1e-12;
    growing.growth->m = 3.0;
    growing.growth->threshold = 300.0;
    return growing;
}

/// Calls visit(iterations of one, of two) of each release.
template <class Visit> void for_each_release(const RunHistory& one, const RunHistory& two, Visit&& visit) {
    ASSERT_EQ(two.attempts.size(), one.attempts.size());
    for (std::size_t k = 0; k < one.attempts.size(); ++k) {
        const auto& [step, report] = one.attempts[k];
        if (step.reversal && !step.ends_cycle) visit(report.iterations, two.attempts[k].second.iterations);
    }
}

/// They begin with the same state, end with the same one behind as many iterates, and release the same.
void expect_same_releases(const RunHistory& one, const RunHistory& two) {
    for_each_release(one, two, [](const auto& iterations, const auto& others) {
        ASSERT_EQ(others.size(), iterations.size());
        EXPECT_EQ(others.front().residual.yielding_points, iterations.front().residual.yielding_points);
        EXPECT_EQ(others.back().residual.yielding_points, iterations.back().residual.yielding_points);
    });
    ASSERT_EQ(two.increments.size(), one.increments.size());
    const double scale = one.increments.back().work.released;
    EXPECT_GT(scale, 0.0);
    for (std::size_t k = 0; k < one.increments.size(); ++k)
        EXPECT_NEAR(two.increments[k].work.released, one.increments[k].work.released, 1e-9 * scale) << k;
}

void expect_same_iterates(const RunHistory& one, const RunHistory& two) {
    expect_same_releases(one, two);
    for_each_release(one, two, [](const auto& iterations, const auto& others) {
        for (std::size_t i = 0; i < iterations.size(); ++i)
            EXPECT_EQ(others[i].residual.yielding_points, iterations[i].residual.yielding_points);
    });
}

void expect_same_iterates(const Case& input) {
    MonolithicFactory factory(input);
    expect_same_iterates(run_analysis(input, factory), run_direct(input));
}

// Each rank has its own elements at rest, and soft jumps beside these are left to Newton's method: iterates between the
// first and the last differ.
void expect_same_releases_of_ranks(const Case& input, int ranks) {
    FineSide fine(input, ranks);
    coarse::CondensedFactory factory(&fine.scale(), input);
    expect_same_releases(run_direct(input), run_analysis(input, factory));
}

TEST(ReleasedFaces, TakeTheSameIteratesInTwoComponentsAsInOneMatrix) { expect_same_iterates(plate_near_its_limit()); }

// Forces on new faces are loads, and what bears a load does not rest.
TEST(ReleasedFaces, DoNotRestWhileForcesHoldThem) { expect_same_iterates(plate_at_rest()); }

// Old faces that press and come to rest do so closed: they had been open until one of them was looked at.
TEST(ReleasedFaces, RestBesideOthersThatPress) {
    const Case input = plate_that_is_bent();
    expect_same_iterates(input);
    int closed = 0;
    const RunHistory run = run_direct(input);
    for (const auto& [step, report] : run.attempts) {
        if (step.reversal && !step.ends_cycle) {
            EXPECT_EQ(report.iterations.front().residual.closed, closed);
            EXPECT_GT(closed, 3);
        }
        closed = report.iterations.back().residual.closed;
    }
}

// Loads are held while faces open, with all ranks: where a rank took that for an increment like others it counted what
// pressures do by a trapezoid, and 0.3 % of the work of the loads was gone.
TEST(ReleasedFaces, DoNoWorkByTrapezoidsWithRanksBeside) {
    const Case input = plate_with_a_crack_that_waits();
    FineSide fine(input, 2);
    coarse::CondensedFactory factory(&fine.scale(), input);
    const RunHistory one = run_direct(input), two = run_analysis(input, factory);
    ASSERT_EQ(two.increments.size(), one.increments.size());
    const double scale = one.increments.back().work.external;
    EXPECT_GT(one.increments.back().work.released, 0.1 * scale);
    for (std::size_t k = 0; k < one.increments.size(); ++k)
        EXPECT_NEAR(two.increments[k].work.external, one.increments[k].work.external, 1e-9 * scale) << k;
}

// Nothing has moved when a release begins, and nothing else says to a rank which opens no faces that it has begun: what
// lies on the yield surface there is not to flow by what the last increment has left out of balance.
TEST(ReleasedFaces, BeginAndEndAlikeOnRanksBeside) {
    for (const int ranks : {2, 3}) expect_same_releases_of_ranks(plate_of_two_metals(), ranks);
}

TEST(ReleasedFaces, OfTwoCracksReleaseTheSameOnTwoRanks) { expect_same_releases_of_ranks(plate_with_two_cracks(), 2); }

// Their points weigh more or less than before the crack was there.
TEST(ReleasedFaces, TakeNothingOfWhatHasBeenDissipated) {
    Case input = pulled_plate(1.0, true, true);
    input.load.steps = 6;
    input.load.blocks = {{.cycles = 3, .max = 45.0, .min = 0.0}};
    input.fine.radius = 2.5;
    input.growth = GrowthSection{.increment = 0.45};
    const RunHistory run = run_direct(input);
    double before = 0.0;
    for (const Followed& now : run.increments) {
        EXPECT_GE(now.work.dissipated, before) << "increment " << now.number;
        before = now.work.dissipated;
    }
    EXPECT_GT(before, 0.0);
}

}  // namespace
}  // namespace stria::test
