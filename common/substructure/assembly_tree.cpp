#include "common/substructure/assembly_tree.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "common/error.hpp"
#include "common/index.hpp"
#include "common/substructure/bisection.hpp"

namespace stria {
namespace {

using Layout = FrontLayout;
using Node = AssemblyTree::Node;

void sort_unique(std::vector<int>& values) {
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

void check(const Layout& layout) {
    require(!layout.element_unknowns.empty(), "front tree: no elements");
    require(layout.centres.size() == layout.element_unknowns.size(), "front tree: one centre an element");
    require(layout.leaf_elements > 0, "front tree: leaves hold elements");
    const auto in_range = [&](int unknown) { return unknown >= 0 && unknown < layout.unknowns; };
    std::vector<int> last(at(layout.unknowns), -1);  // element that names an unknown
    for (int e = 0; e < std::ssize(layout.element_unknowns); ++e) {
        for (const int unknown : layout.element_unknowns[at(e)]) {
            require(in_range(unknown), "front tree: unknown out of range");
            require(std::exchange(last[at(unknown)], e) != e, "front tree: an element names an unknown twice");
        }
    }
    require(std::ranges::count(last, -1) == 0, "front tree: an unknown that no element touches");
    std::vector<int> boundary = layout.boundary;
    sort_unique(boundary);
    require(boundary.size() == layout.boundary.size(), "front tree: a boundary unknown named twice");
    require(std::ranges::all_of(boundary, in_range), "front tree: boundary unknown out of range");
}

/// Lengthens the last run by one row, or begins a new one.
void append(std::vector<Placement::Run>& runs, int source, int target, int eliminated) {
    if (!runs.empty()) {
        auto& [first_source, first_target, length] = runs.back();
        const bool follows = source == first_source + length && target == first_target + length;
        if (follows && target != eliminated) {
            ++length;
            return;
        }
    }
    runs.push_back({.source = source, .target = target, .length = 1});
}

/// Where rows fall in one front after the other. What it works with is kept, for there are many.
class Places {
public:
    explicit Places(int unknowns) : place_(at(unknowns), -1) {}

    void turn_to(const Node& node) {
        eliminated_ = node.eliminated;
        for (int i = 0; i < eliminated_; ++i) place_[at(node.first_rank + i)] = i;
        int next = eliminated_;
        for (const int kept : node.kept) place_[at(kept)] = next++;
    }

    /// Of the rows of these ranks, all of them in the front at hand.
    Placement of(std::span<const int> ranks) {
        rows_.resize(ranks.size());
        std::iota(rows_.begin(), rows_.end(), 0);
        if (!std::ranges::is_sorted(ranks)) std::ranges::sort(rows_, {}, [&](int row) { return ranks[at(row)]; });
        runs_.clear();
        for (const int row : rows_) append(runs_, row, place_[at(ranks[at(row)])], eliminated_);
        return {.order = static_cast<int>(ranks.size()), .runs = runs_};
    }

private:
    std::vector<int> place_;  // of each rank
    int eliminated_ = 0;
    std::vector<int> rows_;
    std::vector<Placement::Run> runs_;
};

/// The first and the last leaf that hold an unknown.
struct LeafReach {
    int first = std::numeric_limits<int>::max();
    int last = -1;
};

std::vector<LeafReach> reaches(const Layout& layout, const std::vector<Node>& nodes) {
    std::vector<LeafReach> reach(at(layout.unknowns));
    for (int node = 0; node < static_cast<int>(nodes.size()); ++node) {
        for (const int element : nodes[at(node)].elements) {
            for (const int unknown : layout.element_unknowns[at(element)]) {
                reach[at(unknown)].first = std::min(reach[at(unknown)].first, node);
                reach[at(unknown)].last = node;
            }
        }
    }
    return reach;
}

/// Of each multiplier: what shares an element with it.
std::vector<std::vector<int>> acted_on(const Layout& layout) {
    const int first = layout.unknowns - layout.multipliers;
    std::vector<std::vector<int>> result(at(layout.multipliers));
    for (const std::vector<int>& unknowns : layout.element_unknowns) {
        for (const int multiplier : unknowns) {
            if (multiplier < first) continue;
            for (const int unknown : unknowns)
                if (unknown < first) result[at(multiplier - first)].push_back(unknown);
        }
    }
    return result;
}

/// What meets in nodes. What it works with is kept, for there are many.
class Meetings {
public:
    Meetings(const Layout& layout, const std::vector<Node>& nodes)
        : layout_(layout), nodes_(nodes), last_(at(layout.unknowns), -1) {}

    /// In a node, ascending: what its children keep, or what its elements hold. Until the next one is asked for.
    std::span<const int> at_node(int index) {
        met_.clear();
        const Node& node = nodes_[at(index)];
        if (node.leaf()) {
            for (const int element : node.elements)
                for (const int unknown : layout_.element_unknowns[at(element)])
                    if (std::exchange(last_[at(unknown)], index) != index) met_.push_back(unknown);
            std::ranges::sort(met_);
        } else {
            const auto& [first, second] = node.children;
            std::ranges::set_union(nodes_[at(first)].kept, nodes_[at(second)].kept, std::back_inserter(met_));
        }
        return met_;
    }

private:
    const Layout& layout_;
    const std::vector<Node>& nodes_;
    std::vector<int> last_;  // leaf that was seen to hold an unknown
    std::vector<int> met_;
};

}  // namespace

AssemblyTree::AssemblyTree(const Layout& layout) {
    check(layout);
    for (PartOfElements& part : bisect(layout)) {
        Node& node = nodes.emplace_back();
        node.children = part.children;
        node.elements = std::move(part.elements);
    }
    rank_unknowns(layout);
    place_contributions(layout);
}

void AssemblyTree::rank_unknowns(const Layout& layout) {
    const std::vector<LeafReach> reach = reaches(layout, nodes);
    interior = layout.unknowns - static_cast<int>(layout.boundary.size());
    rank.assign(at(layout.unknowns), -1);
    int next = interior;
    for (const int unknown : layout.boundary) rank[at(unknown)] = next++;

    next = 0;
    const int first_multiplier = layout.unknowns - layout.multipliers;
    const std::vector<std::vector<int>> partners = acted_on(layout);
    const auto is_ranked = [&](int unknown) { return rank[at(unknown)] >= 0; };
    std::vector<int> first_node(nodes.size());  // of the subtree: nodes are numbered children before parents
    std::vector<int> kept;
    Meetings meetings(layout, nodes);
    for (int index = 0; index < static_cast<int>(nodes.size()); ++index) {
        Node& node = nodes[at(index)];
        first_node[at(index)] = node.leaf() ? index : first_node[at(node.children[0])];
        node.first_rank = next;
        kept.clear();
        for (const int unknown : meetings.at_node(index)) {  // ascending: multipliers come last
            const auto [first, last] = reach[at(unknown)];
            const bool complete = first >= first_node[at(index)] && last <= index;
            const bool is_multiplier = unknown >= first_multiplier;
            const bool waits =
                is_multiplier && !std::ranges::all_of(partners[at(unknown - first_multiplier)], is_ranked);
            if (!complete || waits || is_ranked(unknown)) {
                kept.push_back(unknown);
            } else {
                rank[at(unknown)] = next++;
                if (is_multiplier) ++node.multipliers;
            }
        }
        node.kept = kept;
        node.eliminated = next - node.first_rank;
    }
    for (Node& node : nodes) {
        for (int& unknown : node.kept) unknown = rank[at(unknown)];
        std::ranges::sort(node.kept);
        widest = std::max(widest, static_cast<int>(node.kept.size()));
    }
}

bool AssemblyTree::Node::sums_up_like(const Node& other) const {
    return eliminated == other.eliminated && multipliers == other.multipliers && kept.size() == other.kept.size() &&
           from_elements == other.from_elements && from_children == other.from_children;
}

// Where unknowns stand in the fronts decides, not their numbers.
std::vector<int> AssemblyTree::counterparts(const AssemblyTree& other, std::span<const int> same) const {
    std::vector<int> parent(other.nodes.size(), -1), found(nodes.size(), -1), leaf_of;
    for (int index = 0; index < std::ssize(other.nodes); ++index) {
        for (const int element : other.nodes[at(index)].elements) {
            leaf_of.resize(std::max(leaf_of.size(), at(element) + 1), -1);
            leaf_of[at(element)] = index;
        }
        for (const int child : other.nodes[at(index)].children)
            if (child >= 0) parent[at(child)] = index;
    }
    const auto in_other = [&](int element) { return same[at(element)]; };
    for (std::size_t index = 0; index < nodes.size(); ++index) {
        const Node& node = nodes[index];
        const int below = node.leaf() ? in_other(node.elements.front()) : found[at(node.children[0])];
        if (below < 0) continue;
        const int candidate = node.leaf() ? leaf_of[at(below)] : parent[at(below)];
        if (candidate < 0) continue;
        const Node& counterpart = other.nodes[at(candidate)];
        const bool same_parts =
            node.leaf() ? std::ranges::equal(node.elements, counterpart.elements, {}, in_other)
                        : !counterpart.leaf() && std::ranges::equal(node.children, counterpart.children, {},
                                                                    [&](int child) { return found[at(child)]; });
        if (same_parts && node.sums_up_like(counterpart)) found[index] = candidate;
    }
    return found;
}

// In loops: an indexed view of Eigen would copy the ranks.
Eigen::VectorXd AssemblyTree::by_rank(const Eigen::VectorXd& by_unknown) const {
    Eigen::VectorXd y(by_unknown.size());
    for (Eigen::Index i = 0; i < y.size(); ++i) y[rank[at(i)]] = by_unknown[i];
    return y;
}

Eigen::VectorXd AssemblyTree::by_unknown(const Eigen::VectorXd& by_rank) const {
    Eigen::VectorXd x(by_rank.size());
    for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = by_rank[rank[at(i)]];
    return x;
}

void AssemblyTree::place_contributions(const Layout& layout) {
    Places places(layout.unknowns);
    std::vector<int> ranks;
    for (Node& node : nodes) {
        places.turn_to(node);
        node.from_elements.reserve(node.elements.size());
        for (const int element : node.elements) {
            ranks = layout.element_unknowns[at(element)];
            for (int& unknown : ranks) unknown = rank[at(unknown)];
            node.from_elements.push_back(places.of(ranks));
        }
        if (node.leaf()) continue;
        for (std::size_t side = 0; side < 2; ++side)
            node.from_children[side] = places.of(nodes[at(node.children[side])].kept);
    }
}

}  // namespace stria
