#include "fine/growth/opening_faces.hpp"

#include <algorithm>

#include "common/index.hpp"
#include "common/integration/element_operator.hpp"

namespace stria::fine {

OpeningFaces::OpeningFaces(const Eigen::VectorXd& held) {
    for (int i = 0; i < held.size(); ++i)
        if (held[i] != 0.0) jumps_.push_back(i);
    held_ = gather(held, jumps_);
}

void OpeningFaces::open(const EnrichedMesh& before, const EnrichedMesh& next, const Eigen::VectorXd& held) {
    const Eigen::VectorXd still = this->held(before.unknowns);
    const std::vector<int> same = same_unknowns(next, before);
    Eigen::VectorXd all = Eigen::VectorXd::Zero(next.unknowns);
    for (const auto& [node, term, unknown] : next.own_unknowns()) {
        const int own = same[at(unknown)];
        if (own >= 0)
            all.segment<2>(unknown) = still.segment<2>(own);
        else if (term > 0)
            all.segment<2>(unknown) = held.segment<2>(unknown);
    }
    *this = OpeningFaces(all);
}

void OpeningFaces::follow(const EnrichedMesh& before, const EnrichedMesh& next) {
    if (any())
        *this = OpeningFaces(carry_over(before, held(before.unknowns), next, Eigen::VectorXd::Zero(next.unknowns)));
}

void OpeningFaces::hold(double share, Eigen::VectorXd& load) const {
    if (!jumps_.empty() && share != 0.0) load(jumps_) -= share * held_;
}

void OpeningFaces::begin(const Eigen::VectorXd& first_step) { first_step_ = gather(first_step, jumps_); }

double OpeningFaces::release(const Eigen::VectorXd& move, double share) {
    if (jumps_.empty()) return 0.0;
    const Eigen::VectorXd opening = gather(move, jumps_);
    const bool begun = first_step_.size() == opening.size();
    const double opened = held_.dot(opening);
    const auto [least, most] = std::minmax({0.0, 2.0 * opened});  // beyond them the parabola turns back
    const double first = begun ? std::clamp(held_.dot(first_step_), least, most) : opened;
    const double released = share * opened + (1.0 - share) * (opened / 3.0 + first / 6.0);
    held_ *= share;
    first_step_.resize(0);
    if (share == 0.0) jumps_.clear();
    return released;
}

Eigen::VectorXd OpeningFaces::held(int unknowns) const {
    Eigen::VectorXd held = Eigen::VectorXd::Zero(unknowns);
    if (!jumps_.empty()) held(jumps_) = held_;
    return held;
}

}  // namespace stria::fine
