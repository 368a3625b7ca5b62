// The body with its present cracks: what serves again as they grow, and what a longer crack changes.
#include "coarse/analysis/cracked_body.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "coarse/analysis/K_at_extremes.hpp"
#include "coarse/zone/refined_scene.hpp"
#include "coarse/zone/zone_selection.hpp"
#include "tests/support/pulled_plate.hpp"

namespace stria::coarse {
namespace {

const Note silent = [](const std::string&) {};

class CrackedBodyOf : public testing::Test {
protected:
    static Case pulled(bool plastic) {
        Case input = test::pulled_plate(0.5, plastic, false);
        input.load.blocks = {{.cycles = 1, .max = 60.0, .min = 0.0}};
        return input;
    }
    static std::unique_ptr<Scene> longer(const CrackedBody& body, double by) {
        Case input = body.scene().input;
        input.cracks[0].points.back().x() += by;
        return std::make_unique<Scene>(make_scene(input, body.scene().mesh));
    }
    /// Figure 3 (a).
    static void grow(CrackedBody& body, double by) {
        std::unique_ptr<Scene> scene = longer(body, by);
        const ElementSet zone =
            body.zone_about(*scene, body.zone_expected_about(*scene, body.zone_with_changes(*scene)));
        body.take(std::move(scene), nullptr);
        body.condense_onto(zone);
    }

