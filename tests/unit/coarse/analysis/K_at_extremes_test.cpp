// K of the tips at the extremes of a cycle: of one load and of several, and what faces that touch make of it.
#include "coarse/analysis/K_at_extremes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "coarse/zone/refined_scene.hpp"
#include "tests/support/load_cases.hpp"
#include "tests/support/pulled_plate.hpp"

namespace stria::coarse {
namespace {

const Note quiet = [](const std::string&) {};

/// A crack that is slanted, so that both modes are there.
Case slanted(bool contact = true) {
    Case input = test::pulled_plate(1.0, false, contact);
    input.cracks[0].points[1].y() = 11.9;
    input.load.blocks = {{.cycles = 1, .max = 60.0, .min = 0.0}};
    return input;
}

class KAtExtremes : public testing::Test {
protected:
    explicit KAtExtremes(const Case& input = slanted())
        : scene(refined_scene(input)), body(scene, effort, quiet, nullptr), unit(body.nominal().at(0)) {}

    static ReachedExtremes between(double maximum, double minimum) {
        ReachedExtremes reached;
        reached.maximum.main = maximum;
        reached.minimum.main = minimum;
        return reached;
    }
    [[nodiscard]] double K_maximum(const ReachedExtremes& reached) const { return K_at_maximum(body, reached)[0].K_I; }

