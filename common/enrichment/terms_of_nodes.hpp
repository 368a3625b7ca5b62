// The enrichment terms of the nodes of a mesh.
#pragma once

#include <algorithm>
#include <vector>

#include "common/index.hpp"

namespace stria {

/// One enrichment term of a node: N_i (psi(x) - psi(x_i)), shifted so that it vanishes at the node. A gathered tip
/// function has one pair of unknowns for all nodes that carry it: sum_i N_i (psi - sum_k N_k psi(x_k)).
struct Term {
    enum class Kind : int { Heaviside, Tip, Gathered, Left };
    Kind kind;
    int owner;     // Heaviside: crack index; Left: index into EnrichedMesh::left_tips; else tip index
    int function;  // alpha of eq. (2), from 0; Heaviside: 0
    double shift;  // psi(x_i)

    /// The same function, whatever mesh it is written on.
    [[nodiscard]] bool same_function(const Term& other) const {
        return kind == other.kind && owner == other.owner && function == other.function;
    }
};

/// A list of terms for each node. Most nodes have none, and whoever looks for terms need not ask them.
class TermsOfNodes {
public:
    TermsOfNodes() = default;
    explicit TermsOfNodes(std::size_t nodes) : place_(nodes, -1) {}
    /// One list per node.
    TermsOfNodes(const std::vector<std::vector<Term>>& lists) : TermsOfNodes(lists.size()) {
        for (std::size_t node = 0; node < lists.size(); ++node)
            if (!lists[node].empty()) of(node) = lists[node];
    }

    /// How many nodes there are, with terms and without.
    [[nodiscard]] std::size_t size() const { return place_.size(); }

    [[nodiscard]] const std::vector<Term>& operator[](std::size_t node) const {
        static const std::vector<Term> none;
        const int place = place_[node];
        return place >= 0 ? lists_[at(place)] : none;
    }

    /// To be changed; until the next call.
    [[nodiscard]] std::vector<Term>& of(std::size_t node) {
        int& place = place_[node];
        if (place < 0) {
            place = static_cast<int>(lists_.size());
            lists_.emplace_back();
            nodes_.push_back(static_cast<int>(node));
        }
        return lists_[at(place)];
    }

    /// The nodes that have some, ascending.
    [[nodiscard]] std::vector<int> nodes() const {
        std::vector<int> nodes;
        for (const int node : nodes_)
            if (!(*this)[at(node)].empty()) nodes.push_back(node);
        std::ranges::sort(nodes);
        return nodes;
    }

    /// One list per node.
    [[nodiscard]] std::vector<std::vector<Term>> lists() const {
        std::vector<std::vector<Term>> lists(size());
        for (const int node : nodes_) lists[at(node)] = (*this)[at(node)];
        return lists;
    }

private:
    std::vector<int> place_;  // per node: of its list, -1: it has none
    std::vector<std::vector<Term>> lists_;
    std::vector<int> nodes_;  // of each list
};

}  // namespace stria