    CoarseEffort effort;
};

TEST_F(CrackedBodyOf, ElasticFreeFacesHasNoZone) {
    const Scene scene = refined_scene(pulled(false));
    const CrackedBody body(scene, effort, silent, nullptr);
    EXPECT_FALSE(body.has_zone());
    EXPECT_TRUE(body.structure().in_zone().none());
    EXPECT_DOUBLE_EQ(body.nominal().at(0).K_I, solve_nominal(scene).tips.at(0).K_I);
    const TipResult& tip = body.nominal().at(0);
    EXPECT_NEAR(body.largest_K().at(0), 60.0 * tip.K_I, 1e-3 * body.largest_K()[0]);
}

TEST_F(CrackedBodyOf, MetalThatYieldsHasTheZoneOfItsLargestK) {
    const Scene scene = refined_scene(pulled(true));
    const CrackedBody body(scene, effort, silent, nullptr);
    EXPECT_TRUE(body.has_zone());
    EXPECT_EQ(body.in_zone(), select_zone(scene, body.largest_K()));
    EXPECT_EQ(body.structure().in_zone(), body.in_zone());
}

TEST_F(CrackedBodyOf, AGrownCrackHasTheNominalSolutionOfItsLength) {
    const Scene scene = refined_scene(pulled(true));
    CrackedBody body(scene, effort, silent, nullptr);
    const ElementSet before = body.in_zone();
    const std::vector<TipResult> at_start = body.nominal();
    grow(body, 0.6);
    EXPECT_DOUBLE_EQ(body.nominal().at(0).a, 7.9);
    const Scene fresh = make_scene(body.scene().input, scene.mesh);
    EXPECT_NEAR(body.nominal()[0].K_I, solve_nominal(fresh).tips.at(0).K_I, 1e-9 * body.nominal()[0].K_I);
    EXPECT_EQ(body.structure().in_zone(), body.in_zone());
    EXPECT_EQ(&body.structure().scene(), &body.scene());
    EXPECT_FALSE(before == body.in_zone());
    ElementSet both = before;
    both |= body.in_zone();
    EXPECT_EQ(both, body.in_zone());  // nothing leaves the zone
    EXPECT_EQ(body.nominal_at_start().K_I.at(0), at_start.at(0).K_I);
}

// The elements that the crack newly cuts, and those about the new tip.
TEST_F(CrackedBodyOf, AZoneTakesWhatChangesItsFunctions) {
    Case input = pulled(true);
    input.fine.radius = 0.3;
    const Scene scene = refined_scene(input);
    CrackedBody body(scene, effort, silent, nullptr);
    const auto next = longer(body, 2.1);  // some that it cuts are not about the new tip
    const ElementSet zone = body.zone_with_changes(*next);
    for (const CrackPiece& piece : next->enriched.pieces) {
        const bool is_new = piece.points.back().x() > 7.3;
        EXPECT_TRUE(!is_new || zone.contains(piece.element)) << piece.element;
    }
    const auto sees_tip = [&](int node) {
        return std::ranges::any_of(next->enriched.terms[at(node)],
                                   [](const Term& term) { return term.kind == Term::Kind::Tip; });
    };
    for (int e = 0; e < zone.size(); ++e)
        EXPECT_TRUE(zone.contains(e) || std::ranges::none_of(next->enriched.elements[at(e)], sees_tip)) << e;
    EXPECT_TRUE(std::ranges::any_of(next->enriched.pieces,
                                    [&](const CrackPiece& piece) { return !body.in_zone().contains(piece.element); }));
}

TEST_F(CrackedBodyOf, ADisplacementGoesOverByNodeAndFunction) {
    const Scene scene = refined_scene(pulled(true));
    const CrackedBody body(scene, effort, silent, nullptr);
    const auto next = longer(body, 0.6);
    const EnrichedMesh &from = scene.enriched, &to = next->enriched;
    const Eigen::VectorXd u = Eigen::VectorXd::LinSpaced(from.unknowns, 1.0, 2.0), carried = body.carried_to(*next, u);
    int fresh = 0;
    for (const auto& [node, term, unknown] : to.own_unknowns()) {
        const int same = term == 0 ? 0 : from.term_index(node, to.terms[at(node)][at(term - 1)]);
        const bool known = term == 0 || same > 0;
        fresh += known ? 0 : 1;
        if (term > 0 && to.terms[at(node)][at(term - 1)].kind != Term::Kind::Heaviside) continue;
        EXPECT_EQ(carried[unknown], known ? u[from.unknown(node, same, 0)] : 0.0) << node;
    }
    EXPECT_GT(fresh, 0);
}

TEST_F(CrackedBodyOf, AStateGoesOnFromWhereItWasWritten) {
    const Scene scene = refined_scene(pulled(true));
    CrackedBody body(scene, effort, silent, nullptr);
    grow(body, 0.6);
    AnalysisState state;
    body.write(state);
    state.displacement = Eigen::VectorXd::Zero(body.scene().enriched.unknowns);
    ASSERT_EQ(state.cracks.size(), 1U);
    EXPECT_EQ(state.cracks[0].x.back(), 7.3 + 0.6);
    CoarseEffort again;
    const CrackedBody resumed(scene, again, silent, &state);
    EXPECT_EQ(resumed.scene().input.cracks[0].points, body.scene().input.cracks[0].points);
    EXPECT_EQ(resumed.in_zone(), body.in_zone());
    EXPECT_EQ(resumed.nominal().at(0).K_I, body.nominal().at(0).K_I);
    EXPECT_EQ(resumed.largest_K(), body.largest_K());
    EXPECT_EQ(resumed.structure().tangent(), body.structure().tangent());
    // What only a later growth or a K that controls asks for.
    EXPECT_GT(state.unit_displacement.mean, body.nominal_at_start().displacement.mean);
    EXPECT_FALSE(state.still_of_nominal == StillElements());
    AnalysisState rewritten;
    resumed.write(rewritten);
    EXPECT_EQ(rewritten.unit_displacement.mean, state.unit_displacement.mean);
    EXPECT_EQ(rewritten.still_of_nominal, state.still_of_nominal);
}

// A load that is found to hold a displacement of zero is rounding of either sign: it turned the tips or did not.
TEST_F(CrackedBodyOf, ALoadThatHasGoneAtItsMaximumTurnsAsThatOfTheMinimum) {
    const Scene scene = refined_scene(pulled(false));
    const CrackedBody body(scene, effort, silent, nullptr);
    const auto K_I_beside = [&](double maximum, double minimum) {
        return K_at_maximum(body, {{maximum, {}}, {minimum, {}}, {}}).at(0).K_I;
    };
    const double unit = body.nominal().at(0).K_I;
    for (const double gone : {0.0, 3e-13, -3e-13}) EXPECT_EQ(K_I_beside(gone, -50.0), -unit) << gone;
    EXPECT_EQ(K_I_beside(1e-3, -50.0), unit);
    EXPECT_EQ(K_I_beside(3e-13, -3e-13), unit);
}

}  // namespace
}  // namespace stria::coarse
