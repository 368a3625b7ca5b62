#include "coupling/ranks/element_groups.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <ranges>

#include "common/enrichment/element_basis.hpp"
#include "common/fem/centre.hpp"
#include "common/index.hpp"

namespace stria::coupling {
namespace {

/// Of the smallest elements about a tip, so many may be cut before history has to move.
constexpr double elements_ahead = 16.0;

/// Sets of elements that are found to belong together.
class Union {
public:
    explicit Union(std::size_t elements) : parent_(elements) { std::iota(parent_.begin(), parent_.end(), 0); }

    int root(int element) {
        while (parent_[at(element)] != element) element = parent_[at(element)] = parent_[at(parent_[at(element)])];
        return element;
    }
    void join(int a, int b) { parent_[at(root(b))] = root(a); }

private:
    std::vector<int> parent_;
};

/// The crack of each unknown, -1 for standard ones.
std::vector<int> crack_of_unknowns(const EnrichedMesh& zone) {
    std::vector<int> crack(at(zone.unknowns), -1);
    for (const auto& [node, term, unknown] : zone.own_unknowns()) {
        if (term == 0) continue;
        const Term& own = zone.terms[at(node)][at(term - 1)];
        crack[at(unknown)] = own.kind == Term::Kind::Heaviside ? own.owner : zone.tip_of(own).crack;
    }
    return crack;
}

/// What the crack of a tip cuts if it goes straight on.
std::vector<int> way_of(const EnrichedMesh& mesh, const Tip& tip) {
    constexpr double rounding = 1e-9;
    const auto all = std::views::iota(0, static_cast<int>(std::ssize(mesh.elements)));
    const auto distance = [&](int e) { return (centre(mesh, e) - tip.position).squaredNorm(); };
    const double size = edge_of_square(mesh, *std::ranges::min_element(all, {}, distance));
    const Vec2 along = tip.direction, across(-along.y(), along.x());
    std::vector<int> way;
    for (const int e : all) {
        const auto extent = [&](const Vec2& axis) {
            const auto place = [&](int node) { return axis.dot(mesh.nodes[at(node)] - tip.position) / size; };
            return std::ranges::minmax(mesh.elements[at(e)] | std::views::transform(place));
        };
        const auto ahead = extent(along), beside = extent(across);
        if (ahead.max > 0.0 && ahead.min < elements_ahead && beside.min < rounding && beside.max > -rounding)
            way.push_back(e);
    }
    return way;
}

class Groups {
public:
    Groups(const EnrichedMesh& zone, const EnrichedMesh& before, const std::vector<int>& part_of)
        : zone_(zone), sets_(zone.elements.size()) {
        std::map<int, int> element;  // by id
        for (int e = 0; e < std::ssize(zone.elements); ++e) element[zone.element_ids[at(e)]] = e;
        std::map<int, int> of_whole;
        for (int e = 0; e < std::ssize(part_of); ++e)
            if (part_of[at(e)] >= 0) join_by_key(of_whole, part_of[at(e)], e);
        for (const EnrichedMesh* mesh : {&zone, &before}) {
            std::vector<int> in_zone;
            for (const int id : mesh->element_ids) in_zone.push_back(element.at(id));
            tie_together(*mesh, in_zone);
        }
    }

    void add_ways() {
        for (const Tip& tip : zone_.tips) {
            const auto seen = seen_by_.find(tip.crack);
            if (seen == seen_by_.end()) continue;
            for (const int e : way_of(zone_, tip))
                if (!is_of_a_crack(e)) sets_.join(seen->second, e);
        }
    }

    std::vector<ElementGroup> list() {
        std::vector<ElementGroup> groups;
        std::vector<int> place(zone_.elements.size(), -1);
        for (int e = 0; e < std::ssize(zone_.elements); ++e) {
            int& own = place[at(sets_.root(e))];
            if (own < 0) {
                own = static_cast<int>(groups.size());
                groups.emplace_back();
            }
            ElementGroup& group = groups[at(own)];
            group.elements.push_back(e);
            group.centre += centre(zone_, e);
        }
        for (ElementGroup& group : groups) group.centre /= static_cast<double>(group.elements.size());
        return groups;
    }

private:
    /// Joins all elements of which the same key is said. `first`: the one by key.
    void join_by_key(std::map<int, int>& first, int key, int element) {
        sets_.join(first.try_emplace(key, element).first->second, element);
    }

    /// What has to stay together in a mesh. `element`: of the zone, of each of the mesh.
    void tie_together(const EnrichedMesh& mesh, const std::vector<int>& element) {
        const std::vector<int> piece = piece_of_elements(mesh), crack = crack_of_unknowns(mesh);
        std::map<int, int> seen_by, about_hanging_node;
        for (const CrackPiece& p : mesh.pieces) {
            join_by_key(seen_by, p.crack, element[at(p.element)]);
            if (p.neighbour >= 0) join_by_key(seen_by, p.crack, element[at(p.neighbour)]);
        }
        const auto is_plain = [&](int node) { return mesh.terms[at(node)].empty() && mesh.tie(node) == nullptr; };
        for (int e = 0; e < std::ssize(mesh.elements); ++e) {
            if (std::ranges::all_of(mesh.elements[at(e)], is_plain)) continue;  // most of them
            const ElementBasis basis(mesh, e, piece[at(e)] >= 0);
            for (const int unknown : basis.unknowns())
                if (unknown % 2 == 0 && crack[at(unknown)] >= 0)
                    join_by_key(seen_by, crack[at(unknown)], element[at(e)]);
            for (const int node : mesh.elements[at(e)])
                if (mesh.tie(node) != nullptr) join_by_key(about_hanging_node, node, element[at(e)]);
        }
        seen_by_.merge(seen_by);
    }

    bool is_of_a_crack(int element) {
        const int root = sets_.root(element);
        return std::ranges::any_of(seen_by_, [&](const auto& entry) { return sets_.root(entry.second) == root; });
    }

    const EnrichedMesh& zone_;
    Union sets_;
    std::map<int, int> seen_by_;  // an element, by crack
};

}  // namespace

std::vector<ElementGroup> element_groups(const EnrichedMesh& zone, const EnrichedMesh& before,
                                         const std::vector<int>& part_of) {
    return Groups(zone, before, part_of).list();
}

std::vector<ElementGroup> element_groups_with_ways(const EnrichedMesh& zone, const EnrichedMesh& before,
                                                   const std::vector<int>& part_of) {
    Groups groups(zone, before, part_of);
    groups.add_ways();
    return groups.list();
}

}  // namespace stria::coupling
