// Which elements of a tree of fronts stand together: by where they lie.
#pragma once

#include <array>
#include <vector>

#include "common/substructure/front_layout.hpp"

namespace stria {

/// A node of the tree.
struct PartOfElements {
    std::array<int, 2> children{-1, -1};  // both, or none in a leaf
    std::vector<int> elements;            // of a leaf, ascending
};

/// A tree of all elements, children before parents, the root last. Halves share few unknowns: fronts are as wide as
/// what their elements share with others. It depends on where elements lie, not on their numbers. Where some come or
/// go, most parts of the others stay.
[[nodiscard]] std::vector<PartOfElements> bisect(const FrontLayout& layout);

}  // namespace stria
