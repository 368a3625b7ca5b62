// What is condensed is what the elements say: energy, readings and forces of a state expanded to the whole mesh.
#include "coarse/structure/condensed_loads.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "coarse/elements/support_forces.hpp"
#include "coarse/structure/structure.hpp"
#include "coarse/zone/refined_scene.hpp"
#include "coarse/zone/zone_selection.hpp"
#include "tests/support/plate_of_load_cases.hpp"

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
    const double displacement = scene.displacement_weights.dot(u);
    EXPECT_NEAR(structure.loads().displacement_reading().at(free, load_factor), displacement,
                1e-11 * u.lpNorm<Eigen::Infinity>());
    Eigen::VectorXd imposed(std::ssize(scene.prescribed));
    for (std::size_t k = 0; k < scene.prescribed.size(); ++k)
        imposed[static_cast<Eigen::Index>(k)] = scene.prescribed[k].value;
    const Eigen::VectorXd forces = forces_on_prescribed(structure.elements(), u);
    const double scale = imposed.cwiseAbs().dot(forces.cwiseAbs());
    EXPECT_GT(scale, 0.0);
    EXPECT_NEAR(structure.loads().work().imposed_force.at(free, load_factor), imposed.dot(forces), 1e-9 * scale);
}

/// The same plate with two load cases: its lower end is moved, and its sides are sheared.
class LoadCasesOf : public testing::Test {
protected:
    static Scene loaded() {
        Case input = test::plate_of_load_cases(0.5, true, true);
        input.fine.radius = 1.5;
        return refined_scene(input);
    }

    const Scene scene = loaded();
    const Structure structure{scene, select_zone(scene, {0.0})};
    const LoadFactors factors{30.0, Eigen::Vector2d(-20.0, 50.0)};
    const Eigen::VectorXd gamma = Eigen::VectorXd::LinSpaced(std::ssize(structure.gamma()), -2e-3, 1e-3);
    const Eigen::VectorXd free = structure.on_free_places(gamma);
    const Eigen::VectorXd u = structure.expand(gamma, factors);
};

TEST_F(LoadCasesOf, AStructureAddUp) {
    const Eigen::VectorXd nothing = Eigen::VectorXd::Zero(gamma.size());
    Eigen::VectorXd sum = structure.expand(gamma, 30.0);
    sum += -20.0 * structure.expand(nothing, LoadFactors::of_one_case(0));
    sum += 50.0 * structure.expand(nothing, LoadFactors::of_one_case(1));
    EXPECT_LT((sum - u).norm(), 1e-12 * u.norm());
    Eigen::VectorXd near = Eigen::VectorXd::Zero(u.size());
    structure.expand_near(gamma, factors, 0.0, near);
    for (const int unknown : structure.near_unknowns()) EXPECT_NEAR(near[unknown], u[unknown], 1e-12 * u.norm());
    const PrescribedUnknown& moved = *std::ranges::find(scene.prescribed, -2e-4, &PrescribedUnknown::value);
    EXPECT_DOUBLE_EQ(u[moved.unknown], 30.0 * -2e-4 - 20.0 * 3e-4);
}

TEST_F(LoadCasesOf, AStructureStoreWhatItsElementsStore) {
    const double stored = 0.5 * u.dot(structure.elements().internal_force(u));
    EXPECT_GT(stored, 0.0);
    EXPECT_NEAR(structure.loads().stored_energy(structure.tangent(), free, factors), stored, 1e-10 * stored);
}

TEST_F(LoadCasesOf, AStructureReadWhatTheMeshReads) {
    const CondensedLoads& loads = structure.loads();
    EXPECT_NEAR(loads.displacement_reading().at(free, factors), scene.displacement_weights.dot(u),
                1e-11 * u.lpNorm<Eigen::Infinity>());
    const Eigen::VectorXd forces = forces_on_prescribed(structure.elements(), u);
    for (Eigen::Index k = 0; k < 2; ++k) {
        Eigen::VectorXd imposed(forces.size()), force = scene.case_forces[at(k)];
        for (std::size_t i = 0; i < scene.prescribed.size(); ++i) {
            imposed[static_cast<Eigen::Index>(i)] = scene.prescribed[i].in_case(k);
            force[scene.prescribed[i].unknown] = 0.0;
        }
        const auto& [displacement, imposed_force] = loads.work_of_cases()[at(k)];
        EXPECT_NEAR(displacement.at(free, factors), force.dot(u), 1e-10 * force.cwiseAbs().dot(u.cwiseAbs()));
        EXPECT_NEAR(imposed_force.at(free, factors), imposed.dot(forces),
                    1e-9 * imposed.cwiseAbs().dot(forces.cwiseAbs()));
    }
}

}  // namespace
}  // namespace stria::coarse
