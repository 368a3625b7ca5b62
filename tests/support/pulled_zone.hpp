// A cracked plate as a zone by itself, pulled at all of its boundary: condensed, and in one matrix.
#pragma once

#include <Eigen/LU>
#include <stdexcept>

#include "fine/zone/fine_model.hpp"
#include "tests/support/plates.hpp"

namespace stria::test {

inline const Vec2 mouth_of_pulled{0.0, 2.4}, tip_of_pulled{3.3, 2.6};

/// Boundary displacements of a plate with such a crack: stretched across it by a strain, with some noise.
inline Eigen::VectorXd stretched(const coupling::Patch& zone, double strain, unsigned seed = 1, double shear = 0.0) {
    const double middle = zone.mesh.nodes.back().y() / 2.0;
    const auto pull = [&](const Vec2& x) {
        const double y = x.y() - middle;
        return Vec2(0.1 * strain * x.x() + shear * y, strain * y);
    };
    const Eigen::VectorXd u = two_sided(zone.mesh, mouth_of_pulled, tip_of_pulled, pull, pull) +
                              random_vector(zone.mesh.unknowns, 0.02 * std::abs(strain), seed);
    return gather(u, zone.boundary);
}

/// Newton's method on all interior unknowns and multipliers in one dense matrix, the boundary imposed.
class FullNewton {
public:
    FullNewton(const coupling::Patch& zone, const Case& input)
        : system_(input), modulus_(elasticity_of(input.material, input.model.plane).plane_modulus()) {
        system_.set_patch(zone);
    }

    coupling::PatchResponse begin(const Eigen::VectorXd& boundary, const Predictor& predictor) {
        system_.predict(predictor);
        return evaluate(boundary);
    }

    coupling::PatchResponse iterate(const Eigen::VectorXd& boundary) {
        const coupling::Patch& zone = system_.patch();
        const Eigen::Index n = zone.mesh.unknowns, m = system_.contact().tractions();
        Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n + m, n + m);
        for (int e = 0; e < system_.bulk().elements().count(); ++e) {
            const std::vector<int>& unknowns = system_.bulk().elements().op(e).unknowns;
            matrix(unknowns, unknowns) += system_.bulk().tangent(e);
        }
        add_contact(matrix);
        Eigen::VectorXd right(n + m);
        right << system_.load(), system_.contact_right_hand_side();
        const Eigen::VectorXd step = boundary - gather(system_.displacement(), zone.boundary);
        for (std::size_t k = 0; k < zone.boundary.size(); ++k) {
            matrix.row(zone.boundary[k]).setZero();
            matrix(zone.boundary[k], zone.boundary[k]) = 1.0;
            right[zone.boundary[k]] = step[static_cast<Eigen::Index>(k)];
        }
        const Eigen::VectorXd correction = matrix.partialPivLu().solve(right);
        system_.move(correction.head(n), correction.tail(m));
        return evaluate(boundary);
    }

    void commit(const coupling::Commit& what) { last_ = system_.commit(what); }
    [[nodiscard]] const coupling::StepReport& last() const { return last_; }
    [[nodiscard]] coupling::ZoneState state() const { return system_.state(); }
    /// On the boundary.
    [[nodiscard]] Eigen::VectorXd force() const { return -gather(system_.load(), system_.patch().boundary); }
    [[nodiscard]] const Eigen::VectorXd& displacement() const { return system_.displacement(); }

private:
    void add_contact(Eigen::MatrixXd& matrix) const {
        const fine::ContactInterface& contact = system_.contact();
        const fine::FaceOperators& faces = contact.operators();
        const Eigen::MatrixXd B = faces.operator_B(), T = faces.operator_T();
        const Eigen::Index n = B.cols();
        for (int k = 0; k < contact.multipliers(); ++k) {
            const fine::FaceStatus status = contact.statuses()[at(k)];
            const double idle = -faces.weight(k) * faces.weight(k) / (0.1 * modulus_);
            const Eigen::Index p = n + k, q = n + contact.shear_of(k);
            matrix.col(p).head(n) = -B.row(k).transpose();
            if (status == fine::FaceStatus::Open)
                matrix(p, p) = idle;
            else
                matrix.row(p).head(n) = -B.row(k);
            if (q < n) continue;
            matrix.col(q).head(n) = T.row(k).transpose();
            if (status == fine::FaceStatus::Stick)
                matrix.row(q).head(n) = T.row(k);
            else
                matrix(q, q) = idle;
            if (contact.slides(k))
                matrix(q, p) = (status == fine::FaceStatus::SlipBack ? idle : -idle) * faces.friction(k);
        }
    }

    coupling::PatchResponse evaluate(const Eigen::VectorXd& boundary) {
        system_.set_boundary(boundary);
        system_.linearise();
        return system_.measure();
    }
    fine::ZoneSystem system_;
    double modulus_;
    coupling::StepReport last_;
};

}  // namespace stria::test
