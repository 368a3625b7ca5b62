#include "fine/contact/contact_interface.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "common/index.hpp"

namespace stria::fine {
namespace {

/// Of a step: what closed multipliers without jumps of their own give way, or the matrix would be singular. The
/// solution does not change, since nothing gives way where no step is left.
constexpr double given_way = 1e-3;

}  // namespace

ContactInterface::ContactInterface(const EnrichedMesh& mesh, const std::vector<int>& boundary,
                                   const std::vector<CrackSection>& cracks, int subcells, double stiffness,
                                   const FrozenTips& frozen)
    : operators_(mesh, boundary, cracks, subcells, frozen), augmentation_(multipliers()),
      resting_(multipliers(), tractions()) {
    for (int k = 0; k < multipliers(); ++k) {
        const double length = operators_.is_stable(k) ? operators_.weight(k) : operators_.weights().maxCoeff();
        augmentation_[k] = 0.1 * stiffness / length;
    }
    status_.assign(at(multipliers()), FaceStatus::Open);
    committed_status_ = status_;
    settled_gap_ = settled_slip_ = Eigen::VectorXd::Zero(multipliers());
    forget_approach();
    const SparseRows& B = operators_.operator_B();
    closing_ = (B.cwiseAbs() * Eigen::VectorXd::Ones(B.cols())).cwiseQuotient(operators_.weights());
    std::set<int> jumping;
    for (Eigen::Index k = 0; k < B.rows(); ++k)
        for (SparseRows::InnerIterator it(B, k); it; ++it) jumping.insert(static_cast<int>(it.col()));
    jump_unknowns_.assign(jumping.begin(), jumping.end());
}

ContactInterface::Jumps ContactInterface::jumps(const Eigen::VectorXd& u) const {
    return {operators_.gaps(u), operators_.slips(u) - settled_slip_ - approach_.until_met};
}

ContactInterface::Jumps ContactInterface::jumps_that_matter(const Eigen::VectorXd& u, const Eigen::VectorXd& traction,
                                                            coupling::WorkCounts& work) const {
    if (multipliers() == 0) return {};
    const double moved =
        (1.0 + 1e-9) * (gather(u, jump_unknowns_) - settled_jumps_).lpNorm<Eigen::Infinity>();  // rounding included
    Jumps jumps{settled_gap_ - moved * closing_, Eigen::VectorXd::Zero(multipliers())};
    for (int k = 0; k < multipliers(); ++k) {
        if (resting_.contains(k)) {
            jumps.gap[k] = settled_gap_[k];
            continue;
        }
        const bool surely_open = !is_closed(status_[at(k)]) && traction[k] <= 0.0 && jumps.gap[k] > 0.0;
        ++(surely_open ? work.gaps_proven_open : work.gaps_evaluated);
        if (surely_open) continue;
        jumps.gap[k] = operators_.gap(k, u);
        if (shear_of(k) >= 0) jumps.slip[k] = operators_.slip(k, u) - settled_slip_[k] - approach_.until_met[k];
    }
    return jumps;
}

void ContactInterface::begin_increment(bool apart) {
    status_ = committed_status_;
    begins_apart_ = apart;
    if (apart)
        for (int k = 0; k < multipliers(); ++k)
            if (!resting_.contains(k)) status_[at(k)] = FaceStatus::Open;
    search_.begin();
    changes_ = 0;
}

void ContactInterface::begin_touching() { committed_status_.assign(at(multipliers()), FaceStatus::Stick); }

void ContactInterface::commit(const Eigen::VectorXd& u, double next_over_this) {
    for (int k = 0; k < multipliers(); ++k)
        if (status_[at(k)] != committed_status_[at(k)]) resting_.note_change(k);
    const Eigen::VectorXd gap = settled_gap_, slip = settled_slip_;
    settle(u);
    for (const int k : operators_.with_shear()) {
        const bool apart = !is_closed(committed_status_[at(k)]) && !is_closed(status_[at(k)]);
        const FaceJumps before{approach_.widened[k], approach_.slid[k]};
        const FaceJumps last{apart ? settled_gap_[k] - gap[k] : 0.0, apart ? settled_slip_[k] - slip[k] : 0.0};
        approach_.widened[k] = last.gap;
        approach_.slid[k] = last.slip;
        approach_.until_met[k] = slip_until_met(settled_gap_[k], last, before, next_over_this);
    }
    committed_status_ = status_;
}

void ContactInterface::forget_approach() {
    approach_.widened = approach_.slid = approach_.until_met = Eigen::VectorXd::Zero(multipliers());
}

void ContactInterface::restore(std::vector<FaceStatus> statuses, Approach approach) {
    status_ = committed_status_ = std::move(statuses);
    approach_ = std::move(approach);
}

void ContactInterface::settle(const Eigen::VectorXd& u) {
    settled_jumps_ = gather(u, jump_unknowns_);
    settled_gap_ = operators_.gaps(u);
    settled_slip_ = operators_.slips(u);
}

FaceState ContactInterface::state_of(int k, const Eigen::VectorXd& traction, const Jumps& jumps) const {
    return {traction[k], shear_of(k) >= 0 ? traction[shear_of(k)] : 0.0, jumps.gap[k], jumps.slip[k]};
}

void ContactInterface::choose_statuses(const Eigen::VectorXd& traction, const Jumps& jumps) {
    std::vector<FaceStatus> next(status_.size());
    int worst = -1;
    double largest = 0.0;
    changes_ = 0;
    if (std::exchange(begins_apart_, false)) return;
    for (int k = 0; k < multipliers(); ++k) {
        const FaceState state = state_of(k, traction, jumps);
        next[at(k)] = resting_.contains(k) ? status_[at(k)] : status_at(k, state);
        if (next[at(k)] == status_[at(k)]) continue;
        ++changes_;
        const double violation = law(k).violation(state, status_[at(k)]);
        if (!(violation < largest)) {  // nor is it less that is not a number: some one is the worst
            largest = violation;
            worst = k;
        }
    }
    if (changes_ == 0) return;
    status_ = search_.next(status_, std::move(next), worst);
    if (search_.one_at_a_time()) changes_ = 1;
}

double ContactInterface::residual(const Eigen::VectorXd& traction, const Jumps& jumps) const {
    double largest = 0.0;
    for (int k = 0; k < multipliers(); ++k) {
        if (resting_.contains(k)) continue;
        const FaceState state = state_of(k, traction, jumps);
        const double off = std::max(std::abs(law(k).pressure_residual(state)), std::abs(law(k).shear_residual(state)));
        largest = std::max(largest, operators_.weight(k) * off);
    }
    return largest;
}

Eigen::VectorXd ContactInterface::right_hand_side(const Eigen::VectorXd& traction, const Jumps& jumps) const {
    Eigen::VectorXd right = Eigen::VectorXd::Zero(tractions());
    for (int k = 0; k < multipliers(); ++k) {
        if (resting_.contains(k)) continue;
        const FaceStatus status = status_[at(k)];
        right[k] = is_closed(status) ? operators_.weight(k) * jumps.gap[k]
                                     : operators_.weight(k) * traction[k] / augmentation_[k];
        const int shear = shear_of(k);
        if (shear < 0) continue;
        const double bound = fine::slides(status) ? signed_friction(status, operators_.friction(k)) * traction[k] : 0.0;
        right[shear] = status == FaceStatus::Stick
                           ? -operators_.weight(k) * jumps.slip[k]
                           : operators_.weight(k) / augmentation_[k] * (traction[shear] - bound);
    }
    return right;
}

// Closed faces keep the rounding of a gap otherwise: their equation goes on from it.
Eigen::VectorXd ContactInterface::rest_load(const Eigen::VectorXd& displacement) const {
    Eigen::VectorXd force = Eigen::VectorXd::Zero(displacement.size()), right = Eigen::VectorXd::Zero(tractions());
    operators_.add_force(resting_.traction() - awake(resting_.traction()), force);
    for (const int k : resting_.multipliers().members())
        if (is_closed(status_[at(k)])) right[k] = operators_.weight(k) * operators_.gap(k, displacement);
    Eigen::VectorXd load(force.size() + right.size());
    load << -force, right;
    return load;
}

std::vector<int> ContactInterface::would_change(const Eigen::VectorXd& u, const Eigen::VectorXd& traction,
                                                Jumps& jumps) const {
    std::vector<int> found;
    for (const int k : resting_.multipliers().members()) {
        jumps.gap[k] = operators_.gap(k, u);
        if (status_at(k, state_of(k, traction, jumps)) != status_[at(k)]) found.push_back(k);
    }
    return found;
}

Eigen::VectorXd ContactInterface::awake(Eigen::VectorXd traction) const {
    for (const int k : resting_.multipliers().members()) {
        traction[k] = 0.0;
        if (shear_of(k) >= 0) traction[shear_of(k)] = 0.0;
    }
    return traction;
}

double ContactInterface::residual_at_rest(const Eigen::VectorXd& right_hand_side) const {
    double largest = 0.0;
    for (const int k : resting_.multipliers().members()) {
        largest = std::max(largest, augmentation_[k] * std::abs(right_hand_side[k]));
        if (shear_of(k) >= 0) largest = std::max(largest, augmentation_[k] * std::abs(right_hand_side[shear_of(k)]));
    }
    return largest;
}

std::vector<int> ContactInterface::unknowns_of(int k, int first_traction) const {
    std::vector<int> unknowns = operators_.acts_on(k);
    unknowns.push_back(first_traction + k);
    if (shear_of(k) >= 0) unknowns.push_back(first_traction + shear_of(k));
    return unknowns;
}

Eigen::MatrixXd ContactInterface::matrix_of(int k) const {
    const std::vector<int> acts_on = operators_.acts_on(k);
    const bool has_shear = shear_of(k) >= 0;
    const Eigen::Index pressure = std::ssize(acts_on), shear = pressure + 1, size = pressure + (has_shear ? 2 : 1);
    const FaceStatus status = status_[at(k)];
    const double idle = -operators_.weight(k) / augmentation_[k];
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
    if (status != FaceStatus::Stick && has_shear) matrix(shear, shear) = idle;
    if (!is_closed(status)) {
        matrix(pressure, pressure) = idle;
        return matrix;
    }
    if (!operators_.is_stable(k)) {
        matrix(pressure, pressure) = given_way * idle;
        if (status == FaceStatus::Stick && has_shear) matrix(shear, shear) = given_way * idle;
    }
    for (Eigen::Index i = 0; i < pressure; ++i) {
        matrix(i, pressure) = matrix(pressure, i) = -operators_.operator_B().coeff(k, acts_on[at(i)]);
        if (!has_shear) continue;
        matrix(i, shear) = operators_.operator_T().coeff(k, acts_on[at(i)]);
        if (status == FaceStatus::Stick) matrix(shear, i) = matrix(i, shear);
    }
    if (fine::slides(status)) matrix(shear, pressure) = -idle * signed_friction(status, operators_.friction(k));
    return matrix;
}

void ContactInterface::clean(Eigen::VectorXd& traction) const {
    for (int k = 0; k < multipliers(); ++k) {
        const FaceStatus status = status_[at(k)];
        if (!is_closed(status)) traction[k] = 0.0;
        if (shear_of(k) >= 0 && status != FaceStatus::Stick)
            traction[shear_of(k)] = signed_friction(status, operators_.friction(k)) * traction[k];
    }
}

double ContactInterface::dissipated(const Eigen::VectorXd& before, const Eigen::VectorXd& after,
                                    const Jumps& jumps) const {
    double sum = 0.0;
    for (const int k : operators_.with_shear()) {
        const bool closed = is_closed(status_[at(k)]);
        if (closed && !slides(k)) continue;
        const FaceState from = state_of(k, before, jumps);
        sum += operators_.weight(k) * operators_.friction(k) *
               (closed ? law(k).pressure_times_slip(from, after[k]) : law(k).pressure_times_slip_until_open(from));
    }
    return sum;
}

// Beyond the last node of a branch a share may be negative: what it makes of pressure and shear is not.
ContactInterface::FaceTraction ContactInterface::traction_of(const FaceOperators::Acting& acting,
                                                             const Eigen::VectorXd& traction) const {
    FaceTraction sum;
    double largest = 0.0, friction = 0.0;
    for (const auto& [multiplier, value] : acting) {
        if (multiplier < 0) continue;
        sum.pressure += value * traction[multiplier];
        if (shear_of(multiplier) < 0) continue;
        sum.shear += value * traction[shear_of(multiplier)];
        friction = operators_.friction(multiplier);
        if (value > largest) sum.slides = slides(multiplier);
        largest = std::max(largest, value);
    }
    sum.pressure = std::max(sum.pressure, 0.0);
    const double bound = friction * sum.pressure;
    sum.shear = std::clamp(sum.shear, -bound, bound);
    return sum;
}

std::vector<ContactInterface::FaceTraction>
ContactInterface::tractions_at_stations(const Eigen::VectorXd& traction) const {
    std::vector<FaceTraction> all;
    std::ranges::transform(operators_.acting(), std::back_inserter(all),
                           [&](const FaceOperators::Acting& acting) { return traction_of(acting, traction); });
    return all;
}

}  // namespace stria::fine
