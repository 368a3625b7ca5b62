// Whether pressures and shears are stable beside the jumps that they act on (docs/method.md, section 4): the numerical
// inf-sup constant of both multipliers together, over random cuts of a square.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <random>

#include "coarse/structure/structure.hpp"
#include "coarse/zone/refined_scene.hpp"
#include "fine/contact/contact_interface.hpp"
#include "tests/support/specimens.hpp"

namespace stria::test {
namespace {

/// A unit square of n x n elements, held at top and bottom, cut from side to side.
coarse::Scene cut_square(int n, double left, double right, MultiplierKind kind) {
    Case input = specimen("plate", 1.0, {{0.0, left}, {1.0, right}});
    input.mesh.size = 1.0 / n;
    input.fine.enrichment = Enrichment::None;
    input.cracks[0].contact = ContactSection{0.3, kind};
    input.boundaries = {at_end("top", End::Clamped, 1.0), at_end("bottom", End::Clamped, -1.0)};
    return coarse::refined_scene(input);
}

/// Stiffness with the held unknowns taken out.
Eigen::SparseMatrix<double> held_stiffness(const coarse::Scene& scene) {
    Eigen::SparseMatrix<double> K = coarse::Structure(scene).elements().stiffness();
    std::vector<char> held(at(K.rows()), 0);
    for (const coarse::PrescribedUnknown& p : scene.prescribed) held[at(p.unknown)] = 1;
    K.prune([&](Eigen::Index i, Eigen::Index j, double) { return held[at(i)] == 0 && held[at(j)] == 0; });
    for (Eigen::Index i = 0; i < K.rows(); ++i)
        if (held[at(i)] != 0 || K.coeff(i, i) == 0.0) K.coeffRef(i, i) = 1.0;
    return K;
}

/// beta^2 = the smallest of (B K^-1 B^T) : (h / E') M over pressures and shears, M their mass along the crack. Zero to
/// rounding where there are more multipliers than jumps.
double inf_sup(int n, double left, double right, MultiplierKind kind) {
    const coarse::Scene scene = cut_square(n, left, right, kind);
    const fine::ContactInterface contact(scene.enriched, {}, scene.input.cracks, 2, plane_modulus);
    const fine::FaceOperators& faces = contact.operators();
    const int m = faces.multipliers();
    Eigen::MatrixXd B(2 * m, scene.enriched.unknowns);
    B << Eigen::MatrixXd(faces.operator_B()), Eigen::MatrixXd(faces.operator_T());
    for (const coarse::PrescribedUnknown& p : scene.prescribed) B.col(p.unknown).setZero();
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(held_stiffness(scene));
    const Eigen::MatrixXd compliance = B * factor.solve(Eigen::MatrixXd(B.transpose()));
    Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(2 * m, 2 * m);
    for (const FaceStation& station : faces.stations()) {
        const auto acting = faces.functions_at(station);
        for (const auto& [i, of_i] : acting) {
            for (const auto& [j, of_j] : acting) {
                if (i < 0 || j < 0) continue;
                mass(i, j) += station.weight * of_i * of_j;
                mass(m + i, m + j) += station.weight * of_i * of_j;
            }
        }
    }
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> ratios(compliance, mass / (n * plane_modulus));
    return std::sqrt(std::max(0.0, ratios.eigenvalues().minCoeff()));
}

struct Constants {
    double least = 1e300, most = 0.0;
};

Constants constants(int n, int cuts, MultiplierKind kind) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> offset(0.3, 0.7), rise(-0.25, 0.25);
    Constants found;
    for (int cut = 0; cut < cuts; ++cut) {
        const double middle = offset(random), half = rise(random);
        const double beta = inf_sup(n, middle - half, middle + half, kind);
        found.least = std::min(found.least, beta);
        found.most = std::max(found.most, beta);
    }
    std::cout << fmt::format("{} x {}, {}: inf-sup constant {:.3g} to {:.3g} over {} cuts\n", n, n,
                             kind == MultiplierKind::Stable ? "stable" : "one at each Gauss point", found.least,
                             found.most, cuts);
    return found;
}

void expect_bounded(int n, int cuts) { EXPECT_GT(constants(n, cuts, MultiplierKind::Stable).least, 0.3); }

TEST(InfSup, IsBoundedBelowForEveryCutAndMesh) {
    for (const int n : {11, 21, 41}) expect_bounded(n, 30);
}
// Through a side and the next one of an element's corner at the mouth, 0.5 to 1.1 of an element apart: two multipliers
// share a node there. Less far apart only one of them stands.
TEST(InfSup, IsBoundedBelowWhereTheMouthsElementLosesACorner) {
    constexpr int n = 21;
    double least = 1e300;
    for (const double slope : {-0.8, 0.8}) {
        for (const double to_node : {0.2, 0.32, 0.4, 0.5, 0.6, 0.7}) {
            const double left = slope > 0.0 ? (3.0 - to_node) / n : (18.0 + to_node) / n;
            least = std::min(least, inf_sup(n, left, left + slope, MultiplierKind::Stable));
        }
    }
    std::cout << fmt::format("corners at the mouth: inf-sup constant {:.3g} at least\n", least);
    EXPECT_GT(least, 0.3);
}
// More conditions than the jump has freedom, whatever the cut.
TEST(InfSup, IsNothingWithOneMultiplierAtEachGaussPoint) {
    for (const int n : {7, 11}) EXPECT_LT(constants(n, 10, MultiplierKind::Gauss).most, 1e-5);
}
TEST(InfSup, IsBoundedBelowOver1000CutsLong) { expect_bounded(41, 1000); }

}  // namespace
}  // namespace stria::test
