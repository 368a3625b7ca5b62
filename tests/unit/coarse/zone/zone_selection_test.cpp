// Which elements are fine: eq. (3), the disk about a tip, the faces that may touch.
#include "coarse/zone/refined_scene.hpp"
#include "coarse/zone/zone_selection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "coarse/structure/structure.hpp"
#include "common/enrichment/part_of_mesh.hpp"
#include "common/fem/centre.hpp"
#include "common/index.hpp"
#include "tests/support/pulled_plate.hpp"

namespace stria::coarse {
namespace {

/// Of unit elements.
Scene cracked_plate(bool plastic, bool contact, std::optional<double> radius = {}) {
    Case input = test::pulled_plate(1.0, plastic, contact);
    input.fine.radius = radius;
    return refined_scene(input);
}

std::set<int> zone_of(const Scene& scene, double K_I) {
    const std::vector<int> zone = select_zone(scene, {K_I}).members();
    return {zone.begin(), zone.end()};
}

double distance_to_tip(const Scene& scene, int element) {
    return (centre(scene.enriched, element) - scene.enriched.tips[0].position).norm();
}

bool has_tip_function(const Scene& scene, int element) {
    return std::ranges::any_of(scene.enriched.elements[at(element)], [&](int node) {
        const auto& terms = scene.enriched.terms[at(node)];
        return std::ranges::any_of(terms, [](const Term& term) { return term.kind == Term::Kind::Tip; });
    });
}

constexpr double K_for_radius_1 = 300.0 * 1.595769121605731;  // beta = 2: R = (2 pi/16) (K/300)^2

TEST(ZoneSelection, DiskHoldsElementsByTheirCentresAndAllTipFunctions) {
    const Scene scene = cracked_plate(true, false);
    for (const double radius : {0.1, 1.0, 2.7, 4.2}) {
        const std::set<int> zone = zone_of(scene, K_for_radius_1 * std::sqrt(radius));
        for (int e = 0; e < static_cast<int>(scene.enriched.elements.size()); ++e) {
            EXPECT_EQ(zone.contains(e), has_tip_function(scene, e) || distance_to_tip(scene, e) <= radius)
                << e << ' ' << radius;
        }
    }
}

// It held those with functions of the tip, which nobody was there to compute.
TEST(ZoneSelection, OfAnElasticBodyIsEmptyWhereNoRingTellsK) {
    Case input = test::pulled_plate(1.0, false, false);
    input.fine.enrichment = Enrichment::Topological;
    EXPECT_TRUE(zone_of(refined_scene(input), std::nan("")).empty());
}

TEST(ZoneSelection, FacesThatMayTouchAndTheirTipFunctionsAreFine) {
    const Scene scene = cracked_plate(false, true);
    std::set<int> expected;
    for (const CrackPiece& piece : scene.enriched.pieces) expected.insert(piece.element);
    EXPECT_EQ(expected.size(), 8U);
    for (int e = 0; e < std::ssize(scene.enriched.elements); ++e)
        if (has_tip_function(scene, e)) expected.insert(e);
    EXPECT_EQ(zone_of(scene, 1e6), expected);  // elastic: no disk
}

TEST(ZoneSelection, AnElasticSceneWithoutContactHasNone) {
    EXPECT_TRUE(zone_of(cracked_plate(false, false), 1e6).empty());
}

TEST(ZoneSelection, TheRadiusOfTheCaseReplacesEquation3) {
    EXPECT_EQ(zone_of(cracked_plate(true, true, 3.0), 1.0),
              zone_of(cracked_plate(true, true), K_for_radius_1 * std::sqrt(3.0)));
}

TEST(ZoneSelection, GrowsWithK) {
    const Scene scene = cracked_plate(true, true);
    std::set<int> last;
    for (const double radius : {0.0, 0.5, 1.0, 2.0, 5.0, 9.0}) {
        const std::set<int> zone = zone_of(scene, K_for_radius_1 * std::sqrt(radius));
        EXPECT_TRUE(std::ranges::includes(zone, last));
        last = zone;
    }
    EXPECT_GT(last.size(), 200U);
}

TEST(ZoneSelection, ThePatchHasTheZonesElementsAndSharesGammaAlone) {
    const Scene scene = cracked_plate(true, true);
    const Structure structure(scene, select_zone(scene, {2.0 * K_for_radius_1}));
    const Eigen::VectorXd u = Eigen::VectorXd::LinSpaced(scene.enriched.unknowns, 0.0, 1.0);
    const coupling::Patch patch = make_patch(scene, structure.in_zone(), structure.gamma(), u);
    const std::vector<int> whole = whole_unknowns(scene.enriched, patch.mesh);
    for (std::size_t i = 0; i < whole.size(); ++i) {
        EXPECT_EQ(patch.displacement[static_cast<Eigen::Index>(i)], u[whole[i]]);
        EXPECT_EQ(std::ranges::binary_search(patch.boundary, static_cast<int>(i)),
                  std::ranges::binary_search(structure.gamma(), whole[i]));
    }
    EXPECT_EQ(std::ssize(patch.mesh.elements), structure.in_zone().count());
    EXPECT_EQ(patch.boundary.size(), structure.gamma().size());
}

}  // namespace
}  // namespace stria::coarse
