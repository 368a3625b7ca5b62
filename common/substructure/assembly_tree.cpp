#include "common/substructure/assembly_tree.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>
#include <tuple>

#include "common/error.hpp"
#include "common/geometry/vec2.hpp"
#include "common/index.hpp"

namespace stria {
namespace {

using Layout = FrontLayout;
using Node = AssemblyTree::Node;

/// Median halves along the longer direction; ties are broken by the other coordinate and the number, so that the tree
/// is the same on every machine.
class Bisection {
public:
    Bisection(const Layout& layout, std::vector<Node>& nodes) : layout_(layout), nodes_(nodes) {}

    /// What lies about the busy places comes first, so that the way from there to the root is short however many the
    /// others are.
    int split_about_busy_places(std::span<int> elements) {
        constexpr std::size_t about_each = 128;  // elements: docs/performance.md
        const std::size_t near = about_each * layout_.busy.size();
        if (near == 0 || elements.size() < 2 * near) return split(elements);
        const auto distance = [&](int element) {
            double least = std::numeric_limits<double>::infinity();
            for (const Vec2& place : layout_.busy)
                least = std::min(least, (layout_.centres[at(element)] - place).squaredNorm());
            return std::tuple(least, element);
        };
        const auto end = elements.begin() + static_cast<std::ptrdiff_t>(near);
        std::ranges::nth_element(elements, end, {}, distance);
        Node node;
        const int others = split({end, elements.end()});
        node.children = {others, split({elements.begin(), end})};
        nodes_.push_back(std::move(node));
        return static_cast<int>(nodes_.size()) - 1;
    }

    int split(std::span<int> elements) {
        Node node;
        if (static_cast<int>(elements.size()) <= layout_.leaf_elements) {
            node.elements.assign(elements.begin(), elements.end());
            std::ranges::sort(node.elements);
        } else {
            const int axis = longer_direction(elements);
            const auto half = elements.begin() + static_cast<std::ptrdiff_t>(elements.size() / 2);
            std::ranges::nth_element(elements, half, {}, [&](int element) {
                const Vec2& centre = layout_.centres[at(element)];
                return std::tuple(centre[axis], centre[1 - axis], element);
            });
            node.children = {split({elements.begin(), half}), split({half, elements.end()})};
        }
        nodes_.push_back(std::move(node));
        return static_cast<int>(nodes_.size()) - 1;
    }

private:
    [[nodiscard]] int longer_direction(std::span<const int> elements) const {
        Eigen::Array2d low = layout_.centres[at(elements.front())], high = low;
        for (const int element : elements) {
            low = low.min(layout_.centres[at(element)].array());
            high = high.max(layout_.centres[at(element)].array());
        }
        return high.y() - low.y() > high.x() - low.x() ? 1 : 0;
    }

    const Layout& layout_;
    std::vector<Node>& nodes_;
};

void sort_unique(std::vector<int>& values) {
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

void check(const Layout& layout) {
    require(!layout.element_unknowns.empty(), "front tree: no elements");
    require(layout.centres.size() == layout.element_unknowns.size(), "front tree: one centre an element");
    require(layout.leaf_elements > 0, "front tree: leaves hold elements");
    std::vector<char> touched(at(layout.unknowns), 0);
    for (std::vector<int> unknowns : layout.element_unknowns) {
        const std::size_t listed = unknowns.size();
        sort_unique(unknowns);
        require(unknowns.size() == listed, "front tree: an element names an unknown twice");
        require(unknowns.empty() || (unknowns.front() >= 0 && unknowns.back() < layout.unknowns),
                "front tree: unknown out of range");
        for (const int unknown : unknowns) touched[at(unknown)] = 1;
    }
    require(std::ranges::count(touched, 0) == 0, "front tree: an unknown that no element touches");
    std::vector<int> boundary = layout.boundary;
    sort_unique(boundary);
    require(boundary.size() == layout.boundary.size(), "front tree: a boundary unknown named twice");
    require(boundary.empty() || (boundary.front() >= 0 && boundary.back() < layout.unknowns),
            "front tree: boundary unknown out of range");
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

/// Rows of the given ranks in a front that has each rank at place[rank].
Placement place_rows(const std::vector<int>& ranks, const std::vector<int>& place, int eliminated) {
    std::vector<int> rows(ranks.size());
    std::iota(rows.begin(), rows.end(), 0);
    std::ranges::sort(rows, {}, [&](int row) { return ranks[at(row)]; });
    Placement result{.order = static_cast<int>(ranks.size()), .runs = {}};
    for (const int row : rows) append(result.runs, row, place[at(ranks[at(row)])], eliminated);
    return result;
}

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

/// All that meets in a node: what its children keep, or what its elements hold.
std::vector<int> unknowns_at(const Node& node, const Layout& layout, const std::vector<Node>& nodes) {
    std::vector<int> unknowns;
    const auto take = [&](const std::vector<int>& more) { unknowns.insert(unknowns.end(), more.begin(), more.end()); };
    for (const int element : node.elements) take(layout.element_unknowns[at(element)]);
    if (!node.leaf()) {
        for (const int child : node.children) take(nodes[at(child)].kept);
    }
    sort_unique(unknowns);
    return unknowns;
}

}  // namespace

AssemblyTree::AssemblyTree(const Layout& layout) {
    check(layout);
    std::vector<int> elements(layout.element_unknowns.size());
    std::iota(elements.begin(), elements.end(), 0);
    Bisection(layout, nodes).split_about_busy_places(elements);
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
    for (int index = 0; index < static_cast<int>(nodes.size()); ++index) {
        Node& node = nodes[at(index)];
        first_node[at(index)] = node.leaf() ? index : first_node[at(node.children[0])];
        node.first_rank = next;
        for (const int unknown : unknowns_at(node, layout, nodes)) {  // ascending: multipliers come last
            const auto [first, last] = reach[at(unknown)];
            const bool complete = first >= first_node[at(index)] && last <= index;
            const bool is_multiplier = unknown >= first_multiplier;
            const bool waits =
                is_multiplier && !std::ranges::all_of(partners[at(unknown - first_multiplier)], is_ranked);
            if (!complete || waits || is_ranked(unknown)) {
                node.kept.push_back(unknown);
            } else {
                rank[at(unknown)] = next++;
                if (is_multiplier) ++node.multipliers;
            }
        }
        node.eliminated = next - node.first_rank;
    }
    for (Node& node : nodes) {
        for (int& unknown : node.kept) unknown = rank[at(unknown)];
        std::ranges::sort(node.kept);
        widest = std::max(widest, static_cast<int>(node.kept.size()));
    }
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
    std::vector<int> place(at(layout.unknowns), -1);  // of each rank, in the front at hand
    for (Node& node : nodes) {
        for (int i = 0; i < node.eliminated; ++i) place[at(node.first_rank + i)] = i;
        int next = node.eliminated;
        for (const int kept : node.kept) place[at(kept)] = next++;
        for (const int element : node.elements) {
            std::vector<int> ranks = layout.element_unknowns[at(element)];
            for (int& unknown : ranks) unknown = rank[at(unknown)];
            node.from_elements.push_back(place_rows(ranks, place, node.eliminated));
        }
        if (node.leaf()) continue;
        for (std::size_t side = 0; side < 2; ++side) {
            node.from_children[side] = place_rows(nodes[at(node.children[side])].kept, place, node.eliminated);
        }
    }
}

}  // namespace stria
