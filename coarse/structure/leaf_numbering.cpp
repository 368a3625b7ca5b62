#include "coarse/structure/leaf_numbering.hpp"

#include <algorithm>
#include <numeric>

#include "coarse/structure/gamma.hpp"
#include "common/fem/centre.hpp"
#include "common/substructure/nested_dissection.hpp"

namespace stria::coarse {

LeafNumbering::LeafNumbering(const CoarseElements& elements, const Parts& parts)
    : gamma_(gamma_of(elements.scene(), elements.in_zone())), index_(at(elements.scene().enriched.unknowns), -1) {
    const Scene& scene = elements.scene();
    UnknownSet own(scene.enriched.unknowns);
    const UnknownSet prescribed = prescribed_among(scene.enriched.unknowns, scene.prescribed);
    elements.for_each_unknowns(elements.core(), [&](int, std::span<const int> unknowns) {
        for (const int unknown : unknowns) own.insert(unknown);
    });
    for (const int unknown : gamma_) own.erase(unknown);
    for (const BodyPart* part : {parts.far, parts.middle, parts.behind}) {
        if (part == nullptr) continue;
        rim_below_ = part->rim(scene.enriched);
        for (const int unknown : part->inner(scene.enriched)) number(unknown);
        if (part == parts.far) rim_ = rim_below_, far_count_ = size();
    }
    below_count_ = size();
    for (const int unknown : rim_below_) own.insert(unknown);
    for (int i = 0; i < own.size(); ++i)
        if (own.contains(i) && !prescribed.contains(i)) number(i);
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

std::vector<int> LeafNumbering::places_of_rim_below() const {
    std::vector<int> places;
    for (const int unknown : rim_below_) places.push_back(index_[at(unknown)] - below_count_);
    return places;
}

IndexLists LeafNumbering::order_elimination(const CoarseElements& elements) {
    IndexLists of_elements;
    std::vector<Vec2> centres;
    elements.for_each_unknowns(elements.core(), [&](int element, std::span<const int> unknowns) {
        of_elements.append(unknowns);
        centres.push_back(centre(elements.scene().enriched, element));
    });
    std::vector<char> late(centres.size(), 1);
    of_elements.append(rim_below_);
    centres.push_back(Vec2::Zero());
    late.push_back(0);  // what the part below shares with the core is neither's own: it comes after both
    of_elements.map([&](int unknown) { return index_[at(unknown)] < 0 ? -1 : index_[at(unknown)] - below_count_; });
    const int core = size() - below_count_, boundary = static_cast<int>(free_places_.size());
    std::vector<int> kept(at(boundary));
    std::iota(kept.begin(), kept.end(), core - boundary);
    take_order(nested_dissection(of_elements, centres, core, kept, late), of_elements);
    return of_elements;
}

void LeafNumbering::take_order(const std::vector<int>& order, IndexLists& of_elements) {
    const std::vector<int> before(core_unknowns().begin(), core_unknowns().end());
    std::vector<int> rank(before.size());
    for (int k = 0; k < std::ssize(before); ++k) {
        const int unknown = before[at(order[at(k)])];
        rank[at(order[at(k)])] = k;
        index_[at(unknown)] = below_count_ + k;
        unknowns_[at(below_count_ + k)] = unknown;
    }
    of_elements.map([&](int unknown) { return unknown < 0 ? -1 : rank[at(unknown)]; });
}

}  // namespace stria::coarse
