#include "coupling/ranks/zone_partition.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <span>

#include "common/index.hpp"
#include "coupling/ranks/element_groups.hpp"

namespace stria::coupling {
namespace {

/// What elements cost in an iteration; of one that does not yield: 1. Yielding, with the points of it and the fronts
/// above it: 20, from seconds of ranks with few and with many such elements (docs/performance.md).
class Work {
public:
    explicit Work(const std::vector<double>& flow) : flow_(flow) {}
    [[nodiscard]] double of(int element) const { return 1.0 + (flow_.empty() ? 0.0 : 20.0 * flow_[at(element)]); }
    [[nodiscard]] double of(const ElementGroup& group) const {
        double sum = 0.0;
        for (const int element : group.elements) sum += of(element);
        return sum;
    }

private:
    const std::vector<double>& flow_;
};

/// The groups, sorted along an axis, before the cut that comes closest to the wanted work; by how much it misses, and
/// how many nodes lie on both sides.
struct Cut {
    std::size_t groups;
    double miss;
    long seam;
};
Cut cut_along(int axis, const EnrichedMesh& zone, const Work& work, std::span<ElementGroup> groups, double wanted) {
    std::ranges::stable_sort(groups, {}, [&](const ElementGroup& group) { return group.centre[axis]; });
    Cut best{0, wanted, 0};
    double sum = 0.0;
    for (std::size_t k = 0; k < groups.size(); ++k) {
        sum += work.of(groups[k]);
        if (std::abs(sum - wanted) < best.miss) best = {k + 1, std::abs(sum - wanted), 0};
    }
    std::vector<char> sides(zone.nodes.size(), 0);
    for (std::size_t k = 0; k < groups.size(); ++k)
        for (const int element : groups[k].elements)
            for (const int node : zone.elements[at(element)])
                sides[at(node)] = static_cast<char>(sides[at(node)] | (k < best.groups ? 1 : 2));
    best.seam = std::ranges::count(sides, 3);
    return best;
}

// For a short seam, unless a crack, which is one group, would upset the balance.
void bisect(const EnrichedMesh& zone, const Work& work, std::span<ElementGroup> groups, int first_rank, int ranks) {
    if (ranks == 1) {
        for (ElementGroup& group : groups) group.rank = first_rank;
        return;
    }
    const int half = ranks / 2;
    double total = 0.0;
    for (const ElementGroup& group : groups) total += work.of(group);
    const double wanted = total * half / ranks, balanced = total / 20.0;
    const Cut upright = cut_along(0, zone, work, groups, wanted);
    Cut cut = cut_along(1, zone, work, groups, wanted);
    const bool alike = std::abs(upright.miss - cut.miss) <= balanced;
    if (alike ? upright.seam < cut.seam : upright.miss < cut.miss) cut = cut_along(0, zone, work, groups, wanted);
    const std::size_t before = std::clamp(cut.groups, at(half), groups.size() - at(ranks - half));  // nobody idles
    bisect(zone, work, groups.first(before), first_rank, half);
    bisect(zone, work, groups.subspan(before), first_rank + half, ranks - half);
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
    std::vector<ElementGroup> groups = element_groups_with_ways(zone, before, part_of);
    bisect(zone, Work(flow), groups, 0, std::min(ranks, static_cast<int>(groups.size())));
    return ranks_of_elements(zone, groups);
}

std::optional<std::vector<int>> share_on(const EnrichedMesh& zone, const std::map<int, int>& owners,
                                         const std::vector<int>& part_of) {
    std::vector<ElementGroup> groups = element_groups(zone, {}, part_of);
    if (!keep_owners(zone, owners, groups)) return std::nullopt;
    join_neighbours(zone, groups);
    return ranks_of_elements(zone, groups);
}

double heaviest_share(const std::vector<int>& rank_of_element, int ranks, const std::vector<double>& flow) {
    const Work work(flow);
    std::vector<double> sum(at(ranks), 0.0);
    for (int e = 0; e < std::ssize(rank_of_element); ++e) sum[at(rank_of_element[at(e)])] += work.of(e);
    return std::ranges::max(sum) * ranks / std::reduce(sum.begin(), sum.end());
}

}  // namespace stria::coupling
