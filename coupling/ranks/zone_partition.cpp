#include "coupling/ranks/zone_partition.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <span>
#include <utility>

#include "common/index.hpp"
#include "coupling/ranks/element_groups.hpp"

namespace stria::coupling {
namespace {

// What an iteration costs, in units of an element that does not yield: measured, docs/performance.md.
constexpr double of_yielding = 20.0;   // with its points and the fronts above it
constexpr double of_seam_node = 0.05;  // times the nodes on seams: dense matrices cross and are merged

/// Two kinds of work: elements yield in some iterations and not in others, and who has less of either waits for who has
/// more.
struct Work {
    double elements = 0.0, yielding = 0.0;

    Work& operator+=(const Work& more) {
        elements += more.elements;
        yielding += more.yielding;
        return *this;
    }
    [[nodiscard]] double off(const Work& other) const {
        return std::abs(elements - other.elements) + std::abs(yielding - other.yielding);
    }
};

Work work_of(int element, const std::vector<double>& flow) {
    return {1.0, flow.empty() ? 0.0 : of_yielding * flow[at(element)]};
}

struct WeightedGroup {
    ElementGroup group;
    Work work;
};

/// The groups before a cut of those sorted along an axis, and what the cut costs.
struct Cut {
    std::size_t groups;
    double cost;
};

double seam_between(const EnrichedMesh& zone, std::span<const WeightedGroup> groups, std::size_t before) {
    std::vector<char> sides(zone.nodes.size(), 0);
    for (std::size_t k = 0; k < groups.size(); ++k)
        for (const int element : groups[k].group.elements)
            for (const int node : zone.elements[at(element)])
                sides[at(node)] = static_cast<char>(sides[at(node)] | (k < before ? 1 : 2));
    const auto nodes = static_cast<double>(std::ranges::count(sides, 3));
    return of_seam_node * nodes * nodes;
}

/// Sorts, and takes the cut before which there is most nearly the wanted work.
Cut cut_along(int axis, const EnrichedMesh& zone, std::span<WeightedGroup> groups, const Work& wanted) {
    std::ranges::stable_sort(groups, {}, [&](const WeightedGroup& w) { return w.group.centre[axis]; });
    Work before;
    Cut best{0, before.off(wanted)};
    for (std::size_t k = 0; k < groups.size(); ++k) {
        before += groups[k].work;
        if (before.off(wanted) < best.cost) best = {k + 1, before.off(wanted)};
    }
    best.cost += seam_between(zone, groups, best.groups);
    return best;
}

void bisect(const EnrichedMesh& zone, std::span<WeightedGroup> groups, int first_rank, int ranks) {
    if (ranks == 1) {
        for (WeightedGroup& w : groups) w.group.rank = first_rank;
        return;
    }
    const int half = ranks / 2;
    Work wanted;
    for (const WeightedGroup& w : groups) wanted += w.work;
    wanted = {wanted.elements * half / ranks, wanted.yielding * half / ranks};
    const Cut upright = cut_along(0, zone, groups, wanted);
    Cut cut = cut_along(1, zone, groups, wanted);
    if (upright.cost < cut.cost) cut = cut_along(0, zone, groups, wanted);
    const std::size_t before = std::clamp(cut.groups, at(half), groups.size() - at(ranks - half));  // nobody idles
    bisect(zone, groups.first(before), first_rank, half);
    bisect(zone, groups.subspan(before), first_rank + half, ranks - half);
}

/// False where a group has elements of several.
bool keep_owners(const EnrichedMesh& zone, const std::map<int, int>& owners, std::vector<ElementGroup>& groups) {
    for (ElementGroup& group : groups) {
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
void join_neighbours(const EnrichedMesh& zone, std::vector<ElementGroup>& groups) {
    std::vector<int> rank_at(zone.nodes.size(), -1);
    std::map<int, double> weight;
    const auto give = [&](ElementGroup& group, int rank) {
        group.rank = rank;
        weight[rank] += static_cast<double>(group.elements.size());
        for (const int element : group.elements)
            for (const int node : zone.elements[at(element)]) rank_at[at(node)] = rank;
    };
    for (ElementGroup& group : groups)
        if (group.rank >= 0) give(group, group.rank);
    const auto neighbour = [&](const ElementGroup& group) {
        for (const int element : group.elements)
            for (const int node : zone.elements[at(element)])
                if (rank_at[at(node)] >= 0) return rank_at[at(node)];
        return -1;
    };
    for (bool joined = true; joined;) {
        joined = false;
        for (ElementGroup& group : groups) {
            if (group.rank >= 0) continue;
            if (const int rank = neighbour(group); rank >= 0) {
                give(group, rank);
                joined = true;
            }
        }
    }
    const auto least = [](const auto& share) { return share.second; };
    for (ElementGroup& group : groups)
        if (group.rank < 0) give(group, std::ranges::min_element(weight, {}, least)->first);
}

std::vector<int> ranks_of_elements(const EnrichedMesh& zone, const std::vector<ElementGroup>& groups) {
    std::vector<int> rank(zone.elements.size(), 0);
    for (const ElementGroup& group : groups)
        for (const int element : group.elements) rank[at(element)] = group.rank;
    return rank;
}

}  // namespace

std::vector<int> share_out(const EnrichedMesh& zone, int ranks, const EnrichedMesh& before,
                           const std::vector<int>& part_of, const std::vector<double>& flow) {
    std::vector<WeightedGroup> weighted;
    for (ElementGroup& group : element_groups_with_ways(zone, before, part_of)) {
        Work work;
        for (const int element : group.elements) work += work_of(element, flow);
        weighted.push_back({std::move(group), work});
    }
    bisect(zone, weighted, 0, std::min(ranks, static_cast<int>(weighted.size())));
    std::vector<ElementGroup> groups;
    for (WeightedGroup& w : weighted) groups.push_back(std::move(w.group));
    return ranks_of_elements(zone, groups);
}

std::optional<std::vector<int>> share_on(const EnrichedMesh& zone, const std::map<int, int>& owners,
                                         const std::vector<int>& part_of) {
    std::vector<ElementGroup> groups = element_groups(zone, {}, part_of);
    if (!keep_owners(zone, owners, groups)) return std::nullopt;
    join_neighbours(zone, groups);
    return ranks_of_elements(zone, groups);
}

double cost_of_sharing(const EnrichedMesh& zone, const std::vector<int>& rank_of_element,
                       const std::vector<double>& flow) {
    std::map<int, Work> of_rank;
    std::vector<int> rank_at(zone.nodes.size(), -1);
    std::vector<char> is_shared(zone.nodes.size(), 0);
    for (int e = 0; e < std::ssize(zone.elements); ++e) {
        const int rank = rank_of_element[at(e)];
        of_rank[rank] += work_of(e, flow);
        for (const int node : zone.elements[at(e)]) {
            const int other = std::exchange(rank_at[at(node)], rank);
            if (other >= 0 && other != rank) is_shared[at(node)] = 1;
        }
    }
    Work most;
    for (const auto& [rank, work] : of_rank)
        most = {std::max(most.elements, work.elements), std::max(most.yielding, work.yielding)};
    const auto nodes = static_cast<double>(std::ranges::count(is_shared, 1));
    return most.elements + most.yielding + of_seam_node * nodes * nodes;
}

}  // namespace stria::coupling
