// The nominal solution: near elements tell its K; only the displacement of far ones is missing.
#include "coarse/fracture/nominal_solution.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include <cmath>

#include "coarse/fracture/fracture_parameters.hpp"
#include "coarse/specimen/specimen.hpp"
#include "coarse/zone/refined_scene.hpp"
#include "common/index.hpp"
#include "tests/support/elastic_scene.hpp"
#include "tests/support/pulled_plate.hpp"

namespace stria::coarse {
namespace {

TEST(NominalSolution, HasItsKFromNearElementsAlone) {
    Case input = test::pulled_plate(0.5, false, false);
    input.mesh.width = input.mesh.height = 40.0;
    input.cracks[0].points = {{0.0, 20.2}, {7.3, 20.2}};
    const Scene scene = refined_scene(input);
    const NominalSolution whole = solve_nominal(scene), near = solve_nominal_near(std::make_unique<Structure>(scene));
    ASSERT_EQ(whole.tips.size(), 1U);
    EXPECT_NE(whole.structure->factors().far, nullptr);
    EXPECT_NEAR(near.tips[0].K_I, whole.tips[0].K_I, 1e-10 * whole.tips[0].K_I);
    EXPECT_NEAR(near.tips[0].T_stress, whole.tips[0].T_stress, 1e-10 * std::abs(whole.tips[0].T_stress));
    EXPECT_TRUE(std::isnan(near.tips[0].J));
    EXPECT_LT(near.fields.unit.norm(), 0.9 * whole.fields.unit.norm());
}

// Of what will be a zone no more is asked than K: the structure's own part is as it was, and serves beside that zone.
TEST(NominalSolution, KeepsRingsForAStructureBesideAZone) {
    Case input = test::pulled_plate(0.5, false, false);
    input.mesh.width = input.mesh.height = 40.0;
    input.cracks[0].points = {{0.0, 20.2}, {7.3, 20.2}};
    const Scene scene = refined_scene(input);
    ElementSet zone(scene.mesh->elements.size());
    for (int e = 0; e < zone.size(); ++e)
        if ((scene.mesh->nodes[at(scene.mesh->elements[at(e)][0])] - Vec2(7.3, 20.2)).norm() < 4.0) zone.insert(e);
    const NominalSolution whole = solve_nominal(scene),
                          near = solve_nominal_near(std::make_unique<Structure>(scene), zone);
    EXPECT_NEAR(near.tips[0].K_I, whole.tips[0].K_I, 1e-10 * whole.tips[0].K_I);
    EXPECT_NEAR(near.tips[0].T_stress, whole.tips[0].T_stress, 1e-10 * std::abs(whole.tips[0].T_stress));
    ASSERT_TRUE(near.rings[0].serve_beside(zone));
    EXPECT_FALSE(near.rings[0].serve_beside(ElementSet(zone.size())));
    const CoarseElements beside(scene, zone, {});
    const std::vector<DomainIntegral> own = near.rings[0].values(beside, whole.fields.unit),
                                      of_all = whole.rings[0].values(beside, whole.fields.unit);
    ASSERT_EQ(own.size(), of_all.size());
    for (std::size_t ring = 0; ring < own.size(); ++ring) {
        EXPECT_EQ(own[ring].J, of_all[ring].J);
        EXPECT_EQ(own[ring].interaction_I, of_all[ring].interaction_I);
        EXPECT_EQ(own[ring].rotation, of_all[ring].rotation);
    }
}

// The quadrature of the auxiliary fields in elements as coarse as these does not know that turning does no work.
TEST(NominalSolution, KDoesNotTellHowTheBodyIsTurned) {
    Case input = test::pulled_plate(1.0, false, false);
    input.fine.enrichment = Enrichment::None;
    input.cracks[0].points = {{0.0, 9.45}, {7.3, 10.97}};
    const Scene scene = refined_scene(input);
    const Structure body(scene);
    const Eigen::VectorXd u = body.expand({}, 1.0);
    const double strain = 1.0 / input.material.young;
    const auto parameters = [&](double angle) {
        const Eigen::Matrix2d turn{{0.0, -angle}, {angle, 0.0}};
        return fracture_parameters(body, u + test::linear_field(scene.enriched, turn), {}).front();
    };
    const TipResult itself = parameters(0.0), turned = parameters(100.0 * strain);
    EXPECT_NEAR(turned.J, itself.J, 1e-10 * itself.J);
    EXPECT_NEAR(turned.K_I, itself.K_I, 1e-10 * itself.K_I);
    EXPECT_NEAR(turned.K_II, itself.K_II, 1e-10 * itself.K_I);
    EXPECT_NEAR(turned.T_stress, itself.T_stress, 1e-9 * std::abs(itself.T_stress));
}

}  // namespace
}  // namespace stria::coarse
