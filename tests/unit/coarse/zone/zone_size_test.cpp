// How large a zone is, and will be.
#include "coarse/zone/zone_size.hpp"

#include <gtest/gtest.h>

#include "coarse/fracture/nominal_solution.hpp"
#include "coarse/structure/gamma.hpp"
#include "coarse/zone/refined_scene.hpp"
#include "coarse/zone/zone_selection.hpp"
#include "fine/bulk/bulk_elements.hpp"
#include "fine/zone/zone_sections.hpp"
#include "tests/support/pulled_plate.hpp"
#include "tests/support/specimens.hpp"

namespace stria::coarse {
namespace {

Case plate_to_grow(int refine, bool yields) {
    Case input = test::specimen("plate", 20.0, {{0.0, 10.1}, {5.3, 10.1}});
    input.mesh.width = 20.0;
    input.mesh.size = 1.0;
    if (yields) input.material.yield_stress = 300.0;
    input.cracks[0].contact = ContactSection{};
    input.boundaries = {test::at_end("top", test::End::Pulled, 1.0), test::at_end("bottom", test::End::Pulled, -1.0)};
    input.load.blocks = {{.cycles = 10, .max = 60.0, .min = 0.0}};
    input.growth = GrowthSection{.increment = 0.1};
    input.fine.refine = refine;
    return input;
}

std::vector<double> K_of_scene(const Scene& scene) {
    return largest_K(scene.input, unit_response(solve_nominal(scene)));
}

double points_of_fine(const Scene& scene, const ElementSet& zone) {
    const coupling::Patch patch =
        make_patch(scene, zone, gamma_of(scene, zone), Eigen::VectorXd::Zero(scene.enriched.unknowns));
    const fine::BulkElements elements(patch.mesh, scene.materials, fine::ZoneSections(scene.input).rule(), nullptr);
    double points = 0.0;
    for (int e = 0; e < elements.count(); ++e) points += static_cast<double>(elements.op(e).points.size());
    return points;
}

// Cut elements were counted as whole ones, and those ahead of a tip as those elsewhere: 304 points of 548 where only
// faces that may touch are fine.
TEST(ZoneSize, PointsAreThoseThatTheFineComponentPlaces) {
    for (const int refine : {1, 4})
        for (const bool yields : {true, false}) {
            const Scene scene = refined_scene(plate_to_grow(refine, yields));
            const ElementSet zone = select_zone(scene, K_of_scene(scene));
            const ZoneSize size = size_of_zone(scene, zone);
            EXPECT_EQ(size.points, points_of_fine(scene, zone)) << refine << yields;
            EXPECT_EQ(size.elements, zone.count());
            EXPECT_GT(size.points, 4.0 * zone.count() + 1.0);
        }
}

TEST(ZoneSize, CountsWhatAWayTakes) {
    const Scene scene = refined_scene(plate_to_grow(4, true));
    const std::vector<double> K = K_of_scene(scene);
    const ElementSet zone = select_zone(scene, K);
    const auto after = [&](double way) { return size_after(scene, zone, K, K, way); };
    const ZoneSize none = after(0.0), two = after(2.0), four = after(4.0);
    EXPECT_EQ(none.points, size_of_zone(scene, zone).points);
    EXPECT_GT(two.elements, none.elements);
    EXPECT_NEAR(four.all - two.all, two.all - none.all, 0.4 * (two.all - none.all));
    EXPECT_GT(four.points - none.points, 5.0 * (four.elements - none.elements)) << "a way has sixteen in some";
    EXPECT_GT(size_after(scene, zone, K, {1.3 * K[0]}, 4.0).elements, 1.05 * four.elements);
    const Scene whole = refined_scene(plate_to_grow(1, true));
    const ElementSet of_whole = select_zone(whole, K_of_scene(whole));
    EXPECT_EQ(size_after(whole, of_whole, K_of_scene(whole), K_of_scene(whole), 4.0).all, 400.0);
    EXPECT_GT(size_after(whole, of_whole, K_of_scene(whole), K_of_scene(whole), 4.0).elements, of_whole.count() + 3.0);
}

TEST(ZoneSize, KOnTheWayIsThatOfALongerCrack) {
    Case input = plate_to_grow(1, true);
    const Scene scene = refined_scene(input);
    input.cracks[0].points[1].x() += 3.0;
    const Scene longer = refined_scene(input);
    ASSERT_EQ(K_after(scene, 3.0).size(), 1U);
    EXPECT_NEAR(K_after(scene, 3.0)[0], K_of_scene(longer)[0], 1e-6 * K_of_scene(longer)[0]);
    EXPECT_TRUE(K_after(scene, 15.0).empty()) << "out of the body";
}

}  // namespace
}  // namespace stria::coarse
