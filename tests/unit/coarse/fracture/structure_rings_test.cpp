// Rings of a body that answers in proportion to its load: those of the load factor 1 tell them all.
#include "coarse/fracture/structure_rings.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "coarse/fracture/nominal_solution.hpp"
#include "coarse/structure/proportion.hpp"
#include "coarse/zone/refined_scene.hpp"
#include "coarse/zone/zone_selection.hpp"
#include "tests/support/plate_of_load_cases.hpp"
#include "tests/support/pulled_plate.hpp"

namespace stria::coarse {
namespace {

/// One end is moved, and the crack is inclined: both modes, T and a rotation.
Scene inclined_scene() {
    Case input = test::pulled_plate(1.0, false, false);
    input.boundaries[1].traction.reset();
    input.boundaries[1].displacement = {0.0, -2e-4};
    input.cracks[0].points[1].y() = 12.9;
    return refined_scene(input);
}

void expect_alike(const DomainIntegral& a, const DomainIntegral& b) {
    EXPECT_NEAR(a.J, b.J, 1e-11 * std::abs(b.J));
    const DomainIntegral x = a.without_rotation(), y = b.without_rotation();
    const double scale = std::abs(y.interaction_I);
    EXPECT_NEAR(x.interaction_I, y.interaction_I, 1e-11 * scale);
    EXPECT_NEAR(x.interaction_II, y.interaction_II, 1e-11 * scale);
    EXPECT_NEAR(x.interaction_T, y.interaction_T, 1e-10 * std::abs(y.interaction_T));
    EXPECT_NEAR(a.rotation, b.rotation, 1e-11 * std::abs(b.rotation));
}

TEST(StructureRings, OfABodyThatAnswersInProportionFollowFromThoseOfOneLoad) {
    const Scene scene = inclined_scene();
    const Structure structure(scene);
    ASSERT_TRUE(answers_in_proportion(structure));
    StructureRings rings(structure.elements());
    std::int64_t solved = 0;
    for (const double load_factor : {-40.0, 1.0, 170.0}) {
        const RingIntegrals found = rings.integrals_in_proportion(structure, load_factor, solved);
        const RingIntegrals expected = rings.integrals(structure.expand({}, load_factor));
        ASSERT_EQ(found.size(), expected.size());
        ASSERT_EQ(found[0].size(), expected[0].size());
        ASSERT_GT(std::abs(expected[0][0].interaction_II), 0.01 * std::abs(expected[0][0].interaction_I));
        for (std::size_t ring = 0; ring < expected[0].size(); ++ring) expect_alike(found[0][ring], expected[0][ring]);
    }
    EXPECT_EQ(solved, 1);
}

// Of the nominal body, which is the structure where there is no zone, K is known: for rings nothing is solved again.
TEST(StructureRings, ReadTheDisplacementOfTheNominalBody) {
    const Scene scene = inclined_scene();
    const NominalSolution nominal = solve_nominal_near(std::make_unique<Structure>(scene));
    StructureRings rings(nominal.structure->elements());
    std::int64_t solved = 0;
    const RingIntegrals found = rings.integrals_in_proportion(*nominal.structure, 40.0, solved);
    EXPECT_EQ(solved, 0);
    EXPECT_EQ(nominal.fields.unit, nominal.structure->near_of_unit_load(solved));
    EXPECT_NEAR(found[0][0].interaction_I / 40.0, rings.integrals(nominal.fields.unit)[0][0].interaction_I, 1e-9);
}

TEST(StructureRings, AnswerInProportionWithoutAZoneAndBesideNothingElse) {
    Case input = test::pulled_plate(1.0, true, true);
    input.fine.radius = 1.5;
    const Scene scene = refined_scene(input);
    EXPECT_FALSE(answers_in_proportion(Structure(scene, select_zone(scene, {0.0}))));
    const Scene with_cases = refined_scene(test::plate_of_load_cases(1.0, false, false));
    EXPECT_FALSE(answers_in_proportion(Structure(with_cases)));
    input = test::pulled_plate(1.0, false, false);
    input.initial_stress.emplace().sigma_x = StressProfile{.at = {0.0, 10.0, 20.0}, .stress = {10.0, -10.0, 10.0}};
    const Scene stressed = refined_scene(input);
    EXPECT_FALSE(answers_in_proportion(Structure(stressed)));
}

}  // namespace
}  // namespace stria::coarse
