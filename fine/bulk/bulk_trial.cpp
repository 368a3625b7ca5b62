// What a displacement makes of the zone's metal: trial states, forces and tangents.
#include <algorithm>
#include <cmath>
#include <utility>

#include "fine/bulk/bulk.hpp"

namespace stria::fine {

void Bulk::evaluate(const Eigen::VectorXd& u, bool elastic, double slight) {
    trial_u_ = u;
    increment_ = u - committed_u_;
    slight_ = slight;
    for (const int e : resting_.awake()) {
        if (!elastic && !stand_.proves_at(e, u)) {
            proven_.erase(e);
            continue;
        }
        proven_.insert(e);
        stand_.find_force(e, u, elements_, trial_force_);
    }
    update_points();
    changed_ = ElementSet(elements_.count());
    counts_.points_at_rest += history_.points();
    for (const int e : resting_.awake()) {
        counts_.points_at_rest -= history_.points(e);
        evaluate_element(e);
    }
    sum_forces();
}

void Bulk::evaluate_again(const std::vector<int>& elements, const Eigen::VectorXd& u) {
    for (const int e : elements) {
        for (const int unknown : elements_.op(e).unknowns) {
            trial_u_[unknown] = u[unknown];
            increment_[unknown] = u[unknown] - committed_u_[unknown];
        }
        proven_.erase(e);
        update_points(e);
        evaluate_element(e);
    }
}

void Bulk::evaluate_element(int e) {
    with_kernel(elements_.op(e), [&](const auto& kernel) {
        find_trial_force(e, kernel);
        find_tangent(e, kernel);
    });
}

void Bulk::sum_forces() {
    force_.setZero();
    force_scale_.setZero();
    for (const int e : resting_.awake()) add_trial_force(e);
}

// In as long blocks as there are. Where points do not stand at what is committed they go there first: the direction of
// an increment is not that of the way before.
void Bulk::update_points() {
    int begin = 0, end = 0;
    for (const int e : resting_.awake()) {
        if (proven_.contains(e)) continue;
        if (!stand_.stands_at(elements_.op(e), e, standing_displacement(e))) {
            update_points(e);
            continue;
        }
        if (e != end) history_.update(operators(), std::exchange(begin, e), end, increment_);
        end = e + 1;
    }
    history_.update(operators(), begin, end, increment_);
}

void Bulk::update_points(int e) {
    const ElementOperator& op = elements_.op(e);
    if (stand_.stands_at(op, e, standing_displacement(e)))
        history_.update(op, e, gather(e, increment_));
    else
        history_.update(op, e, stand_.ahead(op, e, standing_displacement(e)), gather(e, increment_));
}

template <class Kernel> void Bulk::find_trial_force(int e, const Kernel& kernel) {
    if (proven_.contains(e)) {
        history_.set_elastic(e);
        counts_.points_proven_elastic += history_.points(e);
        return;
    }
    const auto force = kernel.force(history_.trial_stresses(e), history_.points());
    std::copy_n(force.data(), force.size(), trial_force_.of(e).data());
}

void Bulk::add_trial_force(int e) {
    const auto force = trial_force_.of(e);
    const std::vector<int>& unknowns = elements_.op(e).unknowns;
    for (Eigen::Index k = 0; k < force.size(); ++k) {
        force_[unknowns[at(k)]] += force[k];
        force_scale_[unknowns[at(k)]] += std::abs(force[k]);
    }
}

// The elastic matrix plus what yielding takes away at the points that yield.
template <class Kernel> void Bulk::find_tangent(int e, const Kernel& kernel) {
    const bool softens = history_.yields(e) && !(history_.largest_plastic_increment(e) < slight_);
    if (softens || softened_.contains(e)) changed_.insert(e);
    if (!softens) {
        softened_.erase(e);
        ++counts_.elastic_tangents_reused;
        return;
    }
    softened_.insert(e);
    ++counts_.tangents_computed;
    typename Kernel::Matrix K = elements_.stiffness()[at(e)];
    for (std::size_t q = 0; q < at(history_.points(e)); ++q)
        if (history_.yields(e, q)) kernel.add_stiffness(history_.tangent(e, q) - elements_.elastic_stiffness(e), q, K);
    tangents_[at(e)] = K;
}

}  // namespace stria::fine
