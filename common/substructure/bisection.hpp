// Which elements of a tree of fronts stand together: by where they lie.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "common/substructure/front_layout.hpp"

namespace stria {

/// A cut is cheap where the parts share few unknowns and neither is much smaller than the other. `uneven`: the
/// difference of the parts, of their sum.
inline double cost_of_cut(int shared, double uneven) {
    constexpr double tolerated = 0.2;
    return (1.0 + shared) * (1.0 + 0.5 * std::max(0.0, uneven - tolerated));
}

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
