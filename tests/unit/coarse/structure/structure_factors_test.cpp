// What one structure leaves to the next: elements that stay far or in the middle, and factors that serve again to the
// last bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "coarse/fracture/nominal_solution.hpp"
#include "coarse/structure/structure.hpp"
#include "coarse/zone/refined_scene.hpp"
#include "coarse/zone/zone_selection.hpp"
#include "common/enrichment/same_functions.hpp"
#include "common/index.hpp"
#include "common/integration/plain_operator.hpp"
#include "tests/support/pulled_plate.hpp"

namespace stria::coarse {
namespace {

/// A wide plate whose crack grows; contact and a disk of 1.5 mm make the zone.
Scene scene_along(const std::vector<Vec2>& crack) {
    Case input = test::pulled_plate(0.5, true, true);
    input.mesh.width = input.mesh.height = 40.0;
    input.cracks[0].points = crack;
    input.fine.radius = 1.5;
    input.load.blocks = {{.cycles = 20, .max = 50.0, .min = 0.0}};
    input.growth = GrowthSection{.increment = 0.5};
    return refined_scene(input);
}

Scene scene_with(double crack) { return scene_along({{0.0, 20.2}, {crack, 20.2}}); }

class Factors : public testing::Test {
protected:
    static ElementSet zone_of(const Scene& scene) { return select_zone(scene, {0.0}); }

    const Scene scene = scene_with(7.3), longer = scene_with(7.8), far_on = scene_with(13.3);
    const ElementSet zone = zone_of(scene), next_zone = zone_of(longer);
    const ElementSet far = far_elements(scene, zone);
    const StillElements still = still_elements(scene, zone);
};

TEST_F(Factors, FarElementsStayUntilOneHasToBeNear) {
    EXPECT_GT(far.count(), far.size() / 4);
    EXPECT_EQ(far_elements(longer, next_zone, far), far);
    const ElementSet zone_far_on = zone_of(far_on), anew = far_elements(far_on, zone_far_on, far);
    EXPECT_NE(anew, far);
    EXPECT_EQ(anew, far_elements(far_on, zone_far_on));
    const ElementSet near = near_elements(far_on, zone_far_on);
    for (const int e : anew.members()) EXPECT_FALSE(near.contains(e) || zone_far_on.contains(e));
}

TEST_F(Factors, ElementsInTheMiddleStayUntilOneHasToBeInTheCore) {
    EXPECT_EQ(still.far, far);
    const ElementSet near = near_elements(scene, zone), &middle = still.middle;
    EXPECT_GT(2 * middle.count(), near.count());
    EXPECT_EQ(still_elements(longer, next_zone, still), still);
    ElementSet reaches = zone;
    reaches.insert(middle.members().front());
    const StillElements anew = still_elements(scene, reaches, still);
    EXPECT_NE(anew.middle, middle);
    EXPECT_EQ(anew, still_elements(scene, reaches, {.far = anew.far, .middle = {}}));
    NodeSet of_zone(scene.mesh->nodes.size());
    for (const int e : reaches.members())
        for (const int node : scene.mesh->elements[at(e)]) of_zone.insert(node);
    for (const int e : anew.middle.members()) {
        EXPECT_FALSE(reaches.contains(e) || anew.far.contains(e) || !is_plain(scene.enriched, e)) << e;
        for (const int node : scene.mesh->elements[at(e)]) EXPECT_FALSE(of_zone.contains(node)) << e;
    }
}

/// Short cracks in a row, small elements about each: the largest rings end among them. `K_I`: of the first one.
struct RowOfCracks {
    static Case plate() {
        Case input = test::pulled_plate(0.5, false, false);
        input.mesh.height = 30.0;
        input.cracks.clear();
        for (const double y : {3.1, 8.1, 13.1, 18.1, 23.1}) {
            input.cracks.emplace_back();
            input.cracks.back().points = {{0.0, y}, {1.1, y}};
        }
        input.fine.refine = 16;
        input.fine.radius = 1.4;
        return input;
    }

