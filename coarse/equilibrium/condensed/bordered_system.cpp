#include "coarse/equilibrium/condensed/bordered_system.hpp"

#include "common/linear/lower_triangle.hpp"

namespace stria::coarse {

void BorderedSystem::factor(const std::function<CondensedTangent()>& tangent, const LinearReading& controlled) {
    const auto make = [&] {
        CondensedTangent A = tangent();
        const Eigen::VectorXd& w = controlled.weights;
        sigma_ = controlled.is_load_factor() ? 0.0 : A.matrix.diagonal().mean() / w.squaredNorm();
        if (sigma_ != 0.0 && A.symmetry == Symmetry::Symmetric)
            A.matrix.selfadjointView<Eigen::Lower>().rankUpdate(w, sigma_);
        else if (sigma_ != 0.0)
            A.matrix.noalias() += sigma_ * w * w.transpose();
        return A;
    };
    CondensedTangent A = make();
    definite_ = A.symmetry == Symmetry::Symmetric && factor_.factor(std::move(A.matrix));
    if (definite_) return;
    if (A.symmetry == Symmetry::Symmetric) {
        A = make();
        mirror_lower(A.matrix);
    }
    general_factor_.compute(A.matrix);
}

GammaState BorderedSystem::solve(const Eigen::VectorXd& residual, double off_target,
                                 const Eigen::VectorXd& load_derivative, const LinearReading& controlled) const {
    const auto& [w, k, constant, per_case] = controlled;
    Eigen::MatrixXd right(w.size(), 2);
    right << residual + sigma_ * off_target * w, load_derivative - sigma_ * k * w;
    const Eigen::MatrixXd x = definite_ ? factor_.solve(right) : Eigen::MatrixXd(general_factor_.solve(right));
    const double load_factor = (off_target - w.dot(x.col(0))) / (k + w.dot(x.col(1)));
    return {x.col(0) + load_factor * x.col(1), load_factor};
}

}  // namespace stria::coarse
