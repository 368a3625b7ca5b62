// What `stria check` says of the work that a run will be.
#include "coarse/advice/work_estimate.hpp"

#include <gtest/gtest.h>

#include "coarse/specimen/specimen.hpp"
#include "tests/support/load_cases.hpp"
#include "tests/support/specimens.hpp"

namespace stria::test {
namespace {

class Work : public testing::Test {
protected:
    Work() {
        input.mesh.width = 20.0;
        input.mesh.size = 1.0;
        input.material.yield_stress = 300.0;
        input.load.steps = 10;
        input.boundaries = {at_end("top", End::Pulled, 1.0), at_end("bottom", End::Pulled, -1.0)};
    }
    /// With half cycles to these load factors.
    [[nodiscard]] coarse::WorkEstimate between(double max, double min, int cycles = 1) {
        return of({{.cycles = cycles, .max = max, .min = min}});
    }
    [[nodiscard]] coarse::WorkEstimate of(std::vector<LoadBlock> blocks) {
        input.load.blocks = std::move(blocks);
        const coarse::Scene scene =
            coarse::make_scene(input, BodyMesh(coarse::make_mesh(input.mesh, input.cracks, input.regions)));
        const coarse::NominalSolution nominal = coarse::solve_nominal(scene);
        const std::vector<double> K = coarse::largest_K(input, coarse::unit_response(nominal));
        return coarse::estimate_work(scene, nominal, K, increment);
    }
    double increment = 0.1;  // of growth, mm
    Case input = specimen("plate", 20.0, {{0.0, 10.3}, {8.3, 10.3}});
};

TEST_F(Work, IsThatOfThePointsThatFlow) {
    const coarse::WorkEstimate little = between(20.0, 0.0, 100), much = between(400.0, 0.0, 100);
    EXPECT_GT(little.yielding, 0);
    EXPECT_LT(little.yielding, 0.2 * little.points);
    EXPECT_GT(much.yielding, 0.7 * much.points) << "400 MPa on a metal of 300, but beside the faces";
    EXPECT_GT(much.seconds, 5.0 * little.seconds);
}

// Where little flows two of five points are looked at in an iteration; what flows does not rest.
TEST_F(Work, LooksAtAllThatFlows) {
    input.mesh.size = 0.25;    // many points: what an iteration takes besides is little
    input.fine.radius = 40.0;  // all of the body
    const auto of_a_point = [&](double max) {
        const coarse::WorkEstimate work = between(max, 0.0, 100);
        return work.seconds / (0.13 * work.points + 0.4 * work.yielding);  // a point that flows takes as much more
    };
    EXPECT_GT(of_a_point(400.0), 1.4 * of_a_point(100.0));
}

// Seven iterations for each, beside 0.2 of a set-up.
TEST_F(Work, OfGrowthIsAlsoThatOfTheFacesItOpens) {
    const auto of_growth = [&](double max) {
        input.growth.reset();
        const double still = between(max, 0.0, 10).seconds;
        input.growth = GrowthSection{.increment = 0.1};
        return between(max, 0.0, 10).seconds - still;
    };
    EXPECT_GT(of_growth(400.0), 1.5 * of_growth(1.0)) << "what flows has more to do";
}

// At the largest load nothing is left of eq. (3), for the load closes the crack.
TEST_F(Work, SeesWhatCompressionDoes) {
    const coarse::WorkEstimate pulled = between(400.0, 0.0), pushed = between(0.0, -400.0);
    EXPECT_GT(pushed.yielding, 0);
    EXPECT_EQ(pushed.yielding, pulled.yielding);
}

// 250 MPa, be 200 of them a dead load: the boundary was to go all of the way beyond that.
TEST_F(Work, OfADisplacementBesideADeadLoadIsThatOfBoth) {
    const coarse::WorkEstimate by_load = between(250.0, 0.0);
    ASSERT_GT(by_load.yielding, 0);
    const coarse::Scene scene =
        coarse::make_scene(input, BodyMesh(coarse::make_mesh(input.mesh, input.cracks, input.regions)));
    const double moved = 250.0 * coarse::unit_response(coarse::solve_nominal(scene)).displacement.mean;
    input.load.control = Control::Displacement;
    for (const bool beside : {false, true}) {
        if (beside) {
            input.load_cases = {dead_load("dead", 200.0)};
            input.boundaries.push_back(pulled_in_case("dead", "top", {0.0, 1.0}));
            input.boundaries.push_back(pulled_in_case("dead", "bottom", {0.0, -1.0}));
        }
        const coarse::WorkEstimate by_displacement = between(moved, 0.9 * moved);
        EXPECT_EQ(by_displacement.yielding, by_load.yielding) << beside;
        EXPECT_EQ(by_displacement.points, by_load.points) << beside;
    }
}

TEST_F(Work, GrowsWithTheHistory) {
    const coarse::WorkEstimate one = between(100.0, 0.0), thousand = between(100.0, 0.0, 1000);
    EXPECT_EQ(one.increments, 15.0);
    EXPECT_EQ(thousand.increments, 10005.0);
    EXPECT_EQ(thousand.yielding, one.yielding);
    EXPECT_GT(thousand.seconds, 300.0 * one.seconds);
    input.material.yield_stress.reset();
    EXPECT_EQ(between(400.0, 0.0).yielding, 0);
}

// A growth of 0.5 mm in each of 20 cycles, but the crack is as long as it is to be after 1.7 mm. In as many cycles as
// are wanted it would have left the body after 11.7 mm.
TEST_F(Work, EndsWithTheCrack) {
    increment = 0.5;
    input.growth = GrowthSection{.increment = increment};
    EXPECT_EQ(between(100.0, 0.0, 20).growths, 20.0);
    const coarse::WorkEstimate of_all = between(100.0, 0.0, 100);
    EXPECT_EQ(of_all.growths, 24.0);
    EXPECT_EQ(of_all.increments, 255.0);
    input.growth->until = 10.0;
    const coarse::WorkEstimate of_few = between(100.0, 0.0, 100);
    EXPECT_EQ(of_few.growths, 4.0);
    EXPECT_EQ(of_few.increments, 55.0);
    input.growth->increment = {};
    EXPECT_EQ(between(100.0, 0.0, 100).growths, 4.0) << "chosen by the program";
    input.growth->until = 60.0;
    EXPECT_EQ(between(100.0, 0.0, 100).increments, of_all.increments);
}

// A quarter of the points, and as many unknowns whose fronts are factored anew.
TEST_F(Work, IsThatOfTheUnknownsToo) {
    const coarse::WorkEstimate many = between(400.0, 0.0, 100);
    input.fine.subcells = 1;
    const coarse::WorkEstimate few = between(400.0, 0.0, 100);
    EXPECT_NEAR(4.0 * few.points, many.points, 0.1 * many.points) << "cut elements have others";
    EXPECT_GT(few.seconds, 0.4 * many.seconds);
}

// 4 x 256 x 256 in each of 10 000 elements: more than a number of 32 bits holds.
TEST_F(Work, CountsMorePointsThanAWholeNumberHolds) {
    input.mesh.size = 0.2;
    input.fine.subcells = 256;
    input.fine.beta = 1e-4;  // the zone itself is small, or the memory for it would be missed first
    const coarse::WorkEstimate work = between(4000.0, 0.0);
    EXPECT_GT(work.yielding, 2.5e9);
    EXPECT_GE(work.points, work.yielding);
}

// Flow is returned in closed form there.
TEST_F(Work, OfLinearHardeningInPlaneStrainIsLess) {
    input.mesh.size = 0.5;
    input.material.kinematic = {{.C = 4000.0}};
    const double exact = between(400.0, 0.0, 100).seconds;
    input.material.kinematic[0].gamma = 10.0;
    const double in_parts = between(400.0, 0.0, 100).seconds;
    EXPECT_GT(in_parts, 1.4 * exact);
    input.material.kinematic.clear();
    input.model.plane = PlaneState::Stress;
    EXPECT_GT(between(400.0, 0.0, 100).seconds, 1.4 * exact);
}

// Chosen ones that press faces together are 32 a cycle, and about 60 once they are measured.
TEST_F(Work, TakesMoreIncrementsIntoCompression) {
    input.load.steps = {};
    const double opened = between(100.0, 0.0, 4).increments;
    EXPECT_EQ(between(100.0, -100.0, 4).increments, opened) << "no faces that could touch";
    input.cracks[0].contact = ContactSection{};
    EXPECT_EQ(between(100.0, 0.0, 4).increments, opened);
    EXPECT_EQ(opened, 54.0);
    EXPECT_EQ(between(100.0, -100.0, 4).increments, 6.0 + 4 * 32.0);
    EXPECT_EQ(between(100.0, -100.0, 14).increments, 6.0 + 4 * 32.0 + 10 * 60.0);
}

// The crack runs along the body, and what is far of it lies on its way: the tangents there are full matrices, as long
// as they spare work. Along nearly all of the body they would take three times what the body takes.
TEST_F(Work, OfALongCrackIsThatOfItsRim) {
    input.mesh.width = 10.0;
    input.mesh.height = 2000.0;
    const auto body_with = [&](double length) {
        input.cracks[0].points = {{5.3, 2000.0}, {5.3, 2000.0 - length}};
        return coarse::make_scene(input, BodyMesh(coarse::make_mesh(input.mesh, input.cracks, input.regions)));
    };
    const coarse::Scene brief = body_with(10.0), longer = body_with(200.0), along = body_with(1900.0);
    EXPECT_LT(along.enriched.unknowns, 1.3 * brief.enriched.unknowns);
    EXPECT_GT(coarse::bytes_of_body(longer), 1.05 * coarse::bytes_of_body(brief));
    EXPECT_LT(coarse::seconds_of_body(along), 1.3 * coarse::seconds_of_body(brief));
    EXPECT_LT(coarse::bytes_of_body(along), 1.3 * coarse::bytes_of_body(brief));
}

// One of sixty cycles flows over all of the body: the others take what they take without it, and the memory is its own.
TEST_F(Work, OfARareOverloadIsNotThatOfAllCycles) {
    input.mesh.size = 0.5;
    const coarse::WorkEstimate without = between(60.0, 0.0, 60);
    const LoadBlock usual{.cycles = 30, .max = 60.0, .min = 0.0}, overload{.cycles = 1, .max = 400.0, .min = 0.0};
    const coarse::WorkEstimate with = of({usual, overload, usual});
    EXPECT_GT(with.yielding, 3.0 * without.yielding);
    EXPECT_GT(with.bytes, 1.1 * without.bytes);
    EXPECT_LT(with.seconds, 0.8 * between(400.0, 0.0, 60).seconds);
}

// Points and elements that the way adds, and of an elastic body the second factor that is made beside the first.
TEST_F(Work, KeepsWhatTheCracksLeaveBehind) {
    increment = 0.25;
    const coarse::WorkEstimate still = between(60.0, 0.0, 20);
    EXPECT_EQ(still.at_end.points, still.points);
    input.growth = GrowthSection{.increment = increment};
    const coarse::WorkEstimate grown = between(60.0, 0.0, 20);
    EXPECT_EQ(grown.points, still.points);
    EXPECT_GT(grown.at_end.points, 1.3 * grown.points);
    const double added = grown.at_end.points - grown.points;
    EXPECT_GT(grown.bytes, still.bytes + 650.0 * added);
    input.material.yield_stress.reset();
    EXPECT_GT(between(60.0, 0.0, 20).bytes, 1.01 * between(60.0, 0.0, 1).bytes);
}

// Of a body that answers in proportion an increment is a row; load cases ask for displacements and rings.
TEST_F(Work, OfACycleThatFollowsFromTheUnitLoadIsNextToNothing) {
    input.material.yield_stress.reset();
    input.load.steps = 2;
    const auto of_a_cycle = [&] { return (between(20.0, 0.0, 1000).seconds - between(20.0, 0.0, 1).seconds) / 999.0; };
    const double in_proportion = of_a_cycle();
    input.load_cases = {dead_load("dead", 1.0)};
    input.boundaries.push_back(pulled_in_case("dead", "top", {0.0, 1.0}));
    input.boundaries.push_back(pulled_in_case("dead", "bottom", {0.0, -1.0}));
    EXPECT_GT(of_a_cycle(), 3.0 * in_proportion);
}

TEST_F(Work, KeepsTheTurnsOfAllCycles) {
    input.load.blocks = {{.cycles = 1, .max = 1.0, .min = 0.0}};
    const auto bytes = [&] {
        return coarse::bytes_of_body(
            coarse::make_scene(input, BodyMesh(coarse::make_mesh(input.mesh, input.cracks, input.regions))));
    };
    const double of_one = bytes();
    input.load.blocks[0].cycles = 10'000'000;
    EXPECT_GT(bytes(), of_one + 1e9);
}

}  // namespace
}  // namespace stria::test
