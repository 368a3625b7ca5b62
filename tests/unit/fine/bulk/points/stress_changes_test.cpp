// By how much a displacement changes stresses, against the stresses at all points of an element.
#include "fine/bulk/points/stress_changes.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <limits>

#include "tests/support/cracked_mesh.hpp"
#include "tests/support/plates.hpp"

namespace stria::test {
namespace {

const MandelMatrix elastic = Elasticity{200e3, 0.3}.stiffness();

/// The form of the largest square of a von Mises stress at a point, of element values.
Eigen::MatrixXd square_at(const ElementOperator& op, std::size_t q) {
    const Eigen::Matrix<double, 4, Eigen::Dynamic> stress = elastic * op.strain_matrix(q);
    Eigen::MatrixXd deviators = stress;
    for (Eigen::Index k = 0; k < stress.cols(); ++k) deviators.col(k) = deviator(stress.col(k));
    return 1.5 * deviators.transpose() * deviators;
}

double largest_square(const ElementOperator& op, const Eigen::VectorXd& moved) {
    double largest = 0.0;
    for (std::size_t q = 0; q < op.points.size(); ++q) largest = std::max(largest, moved.dot(square_at(op, q) * moved));
    return largest;
}

/// 5 x 5 unit elements that a crack cuts to the middle, the inner nodes moved by up to `crooked` mm.
struct Plate {
    explicit Plate(double crooked)
        : mesh(cracked(distorted(square_mesh(5, 5.0), crooked), {{0.0, 2.4}, {2.6, 2.4}}, 1)) {
        for (int e = 0; e < std::ssize(mesh.elements); ++e) {
            IntegrationRule rule{.subcells = 2, .tip_points = 4};
            ops.push_back(make_operator(mesh, e, piece_in(mesh, e), rule));
            std::array<Vec2, 4> corners;
            for (std::size_t k = 0; k < 4; ++k) corners[k] = mesh.nodes[at(mesh.elements[at(e)][k])];
            changes.add_element(ops.back(), corners, fine::VonMisesForm(elastic));
        }
    }
    /// Element by element from what was looked at.
    void expect_limits(const Eigen::VectorXd& looked_at, const Eigen::VectorXd& u) {
        constexpr double rounding = 1e-10;
        for (std::size_t e = 0; e < ops.size(); ++e) {
            const int element = static_cast<int>(e);
            changes.look_at(element, gather(looked_at, ops[e].unknowns));
            const double largest = largest_square(ops[e], gather(u - looked_at, ops[e].unknowns));
            if (largest == 0.0) continue;
            EXPECT_TRUE(changes.stay_below(element, u, (1.0 + rounding) * largest)) << e;
            EXPECT_FALSE(changes.stay_below(element, u, (1.0 - rounding) * largest)) << e;
        }
    }

    EnrichedMesh mesh;
    std::vector<ElementOperator> ops;
    fine::StressChanges changes;
};

TEST(StressChanges, AreTheLargestOfAllPoints) {
    for (const double crooked : {0.0, 0.3}) {
        Plate plate(crooked);
        for (unsigned seed = 1; seed < 60; ++seed)
            plate.expect_limits(random_vector(plate.mesh.unknowns, 1e-3, seed),
                                random_vector(plate.mesh.unknowns, 1e-3, seed + 100));
    }
}

// The motions that the size of a motion tells most of.
TEST(StressChanges, AreToldByNoMotionThatIsLarger) {
    Plate plate(0.0);
    const ElementOperator& op = plate.ops[4];  // a corner's
    for (std::size_t q = 0; q < op.points.size(); ++q) {
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(square_at(op, q));
        for (const Eigen::Index mode : {5, 6, 7}) {
            Eigen::VectorXd u = Eigen::VectorXd::Zero(plate.mesh.unknowns);
            for (std::size_t k = 0; k < op.unknowns.size(); ++k)
                u[op.unknowns[k]] = 1e-3 * modes.eigenvectors()(static_cast<Eigen::Index>(k), mode);
            plate.expect_limits(Eigen::VectorXd::Zero(u.size()), u);
        }
    }
}

TEST(StressChanges, OfAUniformShearAreThoseOfItsModulus) {
    Plate plate(0.15);
    Eigen::VectorXd u = Eigen::VectorXd::Zero(plate.mesh.unknowns);
    for (const auto& [node, term, unknown] : plate.mesh.own_unknowns())
        if (term == 0) u[unknown] = 1e-3 * plate.mesh.nodes[at(node)].y();
    const double tau = 200e3 / 2.6 * 1e-3, square = 3.0 * tau * tau;
    for (int e = 0; e < std::ssize(plate.ops); ++e) {
        EXPECT_TRUE(plate.changes.stay_below(e, u, (1.0 + 1e-9) * square));
        EXPECT_FALSE(plate.changes.stay_below(e, u, (1.0 - 1e-9) * square));
    }
}

TEST(StressChanges, ProveNothingWhereTheyAreNoNumbers) {
    Plate plate(0.0);
    for (int e = 0; e < std::ssize(plate.ops); ++e) {
        for (const int unknown : plate.ops[at(e)].unknowns) {
            Eigen::VectorXd u = Eigen::VectorXd::Zero(plate.mesh.unknowns);
            u[unknown] = std::numeric_limits<double>::quiet_NaN();
            EXPECT_FALSE(plate.changes.stay_below(e, u, 1e30)) << e;
        }
    }
}

}  // namespace
}  // namespace stria::test
