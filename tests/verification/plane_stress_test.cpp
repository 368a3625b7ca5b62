// Plane stress against closed forms, against the law of plane strain with sigma_zz brought to zero, and against plane
// strain where both agree (docs/references.md 2.1, 3.3, 6).
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "coarse/fracture/fracture_parameters.hpp"
#include "coarse/zone/refined_scene.hpp"
#include "common/geometry/vec2.hpp"
#include "common/index.hpp"
#include "fine/material/catalogue/material_catalogue.hpp"
#include "tests/support/elastic_scene.hpp"
#include "tests/support/material_catalogue.hpp"
#include "tests/support/material_point.hpp"

namespace stria::test {
namespace {

namespace state = fine::state;

const Elasticity sheet{210e3, 0.3, PlaneState::Stress};

MaterialPoint sheet_point(const MaterialSection& section) { return MaterialPoint(section, PlaneState::Stress); }

/// A tangent without its zz stress: that strain is eliminated.
MandelMatrix without_through_stress(const MandelMatrix& tangent) {
    return tangent - tangent.col(2) * tangent.row(2) / tangent(2, 2);
}

TEST(PlaneStress, StiffnessIsThatOfPlaneStrainWithoutTheThroughStress) {
    const Elasticity thick{sheet.young, sheet.poisson};
    EXPECT_LT((without_through_stress(thick.stiffness()) - sheet.stiffness()).norm(), 1e-15 * thick.stiffness().norm());
}

TEST(PlaneStress, MixedHardeningBarSsnv133) {  // Code_Aster V6.04.133
    const std::vector<std::pair<double, double>> history{{2e-3, 400}, {4.5e-3, 500}, {1e-4, -380}, {-2e-3, -464}};
    for (const std::vector<double>& kinematic : {std::vector{30e3}, std::vector{10e3, 20e3}}) {
        MaterialPoint bar = sheet_point(linear_hardening(400.0, 20e3, kinematic));
        for (const auto& [strain, stress] : history) EXPECT_NEAR(bar.uniaxial(strain), stress, 1e-8) << strain;
    }
}

TEST(PlaneStress, UniaxialCyclesIsotropicAndKinematic) {
    const double H = 200e3 * 2e3 / (200e3 - 2e3);  // from the tangent modulus 2000 MPa
    MaterialPoint isotropic = sheet_point(linear_hardening(200.0, H)),
                  kinematic = sheet_point(linear_hardening(200.0, 0.0, {H}));
    double strain = 0.01;
    for (const double stress : {218.0000, -253.6400, 288.5672, -322.7959}) {
        EXPECT_NEAR(isotropic.uniaxial(strain), stress, 5.1e-5);
        EXPECT_NEAR(kinematic.uniaxial(strain), std::copysign(218.0, strain), 1e-8);
        strain = -strain;
    }
}

struct Path {
    const char* name;
    Mandel strain;  // direction
    double strain_at_yield;
    Mandel at_yield, at_collapse;  // stress
};

// E = 200 GPa, nu = 0.3, sigma_y = 250 MPa, perfectly plastic.
TEST(PlaneStress, FirstYieldAndCollapse) {
    const double s = 250.0, E = 200e3, nu = 0.3, shear = s / std::numbers::sqrt3 * std::numbers::sqrt2;
    const double held = 281.271975;  // s / sqrt(1 - nu + nu^2)
    for (const Path& path : {Path{"equibiaxial", {1, 1, 0, 0}, s * (1 - nu) / E, {s, s, 0, 0}, {s, s, 0, 0}},
                             Path{"shear", {0, 0, 0, 1}, shear * (1 + nu) / E, {0, 0, 0, shear}, {0, 0, 0, shear}},
                             Path{"no lateral strain",
                                  {0, 1, 0, 0},
                                  held * (1 - nu * nu) / E,
                                  {nu * held, held, 0, 0},
                                  {0.5 * 288.675135, 288.675135, 0, 0}}}) {
        for (const double sign : {1.0, -1.0}) {
            MaterialPoint point = sheet_point(linear_hardening(s));
            point.strain_by(sign * path.strain_at_yield * (1.0 - 2e-9) * path.strain);
            EXPECT_FALSE(point.last().yields) << path.name;
            EXPECT_LT((point.last().stress() - sign * path.at_yield).norm(), 2e-6) << path.name;
            point.strain_by(sign * path.strain_at_yield * 4e-9 * path.strain);
            EXPECT_TRUE(point.last().yields) << path.name;
            for (int step = 0; step < 200; ++step) point.strain_by(sign * 2e-4 * path.strain);
            EXPECT_LT((point.last().stress() - sign * path.at_collapse).norm(), 2e-6) << path.name;
        }
    }
}

/// The law of plane strain with the zz strain that leaves no zz stress.
PointUpdate update_without_through_stress(const fine::MaterialLaw& law, const std::vector<double>& committed,
                                          Mandel increment) {
    for (int iteration = 0; iteration < 100; ++iteration) {
        PointUpdate update = update_point(law, committed, increment);
        if (std::abs(update.stress()[2]) <= 1e-13 * (1.0 + update.stress().norm())) return update;
        increment[2] -= update.stress()[2] / update.tangent(2, 2);
    }
    throw std::runtime_error("material point: zz strain not found");
}

class EveryLawInPlaneStress : public testing::TestWithParam<Law> {};

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryLawInPlaneStress,
                         testing::ValuesIn(catalogue().begin(), catalogue().begin() + std::ssize(catalogue()) / 2),
                         [](const auto& law) { return law.param.name; });

TEST_P(EveryLawInPlaneStress, EqualsPlaneStrainWithTheThroughStressBroughtToZero) {
    std::mt19937 random(3);
    const MaterialSection& section = GetParam().material;
    const auto thick = fine::make_material_law(section, PlaneState::Strain);
    const auto thin = fine::make_material_law(section, PlaneState::Stress);
    for (const double size : {3e-4, 1.5e-3, 2e-2}) {
        std::normal_distribution<double> normal(0.0, size);
        std::vector<double> committed(at(thin->state_size()), 0.0);
        for (int step = 0; step < 100; ++step) {
            const Mandel increment{normal(random), normal(random), 0.0, normal(random)};
            const PointUpdate found = update_point(*thin, committed, increment);
            const PointUpdate expected = update_without_through_stress(*thick, committed, increment);
            EXPECT_EQ(found.yields, expected.yields);
            EXPECT_LT((found.stress() - expected.stress()).norm(), 1e-10 * (1.0 + expected.stress().norm()));
            for (std::size_t c = 4; c < committed.size(); ++c)
                EXPECT_NEAR(found.state[c], expected.state[c], 1e-10 * (1.0 + std::abs(expected.state[c]))) << c;
            const MandelMatrix unlike = found.tangent - without_through_stress(expected.tangent);
            // Without a potential each is the symmetric part of what the other is not.
            EXPECT_LT(unlike.norm(), (has_potential(section) ? 1e-10 : 0.1) * thin->elastic().norm());
            committed = found.state;
        }
    }
}

/// Whatever its moduli, plane stress is plane strain with E (1 + 2 nu) / (1 + nu)^2 and nu / (1 + nu).
TEST(PlaneStress, ElementsAreThoseOfPlaneStrainWithOtherModuli) {
    const double nu = sheet.poisson;
    const Elasticity other{sheet.young * (1.0 + 2.0 * nu) / ((1.0 + nu) * (1.0 + nu)), nu / (1.0 + nu)};
    EXPECT_NEAR(other.plane_modulus(), sheet.plane_modulus(), 1e-9);
    EXPECT_NEAR(other.kolosov(), sheet.kolosov(), 1e-14);
    const EnrichedMesh mesh = cracked(distorted(square_mesh(5), 0.02), {{0.0, 0.43}, {0.57, 0.51}});
    for (int e = 0; e < static_cast<int>(mesh.elements.size()); ++e) {
        const ElementOperator op =
            make_operator(mesh, e, piece_in(mesh, e), {.subcells = 2, .mean_dilatation = MeanDilatation::Nowhere});
        const Eigen::MatrixXd K = op.stiffness(sheet.stiffness());
        EXPECT_LT((K - op.stiffness(other.stiffness())).norm(), 1e-13 * K.norm());
        const Eigen::VectorXd u = Eigen::VectorXd::Random(K.rows());
        Eigen::VectorXd force = Eigen::VectorXd::Zero(K.rows());
        for (std::size_t q = 0; q < op.points.size(); ++q) {
            const Mandel strain = op.strain(u, q);
            EXPECT_EQ(strain[2], 0.0);
            EXPECT_LT((strain - op.strain_matrix(q) * u).norm(), 1e-12 * strain.norm());
            op.add_force(sheet.stiffness() * strain, q, force);
        }
        EXPECT_LT((force - K * u).norm(), 1e-12 * K.norm());
    }
}

/// Largest force out of balance on any unknown, jumps and tip functions included, under the uniaxial stress along a
/// crack, relative to the largest that its parts could make.
double imbalance_of_tension_along(const Mesh& mesh, const Vec2& from, const Vec2& to) {
    const Vec2 along = (to - from).normalized();
    const Eigen::Matrix2d stress = 100.0 * along * along.transpose();
    coarse::Scene scene = make_scene(mesh, cracked(mesh, {from, to}), sheet, boundary_tractions(mesh, stress));
    const Eigen::Matrix2d gradient = gradient_of(stress, sheet);
    Eigen::VectorXd u = Eigen::VectorXd::Zero(scene.enriched.unknowns);
    for (int n = 0; n < static_cast<int>(mesh.nodes.size()); ++n)
        u.segment<2>(scene.enriched.unknown(n, 0, 0)) = gradient * mesh.nodes[at(n)];
    for (const int node : boundary_nodes(mesh)) {
        const int first = scene.enriched.unknown(node, 0, 0);
        for (int k = 0; k < 2 * (1 + static_cast<int>(scene.enriched.terms[at(node)].size())); ++k)
            scene.prescribed.push_back({first + k, u[first + k]});
    }
    const SparseMatrix K = coarse::Structure(scene).elements().stiffness();
    const Eigen::VectorXd scale = K.cwiseAbs() * u.cwiseAbs();
    return (K * u - scene.unit_force).cwiseAbs().maxCoeff() / scale.maxCoeff();
}

TEST(PlaneStress, PatchTestOfUncutCutAndTipElements) {
    EXPECT_NEAR(gradient_of(Vec2(100.0, 0.0).asDiagonal().toDenseMatrix(), sheet)(0, 0), 100.0 / sheet.young, 1e-18);
    for (int k = 0; k < 20; ++k) {
        const Mesh mesh = k % 2 == 0 ? square_mesh(6) : distorted(square_mesh(6), 0.02);
        const Vec2 tip(0.5 + 0.2 * std::sin(5.0 * k), 0.5 + 0.2 * std::cos(9.0 * k));
        const Vec2 along(std::cos(0.7 * k), std::sin(0.7 * k));
        EXPECT_LT(imbalance_of_tension_along(mesh, tip - 2.0 * along, tip), 1e-12) << k;
        EXPECT_LT(imbalance_of_tension_along(mesh, tip - 2.0 * along, tip + 2.0 * along), 1e-12) << k;
    }
}

// Half the opening behind the tip is 4 K sqrt(r / 2 pi) / E' (docs/references.md 2.6).
TEST(PlaneStress, CrackOpensByFourOverE) {
    const Tip tip{.crack = 0, .position = {0.0, 0.0}, .direction = {1.0, 0.0}, .s = 0.0, .upper = 1};
    const TipField face = williams_field(1, tip, {-1.0, 0.0}, 1, sheet);
    EXPECT_NEAR(face.displacement.y() * sheet.young, 4.0 / std::sqrt(2.0 * std::numbers::pi), 1e-12);
    for (const int mode : {1, 2}) {
        const TipField field = williams_field(mode, tip, {-0.7, 0.0}, 1, sheet);
        EXPECT_LT((in_plane(field.stress) * Vec2(0.0, 1.0)).norm(), 1e-14);
    }
}

coarse::TipResult edge_crack(double a, PlaneState plane, double poisson = 0.3) {
    Case input;
    input.model.plane = plane;
    input.mesh = {.specimen = "sent", .width = 1.0, .height = 2.0, .size = 0.04, .grading = {}};
    input.mesh.grading = {{.at = {{a, 1.0}}, .size = 0.004, .outer_size = {}, .radius = 0.03}};
    input.material.young = 200e3;
    input.material.poisson = poisson;
    input.cracks = {{.points = {{0.0, 1.0}, {a, 1.0}}, .contact = {}}};
    input.boundaries.resize(2);
    input.boundaries[0].on = "top";
    input.boundaries[0].traction = Vec2(0.0, 1.0);
    input.boundaries[1].on = "bottom";
    input.boundaries[1].traction = Vec2(0.0, -1.0);
    const coarse::Scene scene = coarse::refined_scene(input);
    const coarse::Structure structure(scene);
    return coarse::fracture_parameters(structure, structure.expand({}, 1.0), {}).front();
}

TEST(PlaneStress, IntensityOfAnEdgeCrackIsThatOfPlaneStrain) {
    for (const auto& [a, F] : {std::pair{0.3, 1.6606}, std::pair{0.5, 2.8245}}) {
        const double K = F * std::sqrt(std::numbers::pi * a);
        const coarse::TipResult thick = edge_crack(a, PlaneState::Strain), thin = edge_crack(a, PlaneState::Stress);
        EXPECT_NEAR(thin.K_I, K, 0.01 * K);
        EXPECT_NEAR(thin.K_I, thick.K_I, 0.005 * K);  // what the mesh leaves
        EXPECT_NEAR(thin.J, K * K / 200e3, 0.01 * K * K / 200e3);
        EXPECT_NEAR(thin.J, thin.K_I * thin.K_I / 200e3, 0.005 * thin.J);
        EXPECT_NEAR(thin.CMOD / thick.CMOD, 1.0 / (1.0 - 0.09), 0.01);  // E' alone
    }
}

}  // namespace
}  // namespace stria::test