    double K_I(const ElementSet& far) const {
        const ElementSet none(scene.mesh->elements.size());
        return solve_nominal(std::make_unique<Structure>(scene, none, StillElements{.far = far, .middle = {}}))
            .tips[0]
            .K_I;
    }

    Scene scene = refined_scene(plate());
};

// On elements half as large stria check took 20 s and 2.4 GB for a rim of 6332 unknowns, of a body that takes 2 s.
TEST(FarElements, AreNoneWhereTheirRimTakesMoreThanTheySpare) {
    const RowOfCracks row;
    const ElementSet none(row.scene.mesh->elements.size()), near = near_elements(row.scene, none);
    EXPECT_TRUE(far_elements(row.scene, none).none());
    EXPECT_NEAR(row.K_I(near.complement()) / row.K_I(none), 1.0, 1e-10) << "it is the same body";
    const ElementSet zone = select_zone(row.scene, std::vector<double>(5, 0.0));
    EXPECT_FALSE(far_elements(row.scene, zone, far_elements(row.scene, none)).none()) << "beside a zone they serve";
}

// Those of cracks of 3.5 mm in a body of 75 000 elements were factored seven times in forty steps of 0.2 mm, which was
// half of the time.
TEST(FarElements, StayForManyStepsWhereTheyAreMany) {
    const auto plate_with = [](double crack) {
        Case input = test::pulled_plate(0.5, false, false);
        input.mesh.width = input.mesh.height = 60.0;
        input.cracks[0].points = {{0.0, 30.2}, {crack, 30.2}};
        input.growth = GrowthSection{.increment = 0.1};
        return refined_scene(input);
    };
    const Scene scene = plate_with(3.1);
    const ElementSet none(scene.mesh->elements.size()), far = far_elements(scene, none);
    EXPECT_EQ(far_elements(plate_with(4.9), none, far), far);
    EXPECT_NE(far_elements(plate_with(7.1), none, far), far);
}

// A crack along the body: twelve steps of growth took 53 s and 2.1 GB, and take 4 s and 0.2 GB.
TEST(ElementsInTheMiddle, AreNoneWhereTheirRimTakesMoreThanTheySpare) {
    Case input = test::pulled_plate(0.5, false, false);
    input.mesh.width = 8.0;
    input.mesh.height = 150.0;
    input.cracks[0].points = {{4.3, 150.0}, {4.3, 15.0}};
    input.growth = GrowthSection{.increment = 0.5};
    const Scene scene = refined_scene(input);
    EXPECT_TRUE(still_elements(scene, ElementSet(scene.mesh->elements.size())).middle.none());
}

TEST_F(Factors, NothingIsInTheMiddleWhereNoCrackGrows) {
    Scene at_rest = scene;
    at_rest.input.growth.reset();
    EXPECT_TRUE(still_elements(at_rest, zone).middle.none());
}

void expect_same_bits(const Structure& a, const Structure& b) {
    EXPECT_EQ(a.tangent(), b.tangent());
    EXPECT_EQ(a.loads().unit().boundary, b.loads().unit().boundary);
    EXPECT_EQ(a.loads().displacement_reading().weights, b.loads().displacement_reading().weights);
    EXPECT_EQ(a.loads().displacement_reading().per_load_factor, b.loads().displacement_reading().per_load_factor);
    const Eigen::VectorXd gamma = Eigen::VectorXd::LinSpaced(std::ssize(b.gamma()), -1e-3, 1e-3);
    EXPECT_EQ(a.expand(gamma, 40.0), b.expand(gamma, 40.0));
}

TEST_F(Factors, OfAFarPartServeAgainToTheLastBit) {
    const StillElements only_far{.far = far, .middle = {}};
    const Structure before(scene, zone, only_far), fresh(longer, next_zone, only_far),
        again(longer, next_zone, only_far, before.factors());
    EXPECT_EQ(again.factors().far, before.factors().far);
    EXPECT_NE(fresh.factors().far, before.factors().far);
    expect_same_bits(again, fresh);
}

TEST_F(Factors, OfAMiddlePartServeAgainToTheLastBit) {
    const Structure before(scene, zone, still), fresh(longer, next_zone, still),
        again(longer, next_zone, still, before.factors());
    EXPECT_NE(before.factors().middle, nullptr);
    EXPECT_EQ(again.factors().far, before.factors().far);
    EXPECT_EQ(again.factors().middle, before.factors().middle);
    EXPECT_NE(fresh.factors().middle, before.factors().middle);
    expect_same_bits(again, fresh);
}

ElementSet cut_elements(const EnrichedMesh& mesh) {
    ElementSet cut(mesh.elements.size());
    for (const CrackPiece& piece : mesh.pieces) cut.insert(piece.element);
    return cut;
}

// All arc lengths are others then.
TEST(SameFunctions, AreThoseOfACrackThatGrowsAtItsFirstPoint) {
    const auto scene_to = [](double x) { return scene_along({{x, 20.2}, {0.0, 20.2}}); };
    const Scene scene = scene_to(7.3), longer = scene_to(7.8);
    ElementSet wake = cut_elements(scene.enriched);
    for (const CrackPiece& piece : scene.enriched.pieces)
        if (piece.points.front().x() > 5.0) wake.erase(piece.element);
    EXPECT_GT(wake.count(), 3);
    EXPECT_TRUE(same_functions(scene.enriched, longer.enriched, wake));
    EXPECT_FALSE(same_functions(scene.enriched, longer.enriched, cut_elements(scene.enriched)));
}

// Of the whole body: the wake is condensed with its jumps.
TEST_F(Factors, OfWhatIsBehindServeAgainToTheLastBit) {
    const ElementSet no_zone(zone.size());
    StillElements whole = still;
    whole.behind = elements_behind(scene, still, no_zone);
    ElementSet wake = cut_elements(scene.enriched);
    for (const int e : wake.members())
        if (!whole.behind.contains(e)) wake.erase(e);
    EXPECT_GT(wake.count(), cut_elements(scene.enriched).count() / 2);
    EXPECT_TRUE(same_functions(scene.enriched, longer.enriched, whole.behind));
    EXPECT_FALSE(same_functions(scene.enriched, far_on.enriched, whole.behind)) << "the tip has been there";
    const Structure before(scene, no_zone, whole), fresh(longer, no_zone, whole),
        again(longer, no_zone, whole, before.factors());
    EXPECT_NE(before.factors().behind, nullptr);
    EXPECT_EQ(again.factors().behind, before.factors().behind);
    EXPECT_NE(fresh.factors().behind, before.factors().behind);
    expect_same_bits(again, fresh);
}

TEST_F(Factors, OfWhatIsBehindGiveTheDisplacementOfTheWholeBody) {
    const ElementSet no_zone(zone.size());
    StillElements whole = still;
    whole.behind = elements_behind(scene, still, no_zone);
    const Structure none(scene, no_zone, StillElements{}), some(scene, no_zone, whole);
    const Eigen::VectorXd u = none.expand({}, 1.0);
    EXPECT_LT((some.expand({}, 1.0) - u).norm(), 1e-11 * u.norm());
    Eigen::VectorXd near = Eigen::VectorXd::Zero(u.size());
    some.expand_near({}, 1.0, 0.0, near);
    for (const int unknown : some.near_unknowns()) EXPECT_NEAR(near[unknown], u[unknown], 1e-11 * u.norm());
}

// Of elements that are to be split it takes none, nor what hangs on them.
TEST_F(Factors, WhatIsBehindIsNotAboutASplit) {
    const ElementSet all = elements_behind(scene, still, ElementSet(zone.size()));
    ElementSet soon(zone.size());
    soon.insert(all.members().front());
    const NodeSet corners = [&] {
        NodeSet nodes(scene.mesh->nodes.size());
        for (const int node : scene.mesh->elements[at(soon.members().front())]) nodes.insert(node);
        return nodes;
    }();
    const ElementSet behind = elements_behind(scene, still, soon);
    EXPECT_FALSE(behind.none());
    for (const int e : behind.members())
        for (const int node : scene.mesh->elements[at(e)]) EXPECT_FALSE(corners.contains(node)) << e;
}

// It would be another one as soon as the tip has moved, and they would be factored anew.
TEST(WhatIsBehind, HasNoFunctionOfATipBesideIt) {
    int looked = 0;
    for (double tip = 7.05; tip < 7.6; tip += 0.05) {
        const Scene scene = scene_along({{0.0, 20.05}, {tip, 20.05}});
        const ElementSet zone = select_zone(scene, {0.0});
        const ElementSet behind = elements_behind(scene, still_elements(scene, zone), ElementSet(zone.size()));
        looked += behind.none() ? 0 : 1;
        const EnrichedMesh& mesh = nominal_functions(scene);
        NodeSet inside(mesh.nodes.size());
        for (const int e : behind.members())
            for (const int node : mesh.elements[at(e)]) inside.insert(node);
        for (const auto& corners : mesh.elements) {
            if (std::ranges::none_of(corners, [&](int node) { return inside.contains(node); })) continue;
            for (const int node : corners)
                for (const Term& term : mesh.terms[at(node)])
                    EXPECT_EQ(term.kind, Term::Kind::Heaviside) << "a tip at " << tip << ", " << node;
        }
    }
    EXPECT_GT(looked, 3);
}

// What lies on a far part of other elements cannot serve.
TEST_F(Factors, OfAMiddlePartServeOnItsFarPartAlone) {
    const Structure before(scene, zone, still),
        other(scene, zone, {.far = {}, .middle = still.middle}, before.factors());
    EXPECT_EQ(other.factors().far, nullptr);
    EXPECT_NE(other.factors().middle, before.factors().middle);
    EXPECT_LT((other.tangent() - before.tangent()).norm(), 1e-12 * before.tangent().norm());
}

TEST_F(Factors, OfTheSameMatrixServeAgain) {
    const Structure before(scene, zone, still), again(scene, zone, still, before.factors()),
        other(longer, next_zone, still, before.factors());
    EXPECT_EQ(again.factors().core, before.factors().core);
    EXPECT_NE(other.factors().core, before.factors().core);
}

TEST_F(Factors, DoNotDependOnWhatIsStill) {
    const Structure none(scene, zone, StillElements{});
    EXPECT_EQ(none.factors().far, nullptr);
    for (const StillElements& of : {still, StillElements{.far = far, .middle = {}}}) {
        const Structure some(scene, zone, of);
        EXPECT_EQ(some.gamma(), none.gamma());
        EXPECT_LT((some.tangent() - none.tangent()).norm(), 1e-12 * none.tangent().norm());
        const Eigen::VectorXd gamma = Eigen::VectorXd::LinSpaced(std::ssize(none.gamma()), -1e-3, 1e-3),
                              u = none.expand(gamma, 1.0);
        EXPECT_LT((some.expand(gamma, 1.0) - u).norm(), 1e-11 * u.norm());
        Eigen::VectorXd near = Eigen::VectorXd::Zero(u.size());
        some.expand_near(gamma, 1.0, 0.0, near);
        for (const int unknown : some.near_unknowns()) EXPECT_NEAR(near[unknown], u[unknown], 1e-12 * u.norm());
        const Eigen::VectorXd at_rest = Eigen::VectorXd::Zero(gamma.size()), held = none.expand(at_rest, 1.0);
        EXPECT_NEAR(some.loads().displacement_reading().per_load_factor, scene.displacement_weights.dot(held),
                    1e-11 * held.norm());
    }
}

}  // namespace
}  // namespace stria::coarse
