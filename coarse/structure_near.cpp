// The near part of a structure: what each increment asks of it.
#include <algorithm>

#include "coarse/elastic_force.hpp"
#include "coarse/structure.hpp"

namespace stria::coarse {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// An element's part of a vector in which its unknowns have places; none (-1): zero.
template <class Operator>
typename Operator::Values values_at(std::span<const int> places, const Eigen::VectorXd& vector, const Operator&) {
    typename Operator::Values values(std::ssize(places));
    for (std::size_t i = 0; i < places.size(); ++i)
        values[static_cast<Eigen::Index>(i)] = places[i] >= 0 ? vector[places[i]] : 0.0;
    return values;
}

}  // namespace

void Structure::number_near_unknowns(const IndexLists& of_elements) {
    int first = unknowns() - static_cast<int>(free_places_.size());
    std::vector<char> seen(leaf_index_.size(), 0);
    std::size_t k = 0;
    for_each_coarse([&](int element, std::span<const int> own) {
        const std::span<const int> in_leaf = of_elements[k++];
        if (is_near_[at(element)] == 0) return;
        for (const int unknown : in_leaf)
            if (unknown >= 0) first = std::min(first, unknown);
        for (const int unknown : own) seen[at(unknown)] = 1;
    });
    near_count_ = unknowns() - first;
    for (const PrescribedUnknown& p : scene_.prescribed)
        if (seen[at(p.unknown)] != 0) near_supports_.push_back(p);
    find_rim(of_elements, first);
}

void Structure::find_rim(const IndexLists& of_elements, int first_near) {
    on_rim_.assign(at(near_count_), 0);
    std::size_t k = 0;
    for_each_coarse([&](int element, std::span<const int>) {
        for (const int unknown : of_elements[k++])
            if (is_near_[at(element)] == 0 && unknown >= first_near) on_rim_[at(unknown - first_near)] = 1;
    });
    k = 0;
    for_each_coarse([&](int element, std::span<const int>) {
        const std::span<const int> in_leaf = of_elements[k++];
        if (is_near_[at(element)] == 0) return;
        std::vector<int> places;
        for (const int unknown : in_leaf) places.push_back(unknown < 0 ? -1 : unknown - first_near);
        if (std::ranges::none_of(places, [&](int place) { return place >= 0 && on_rim_[at(place)] != 0; })) return;
        rim_elements_.push_back(element);
        rim_places_.append(places);
    });
}

void Structure::expand_near(const Eigen::VectorXd& gamma_displacement, double load_factor, Eigen::VectorXd& u) const {
    const Eigen::VectorXd x = leaf_->expand_last(load_factor * near_load_, gather(gamma_displacement, free_places_));
    for (int i = 0; i < near_count_; ++i) u[near_unknowns()[at(i)]] = x[i];
    for (const PrescribedUnknown& p : near_supports_) u[p.unknown] = load_factor * p.value;
}

Eigen::VectorXd Structure::far_force(const Eigen::VectorXd& near_displacement) const {
    const MandelMatrix elastic = scene_.elastic.stiffness();
    Eigen::VectorXd force = Eigen::VectorXd::Zero(near_count_);
    std::size_t k = 0;
    for_each_operator(rim_elements_, [&](const auto& op) {
        const std::span<const int> places = rim_places_[k++];
        const auto pushed = elastic_force(op, values_at(places, near_displacement, op), elastic);
        for (std::size_t i = 0; i < places.size(); ++i)
            if (places[i] >= 0 && on_rim_[at(places[i])] != 0) force[places[i]] -= pushed[static_cast<Eigen::Index>(i)];
    });
    return force;
}

}  // namespace stria::coarse