    CoarseEffort effort;
    Scene scene;
    CrackedBody body;
    TipResult unit;
};

TEST_F(KAtExtremes, OfOneLoadHasItsSignAlone) {
    EXPECT_EQ(K_maximum(between(60.0, -90.0)), unit.K_I);
    EXPECT_EQ(K_maximum(between(-6.0, -90.0)), -unit.K_I);
    EXPECT_EQ(K_maximum(between(0.0, -90.0)), -unit.K_I) << "that of the minimum";
    EXPECT_EQ(K_maximum(between(1e-12, -90.0)), -unit.K_I) << "rounding of a load that is found";
    EXPECT_EQ(K_at_maximum(body, between(-6.0, -90.0))[0].K_II, -unit.K_II);
    const std::vector<TipResult> none = K_at_minimum(body, between(60.0, -90.0));
    ASSERT_EQ(none.size(), 1U);
    EXPECT_EQ(none[0].K_I, 0.0);
    EXPECT_EQ(none[0].K_II, 0.0);
}

// Next to nothing is what is small beside the K of both extremes.
TEST_F(KAtExtremes, ThatIsMeasuredTurnsATipUnlessItIsNextToNothing) {
    ReachedExtremes reached = between(1.0, -60.0);
    EXPECT_EQ(K_that_turns(body, reached)[0].K_I, unit.K_I) << "nothing is measured";
    const double K = std::hypot(unit.K_I, unit.K_II);
    for (const auto& [share, turns] : {std::pair{0.29, false}, {0.31, true}}) {  // of 60 K, 0.5 %
        reached.tips = {{.K_I = share * K, .K_II = 0.01, .contact_length = 1.0}};
        EXPECT_EQ(K_that_turns(body, reached)[0].K_I, turns ? share * K : unit.K_I);
    }
    reached.tips[0].contact_length = 0.0;
    EXPECT_EQ(K_that_turns(body, reached)[0].K_I, unit.K_I) << "no faces touch";
}

// A crack that is pressed and let go: at the maximum no load is left, and nothing of K but what friction has kept.
TEST_F(KAtExtremes, ThatIsMeasuredAtTheMinimumTurnsATipWhoseLoadIsLargestThere) {
    ReachedExtremes reached = between(0.0, -60.0);
    EXPECT_EQ(K_that_turns(body, reached)[0].K_II, -unit.K_II) << "nothing is measured";
    reached.tips = {{.K_I = 1.0, .K_II = 2.0, .contact_length = 1.0}};
    reached.tips_at_minimum = {{.K_I = 30.0, .K_II = -20.0, .contact_length = 1.0}};
    EXPECT_EQ(K_that_turns(body, reached)[0].K_I, 30.0);
    EXPECT_EQ(K_that_turns(body, reached)[0].K_II, -20.0);
    reached.tips_at_minimum[0].rings_flow = true;
    reached.faces_at_minimum = {
        .crack = {0, 0}, .s = {0.0, 20.0}, .pressure = {4.0, 4.0}, .shear = {2.0, 2.0}, .in_wake = {0, 0}};
    const TipResult of_faces = body.K_of_faces(reached.minimum, reached.faces_at_minimum)[0];
    EXPECT_DOUBLE_EQ(K_that_turns(body, reached)[0].K_II, -60.0 * unit.K_II + of_faces.K_II);
    reached.maximum.main = -2.0;
    EXPECT_DOUBLE_EQ(K_that_turns(body, reached)[0].K_II, -60.0 * unit.K_II + of_faces.K_II);
    reached.maximum.main = 1.0;
    reached.tips[0].K_I = 50.0;
    EXPECT_EQ(K_that_turns(body, reached)[0].K_I, 50.0) << "the maximum has a load";
}

// Of a pressure that opens the crack and a shear: K of the loads with that of the faces.
TEST_F(KAtExtremes, OfRingsThatAllHoldFlowIsThatOfLoadsAndFaces) {
    ReachedExtremes reached = between(60.0, 0.0);
    reached.tips = {
        {.K_I = 70.0, .K_II = 8.0, .K_I_of_wake = 5.0, .K_II_of_wake = 6.0, .rings_flow = true, .contact_length = 1.0}};
    EXPECT_EQ(K_that_turns(body, reached)[0].K_I, unit.K_I) << "nobody tells";
    reached.faces = {.crack = {0, 0}, .s = {0.0, 20.0}, .pressure = {4.0, 4.0}, .shear = {2.0, 2.0}, .in_wake = {0, 0}};
    const TipResult of_faces = body.K_of_faces(reached.maximum, reached.faces)[0];
    ASSERT_GT(std::abs(of_faces.K_II), 0.1);
    const TipResult turns = K_that_turns(body, reached)[0];
    EXPECT_DOUBLE_EQ(turns.K_I, 60.0 * unit.K_I + of_faces.K_I);
    EXPECT_DOUBLE_EQ(turns.K_II, 60.0 * unit.K_II + of_faces.K_II);
    reached.tips[0].rings_flow = false;
    EXPECT_EQ(K_that_turns(body, reached)[0].K_I, 70.0 - 5.0) << "a ring tells, but for the wake";
}

TEST(ReachedExtremes, HaveTheFacesWhereTheyTouchAndNoRingTells) {
    const LoadFactors loads(60.0);
    Increment reached;
    reached.zone.faces = {{.crack = 0, .s = 1.0, .pressure = 3.0, .status = 1}};
    for (const bool touches : {true, false}) {
        for (const bool flows : {true, false}) {
            reached.tips = {{.K_I = 7.0, .rings_flow = flows, .contact_length = touches ? 1.0 : 0.0}};
            ReachedExtremes extremes;
            note_maximum(extremes, loads, reached);
            EXPECT_EQ(extremes.maximum.main, 60.0);
            EXPECT_EQ(extremes.tips.at(0).K_I, 7.0);
            EXPECT_EQ(extremes.faces.s.size(), touches && flows ? 1U : 0U);
            note_minimum(extremes, LoadFactors(-60.0), reached);
            EXPECT_EQ(extremes.minimum.main, -60.0);
            EXPECT_EQ(extremes.tips_at_minimum.at(0).K_I, 7.0);
            EXPECT_EQ(extremes.faces_at_minimum.s.size(), touches && flows ? 1U : 0U);
        }
    }
}

class KOfSeveralLoads : public KAtExtremes {
protected:
    static Case with_dead_load() {
        Case input = slanted();
        input.load_cases = {test::dead_load("dead", 5.0)};
        for (const double side : {1.0, -1.0})
            input.boundaries.push_back(
                test::pulled_in_case("dead", side > 0 ? "top" : "bottom", Vec2(0.0, 2.0 * side)));
        return input;
    }
    KOfSeveralLoads() : KAtExtremes(with_dead_load()) {}
};

TEST_F(KOfSeveralLoads, IsThatOfAllTogetherAtEitherExtreme) {
    ReachedExtremes reached = between(60.0, -90.0);
    reached.maximum.cases = reached.minimum.cases = Eigen::VectorXd::Constant(1, 5.0);
    EXPECT_NEAR(K_maximum(reached), (60.0 + 10.0) * unit.K_I, 1e-9 * 60.0 * unit.K_I);
    EXPECT_NEAR(K_at_minimum(body, reached)[0].K_I, (-90.0 + 10.0) * unit.K_I, 1e-9 * 60.0 * unit.K_I);
}

class KBesideAnInitialStress : public KAtExtremes {
protected:
    static Case with_stress() {
        Case input = slanted();
        const StressProfile along_x{.at = {0.0, 10.0, 20.0}, .stress = {30.0, -30.0, 30.0}};
        input.initial_stress = InitialStressSection{.sigma_x = {}, .sigma_y = along_x, .file = {}, .grid = {}};
        return input;
    }
    KBesideAnInitialStress() : KAtExtremes(with_stress()) {}
};

TEST_F(KBesideAnInitialStress, IsThatOfBothAtEitherExtreme) {
    ASSERT_GT(std::abs(unit.K_initial), 1.0);
    const ReachedExtremes reached = between(60.0, -90.0);
    EXPECT_DOUBLE_EQ(K_maximum(reached), 60.0 * unit.K_I + unit.K_initial);
    EXPECT_DOUBLE_EQ(K_at_minimum(body, reached)[0].K_I, -90.0 * unit.K_I + unit.K_initial);
}

}  // namespace
}  // namespace stria::coarse
