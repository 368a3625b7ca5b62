// The unknowns of a condensed structure and their order of elimination: those that far elements alone see, those that
// near elements see, and last the boundary, which is what is free of Gamma.
#pragma once

#include <span>
#include <vector>

#include "coarse/elements/coarse_elements.hpp"
#include "coarse/structure/far_body.hpp"
#include "common/index_lists.hpp"

namespace stria::coarse {

class LeafNumbering {
public:
    /// `far`: null where no element is far. Unknowns of far elements come in the far body's order, the others
    /// ascending.
    LeafNumbering(const CoarseElements& elements, const FarBody* far);

    /// Unknowns of the whole mesh in the structure's order. Prescribed ones are not among them.
    [[nodiscard]] const std::vector<int>& unknowns() const { return unknowns_; }
    [[nodiscard]] int size() const { return static_cast<int>(unknowns_.size()); }
    /// How many of them only far elements see: the first ones.
    [[nodiscard]] int far_count() const { return far_count_; }
    [[nodiscard]] std::span<const int> near_unknowns() const { return std::span(unknowns_).subspan(at(far_count_)); }

    /// Gamma (gamma.hpp), and the places in it that are not prescribed.
    [[nodiscard]] const std::vector<int>& gamma() const { return gamma_; }
    [[nodiscard]] const std::vector<int>& free_places() const { return free_places_; }

    /// Unknowns of the whole mesh that far and near elements share, ascending.
    [[nodiscard]] const std::vector<int>& rim() const { return rim_; }
    /// Place of each rim unknown among near_unknowns().
    [[nodiscard]] std::vector<int> places_of_rim() const;

    /// Puts the near unknowns into an order of elimination, those of the rim after the others, Gamma last. Returns the
    /// unknowns of each near element and, as one list more, of the rim, as places among near_unknowns(); -1:
    /// prescribed.
    IndexLists order_elimination(const CoarseElements& elements);

private:
    void number(int unknown);
    void number_gamma(const UnknownSet& prescribed);
    void take_order(const std::vector<int>& order, IndexLists& of_elements);

    std::vector<int> gamma_, free_places_;
    std::vector<int> unknowns_;
    std::vector<int> index_;  // of each unknown of the mesh in unknowns_; -1: prescribed or inside the zone
    int far_count_ = 0;
    std::vector<int> rim_;
};

}  // namespace stria::coarse
