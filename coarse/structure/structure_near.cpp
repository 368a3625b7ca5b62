// The near part of a structure: what each increment asks of it, and what it knows of the far one.
#include "coarse/structure/structure.hpp"

#include "common/index.hpp"

namespace stria::coarse {

void Structure::find_near_supports() {
    std::vector<char> seen(leaf_index_.size(), 0);
    for_each_near([&](int, std::span<const int> own) {
        for (const int unknown : own) seen[at(unknown)] = 1;
    });
    for (const PrescribedUnknown& p : scene_.prescribed)
        if (seen[at(p.unknown)] != 0) near_supports_.push_back(p);
}

void Structure::expand_near(const Eigen::VectorXd& gamma_displacement, double load_factor, Eigen::VectorXd& u) const {
    const Eigen::VectorXd x = leaf_->expand_above(load_factor * near_load_, gather(gamma_displacement, free_places_));
    Eigen::Index k = 0;
    for (const int unknown : near_unknowns()) u[unknown] = x[k++];
    for (const PrescribedUnknown& p : near_supports_) u[p.unknown] = load_factor * p.value;
}

Eigen::VectorXd Structure::far_force(const Eigen::VectorXd& rim_displacement) const {
    if (!far_) return rim_displacement;
    return far_->tangent() * rim_displacement;
}

Eigen::VectorXd Structure::expand_far(const Eigen::VectorXd& rim_displacement) const {
    Eigen::VectorXd u = Eigen::VectorXd::Zero(scene_.enriched.unknowns);
    if (!far_) return u;
    const Eigen::VectorXd x = far_->expand({Eigen::VectorXd::Zero(far_count_), {}}, rim_displacement);
    for (int i = 0; i < far_count_; ++i) u[leaf_unknowns_[at(i)]] = x[i];
    u(rim_) = rim_displacement;
    return u;
}

}  // namespace stria::coarse
