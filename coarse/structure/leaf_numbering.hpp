// The unknowns of a condensed structure and their order of elimination: those inside the parts that it lies on, the far
// one first, those that the core sees, and last the boundary, which is what is free of Gamma.
#pragma once

#include <span>
#include <vector>

#include "coarse/elements/coarse_elements.hpp"
#include "coarse/structure/body_part.hpp"
#include "common/index_lists.hpp"

namespace stria::coarse {

class LeafNumbering {
public:
    /// The parts that lie one on another: null where no element is far, in the middle, or behind. Unknowns inside them
    /// come in their order, the others ascending.
    struct Parts {
        const BodyPart *far, *middle, *behind;
    };
    LeafNumbering(const CoarseElements& elements, const Parts& parts);

    /// Unknowns of the whole mesh in the structure's order. Prescribed ones are not among them.
    [[nodiscard]] const std::vector<int>& unknowns() const { return unknowns_; }
    [[nodiscard]] int size() const { return static_cast<int>(unknowns_.size()); }
    /// How many of them only far elements see: the first ones.
    [[nodiscard]] int far_count() const { return far_count_; }
    [[nodiscard]] std::span<const int> near_unknowns() const { return std::span(unknowns_).subspan(at(far_count_)); }
    [[nodiscard]] std::span<const int> core_unknowns() const { return std::span(unknowns_).subspan(at(below_count_)); }

    /// Gamma (gamma.hpp), and the places in it that are not prescribed.
    [[nodiscard]] const std::vector<int>& gamma() const { return gamma_; }
    [[nodiscard]] const std::vector<int>& free_places() const { return free_places_; }

    /// Unknowns of the whole mesh that far and near elements share, ascending.
    [[nodiscard]] const std::vector<int>& rim() const { return rim_; }
    /// Of each unknown on the rim of the part that the core lies on, its place among core_unknowns().
    [[nodiscard]] std::vector<int> places_of_rim_below() const;

    /// Puts the unknowns of the core into an order of elimination, those of the rim below after the others, Gamma last.
    /// Returns the unknowns of each element of the core and, as one list more, of that rim, as places among
    /// core_unknowns(); -1: prescribed.
    IndexLists order_elimination(const CoarseElements& elements);

private:
    void number(int unknown);
    void number_gamma(const UnknownSet& prescribed);
    void take_order(const std::vector<int>& order, IndexLists& of_elements);

    std::vector<int> gamma_, free_places_;
    std::vector<int> unknowns_;
    std::vector<int> index_;  // of each unknown of the mesh in unknowns_; -1: prescribed or inside the zone
    int far_count_ = 0, below_count_ = 0;
    std::vector<int> rim_, rim_below_;  // of the far part; of that on which the core lies
};

}  // namespace stria::coarse
