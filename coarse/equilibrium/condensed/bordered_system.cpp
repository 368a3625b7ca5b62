#include "coarse/equilibrium/condensed/bordered_system.hpp"

namespace stria::coarse {

void BorderedSystem::factor(const std::function<Eigen::MatrixXd()>& tangent, Symmetry symmetry,
                            const LinearReading& controlled) {
    const auto make = [&] {
        Eigen::MatrixXd A = tangent();
        const Eigen::VectorXd& w = controlled.weights;
        sigma_ = controlled.is_load_factor() ? 0.0 : A.diagonal().mean() / w.squaredNorm();
        if (sigma_ != 0.0) A.noalias() += sigma_ * w * w.transpose();
        return A;
    };
    definite_ = symmetry == Symmetry::Symmetric && factor_.factor(make());
    if (!definite_) general_factor_.compute(make());
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
