#include "coarse/structure/leaf_numbering.hpp"

#include <algorithm>
#include <numeric>

#include "coarse/structure/gamma.hpp"
#include "common/fem/centre.hpp"
#include "common/substructure/nested_dissection.hpp"

namespace stria::coarse {

LeafNumbering::LeafNumbering(const CoarseElements& elements, const FarBody* far)
    : gamma_(gamma_of(elements.scene(), elements.in_zone())), index_(at(elements.scene().enriched.unknowns), -1) {
    const Scene& scene = elements.scene();
    UnknownSet inner(scene.enriched.unknowns), prescribed = inner;
    for (const PrescribedUnknown& p : scene.prescribed) prescribed.insert(p.unknown);
    elements.for_each_unknowns([&](int, std::span<const int> unknowns) {
        for (const int unknown : unknowns) inner.insert(unknown);
    });
    for (const int unknown : gamma_) inner.erase(unknown);
    if (far != nullptr) {
        rim_ = far->rim(scene.enriched);
        for (const int unknown : far->inner(scene.enriched)) number(unknown);
    }
    far_count_ = size();
    for (int i = 0; i < inner.size(); ++i)
        if (inner.contains(i) && !prescribed.contains(i) && index_[at(i)] < 0) number(i);
    number_gamma(prescribed);
}

void LeafNumbering::number(int unknown) {
    index_[at(unknown)] = size();
    unknowns_.push_back(unknown);
}

void LeafNumbering::number_gamma(const UnknownSet& prescribed) {
    for (int place = 0; place < std::ssize(gamma_); ++place) {
        if (prescribed.contains(gamma_[at(place)])) continue;
        free_places_.push_back(place);
        number(gamma_[at(place)]);
    }
}

std::vector<int> LeafNumbering::places_of_rim() const {
    std::vector<int> places;
    for (const int unknown : rim_) places.push_back(index_[at(unknown)] - far_count_);
    return places;
}

IndexLists LeafNumbering::order_elimination(const CoarseElements& elements) {
    IndexLists of_elements;
    std::vector<Vec2> centres;
    elements.for_each_near_unknowns([&](int element, std::span<const int> unknowns) {
        of_elements.append(unknowns);
        centres.push_back(centre(elements.scene().enriched, element));
    });
    std::vector<char> late(centres.size(), 1);
    of_elements.append(rim_);
    centres.push_back(Vec2::Zero());
    late.push_back(0);  // what the far body shares with near elements is neither's own: it comes after both
    of_elements.map([&](int unknown) { return index_[at(unknown)] < 0 ? -1 : index_[at(unknown)] - far_count_; });
    const int near = size() - far_count_, boundary = static_cast<int>(free_places_.size());
    std::vector<int> kept(at(boundary));
    std::iota(kept.begin(), kept.end(), near - boundary);
    take_order(nested_dissection(of_elements, centres, near, kept, late), of_elements);
    return of_elements;
}

void LeafNumbering::take_order(const std::vector<int>& order, IndexLists& of_elements) {
    const std::vector<int> before(near_unknowns().begin(), near_unknowns().end());
    std::vector<int> rank(before.size());
    for (int k = 0; k < std::ssize(before); ++k) {
        const int unknown = before[at(order[at(k)])];
        rank[at(order[at(k)])] = k;
        index_[at(unknown)] = far_count_ + k;
        unknowns_[at(far_count_ + k)] = unknown;
    }
    of_elements.map([&](int unknown) { return unknown < 0 ? -1 : rank[at(unknown)]; });
}

}  // namespace stria::coarse
