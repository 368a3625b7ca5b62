#include "coupling/ranks/zone_partition.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <span>

#include "common/enrichment/element_basis.hpp"
#include "common/index.hpp"

namespace stria::coupling {
namespace {

/// Elements that one rank must own together.
struct Group {
    std::vector<int> elements;
    Vec2 centre = Vec2::Zero();  // mean of the elements'
    int rank = -1;

    [[nodiscard]] double weight() const { return static_cast<double>(elements.size()); }
};

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

/// Joins, under one key, all elements that it is said of.
class JoinByKey {
public:
    explicit JoinByKey(Union& sets) : sets_(sets) {}
    void operator()(int key, int element) { sets_.join(first_.try_emplace(key, element).first->second, element); }

private:
    Union& sets_;
    std::map<int, int> first_;
};

/// What has to stay together in a mesh. `element`: in the sets, of each of the mesh.
void tie_together(const EnrichedMesh& mesh, const std::vector<int>& element, Union& sets) {
    JoinByKey on_crack(sets), about_hanging_node(sets);
    const std::vector<int> piece = piece_of_elements(mesh), crack = crack_of_unknowns(mesh);
    for (const CrackPiece& p : mesh.pieces) {
        on_crack(p.crack, element[at(p.element)]);
        if (p.neighbour >= 0) on_crack(p.crack, element[at(p.neighbour)]);
    }
    for (int e = 0; e < std::ssize(mesh.elements); ++e) {
        const ElementBasis basis(mesh, e, piece[at(e)] >= 0);
        for (const int unknown : basis.unknowns())
            if (unknown % 2 == 0 && crack[at(unknown)] >= 0) on_crack(crack[at(unknown)], element[at(e)]);
        for (const int node : mesh.elements[at(e)])
            if (mesh.tie(node) != nullptr) about_hanging_node(node, element[at(e)]);
    }
}

std::vector<Group> groups_of(const EnrichedMesh& zone, const EnrichedMesh& before, const std::vector<int>& part_of) {
    Union sets(zone.elements.size());
    std::map<int, int> element;  // by id
    for (int e = 0; e < std::ssize(zone.elements); ++e) element[zone.element_ids[at(e)]] = e;
    JoinByKey of_whole(sets);
    for (int e = 0; e < std::ssize(part_of); ++e)
        if (part_of[at(e)] >= 0) of_whole(part_of[at(e)], e);
    for (const EnrichedMesh* mesh : {&zone, &before}) {
        std::vector<int> in_zone;
        for (const int id : mesh->element_ids) in_zone.push_back(element.at(id));
        tie_together(*mesh, in_zone, sets);
    }
    std::vector<Group> groups;
    std::vector<int> place(zone.elements.size(), -1);
    for (int e = 0; e < std::ssize(zone.elements); ++e) {
        int& own = place[at(sets.root(e))];
        if (own < 0) {
            own = static_cast<int>(groups.size());
            groups.emplace_back();
        }
        Group& group = groups[at(own)];
        group.elements.push_back(e);
        for (const int node : zone.elements[at(e)]) group.centre += zone.nodes[at(node)] / 4.0;
    }
    for (Group& group : groups) group.centre /= group.weight();
    return groups;
}

double weight_of(std::span<const Group> groups) {
    return std::transform_reduce(groups.begin(), groups.end(), 0.0, std::plus<>(), std::mem_fn(&Group::weight));
}

/// Sorts along an axis; the number of groups before the cut that comes closest to a weight, and by how much it misses.
struct Cut {
    std::size_t groups;
    double miss;
};
Cut cut_along(int axis, std::span<Group> groups, double weight) {
    std::ranges::stable_sort(groups, {}, [&](const Group& group) { return group.centre[axis]; });
    Cut best{0, weight};
    double sum = 0.0;
    for (std::size_t k = 0; k < groups.size(); ++k) {
        sum += groups[k].weight();
        if (std::abs(sum - weight) < best.miss) best = {k + 1, std::abs(sum - weight)};
    }
    return best;
}

// Across the longer way, for a short seam; across the other where a crack, which is one group, would upset the balance.
void bisect(std::span<Group> groups, int first_rank, int ranks) {
    if (ranks == 1 || groups.size() <= 1) {
        for (Group& group : groups) group.rank = first_rank;
        return;
    }
    Vec2 least = groups.front().centre, most = least;
    for (const Group& group : groups) {
        least = least.cwiseMin(group.centre);
        most = most.cwiseMax(group.centre);
    }
    const Vec2 extent = most - least;
    const int longer = extent.x() >= extent.y() ? 0 : 1, half = ranks / 2;
    const double total = weight_of(groups), weight = total * half / ranks;
    const Cut other = cut_along(1 - longer, groups, weight);
    Cut cut = cut_along(longer, groups, weight);
    if (other.miss < cut.miss - total / 20.0) cut = cut_along(1 - longer, groups, weight);
    const std::size_t before = std::clamp(cut.groups, std::size_t{1}, groups.size() - 1);
    bisect(groups.first(before), first_rank, half);
    bisect(groups.subspan(before), first_rank + half, ranks - half);
}

/// False where a group has elements of several.
bool keep_owners(const EnrichedMesh& zone, const std::map<int, int>& owners, std::vector<Group>& groups) {
    for (Group& group : groups) {
        for (const int element : group.elements) {
            const auto owner = owners.find(zone.element_ids[at(element)]);
            if (owner == owners.end()) continue;
            if (group.rank >= 0 && group.rank != owner->second) return false;
            group.rank = owner->second;
        }
    }
    return true;
}

/// Ring by ring about those that have a rank; what touches none of them joins the rank with least.
void join_neighbours(const EnrichedMesh& zone, std::vector<Group>& groups) {
    std::vector<int> rank_at(zone.nodes.size(), -1);
    std::map<int, double> weight;
    const auto give = [&](Group& group, int rank) {
        group.rank = rank;
        weight[rank] += group.weight();
        for (const int element : group.elements)
            for (const int node : zone.elements[at(element)]) rank_at[at(node)] = rank;
    };
    for (Group& group : groups)
        if (group.rank >= 0) give(group, group.rank);
    const auto neighbour = [&](const Group& group) {
        for (const int element : group.elements)
            for (const int node : zone.elements[at(element)])
                if (rank_at[at(node)] >= 0) return rank_at[at(node)];
        return -1;
    };
    for (bool joined = true; joined;) {
        joined = false;
        for (Group& group : groups) {
            if (group.rank >= 0) continue;
            if (const int rank = neighbour(group); rank >= 0) {
                give(group, rank);
                joined = true;
            }
        }
    }
    const auto least = [](const auto& share) { return share.second; };
    for (Group& group : groups)
        if (group.rank < 0) give(group, std::ranges::min_element(weight, {}, least)->first);
}

std::vector<int> ranks_of_elements(const EnrichedMesh& zone, const std::vector<Group>& groups) {
    std::vector<int> rank(zone.elements.size(), 0);
    for (const Group& group : groups)
        for (const int element : group.elements) rank[at(element)] = group.rank;
    return rank;
}

}  // namespace

std::vector<int> share_out(const EnrichedMesh& zone, int ranks, const EnrichedMesh& before,
                           const std::vector<int>& part_of) {
    std::vector<Group> groups = groups_of(zone, before, part_of);
    bisect(groups, 0, std::min(ranks, static_cast<int>(groups.size())));
    return ranks_of_elements(zone, groups);
}

std::optional<std::vector<int>> share_on(const EnrichedMesh& zone, const std::map<int, int>& owners,
                                         const std::vector<int>& part_of) {
    std::vector<Group> groups = groups_of(zone, {}, part_of);
    if (!keep_owners(zone, owners, groups)) return std::nullopt;
    join_neighbours(zone, groups);
    return ranks_of_elements(zone, groups);
}

}  // namespace stria::coupling
