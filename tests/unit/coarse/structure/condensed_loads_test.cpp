// What is condensed is what the elements say: energy, readings and forces of a state expanded to the whole mesh.
#include "coarse/structure/condensed_loads.hpp"

#include <gtest/gtest.h>

#include "coarse/elements/support_forces.hpp"
#include "coarse/structure/structure.hpp"
#include "coarse/zone/refined_scene.hpp"
#include "coarse/zone/zone_selection.hpp"
#include "tests/support/pulled_plate.hpp"

namespace stria::coarse {
namespace {

/// Pulled at the top by a traction and at the bottom by an imposed displacement.
class CondensedLoadsOf : public testing::Test {
protected:
    static Scene pulled() {
        Case input = test::pulled_plate(0.5, true, true);
        input.fine.radius = 1.5;
        input.boundaries[1].traction.reset();
        input.boundaries[1].displacement = {0.0, -2e-4};
        return refined_scene(input);
    }

    const Scene scene = pulled();
    const Structure structure{scene, select_zone(scene, {0.0})};
    const double load_factor = 30.0;
    const Eigen::VectorXd gamma = Eigen::VectorXd::LinSpaced(std::ssize(structure.gamma()), -2e-3, 1e-3);
    const Eigen::VectorXd free = structure.on_free_places(gamma);
    const Eigen::VectorXd u = structure.expand(gamma, load_factor);
};

TEST_F(CondensedLoadsOf, AStructureStoreWhatItsElementsStore) {
    const double stored = 0.5 * u.dot(structure.elements().internal_force(u));
    EXPECT_GT(stored, 0.0);
    EXPECT_NEAR(structure.loads().stored_energy(structure.tangent(), free, load_factor), stored, 1e-10 * stored);
}

TEST_F(CondensedLoadsOf, AStructureReadWhatTheMeshReads) {
    const double displacement = scene.mean_displacement.dot(u);
    EXPECT_NEAR(structure.loads().mean_displacement().at(free, load_factor), displacement,
                1e-11 * u.lpNorm<Eigen::Infinity>());
    Eigen::VectorXd imposed(std::ssize(scene.prescribed));
    for (std::size_t k = 0; k < scene.prescribed.size(); ++k)
        imposed[static_cast<Eigen::Index>(k)] = scene.prescribed[k].value;
    const Eigen::VectorXd forces = forces_on_prescribed(structure.elements(), u);
    const double scale = imposed.cwiseAbs().dot(forces.cwiseAbs());
    EXPECT_GT(scale, 0.0);
    EXPECT_NEAR(structure.loads().imposed_force().at(free, load_factor), imposed.dot(forces), 1e-9 * scale);
}

}  // namespace
}  // namespace stria::coarse
