#include "fine/opening_faces.hpp"

#include "common/fem/element_operator.hpp"

namespace stria::fine {

void OpeningFaces::open(const EnrichedMesh& before, const EnrichedMesh& next, const Eigen::VectorXd& held) {
    Eigen::VectorXd is_new = Eigen::VectorXd::Zero(before.unknowns);
    for (const int unknown : jumps_) is_new[unknown] = 1.0;
    is_new = carry_over(before, is_new, next, Eigen::VectorXd::Ones(next.unknowns));
    jumps_.clear();
    for (const auto& [node, term, unknown] : next.own_unknowns())
        if (term > 0 && is_new[unknown] != 0.0) jumps_.insert(jumps_.end(), {unknown, unknown + 1});
    held_ = gather(held, jumps_);
}

double OpeningFaces::release(const Eigen::VectorXd& move) {
    const double released = jumps_.empty() ? 0.0 : 0.5 * held_.dot(gather(move, jumps_));
    jumps_.clear();
    return released;
}

}  // namespace stria::fine
