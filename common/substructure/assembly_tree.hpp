// The symbolic half of a FrontTree: which unknowns meet in which front, and where each contribution falls.
// It depends on the layout alone, so it is made once per geometry.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "common/substructure/front.hpp"
#include "common/substructure/front_layout.hpp"

namespace stria {

/// An unknown's rank is its place in the order of elimination; the boundary comes last, in the order of the layout.
struct AssemblyTree {
    struct Node {
        [[nodiscard]] bool leaf() const { return children[0] < 0; }
        /// The same contributions make the same front of both.
        [[nodiscard]] bool sums_up_like(const Node& other) const;

        std::array<int, 2> children{-1, -1};  // both, or none in a leaf
        std::array<Placement, 2> from_children;
        std::vector<int> elements;             // of a leaf, ascending
        std::vector<Placement> from_elements;  // one for each of them
        int first_rank = 0;                    // its eliminated unknowns follow each other
        int eliminated = 0;
        int multipliers = 0;    // of them, the last ones
        std::vector<int> kept;  // ranks, ascending
    };

    explicit AssemblyTree(const FrontLayout& layout);

    /// Of each node: that of another tree which sums up the same matrices in the same way, -1: none. `same`: per
    /// element, the one of the other tree whose matrix it has, -1: none.
    [[nodiscard]] std::vector<int> counterparts(const AssemblyTree& other, std::span<const int> same) const;

    /// Numbers of all unknowns, turned into those by rank and back.
    [[nodiscard]] Eigen::VectorXd by_rank(const Eigen::VectorXd& by_unknown) const;
    [[nodiscard]] Eigen::VectorXd by_unknown(const Eigen::VectorXd& by_rank) const;

    std::vector<Node> nodes;  // children before parents, the root last
    std::vector<int> rank;    // of each unknown
    int interior = 0;         // unknowns that are not boundary
    int widest = 0;           // most unknowns that a node keeps

private:
    void rank_unknowns(const FrontLayout& layout);
    void place_contributions(const FrontLayout& layout);
};

}  // namespace stria
