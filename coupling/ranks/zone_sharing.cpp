#include "coupling/ranks/zone_sharing.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include "coupling/ranks/zone_partition.hpp"

namespace stria::coupling {
namespace {

std::map<int, int> by_id(const EnrichedMesh& zone, const std::vector<int>& rank_of) {
    std::map<int, int> owners;
    for (std::size_t e = 0; e < rank_of.size(); ++e)
        owners.emplace_hint(owners.end(), zone.element_ids[e], rank_of[e]);  // ascending ids
    return owners;
}

std::map<int, int> owners_in(const ZoneSnapshot& snapshot) {
    std::map<int, int> owners;
    for (std::size_t e = 0; e < snapshot.element.size(); ++e) owners[snapshot.element[e]] = snapshot.rank[e];
    return owners;
}

}  // namespace

bool ZoneSharing::turn_to(const Patch& next, const EnrichedMesh& present, int used) {
    constexpr double much_better = 0.85, another = 0.05;
    next_flow_ = flow_in(next, present);
    // Who has lost all elements gets none by a new sharing; where one that is new comes to it, it begins anew (divide).
    const int ranks = owner_.empty() ? ranks_ : used;
    const std::optional<std::vector<int>> on =
        owner_.empty() ? std::nullopt : share_on(next.mesh, owner_, next.part_of);
    const auto cost = [&](const std::vector<int>& rank_of) { return cost_of_sharing(next.mesh, rank_of, next_flow_); };
    const double cost_on = on ? cost(*on) : 0.0;
    if (on && (ranks == 1 || !next.part_of.empty() || std::abs(cost_on - weighed_cost_) < another * weighed_cost_)) {
        owner_ = by_id(next.mesh, *on);
        return false;
    }
    const std::vector<int> anew = share_out(next.mesh, ranks, present, next.part_of, next_flow_);
    const bool stays = on && cost(anew) > much_better * cost_on;
    weighed_cost_ = stays ? cost_on : cost(anew);
    const bool knew = !std::exchange(owner_, by_id(next.mesh, stays ? *on : anew)).empty();
    return knew && !stays;
}

void ZoneSharing::resume(const Patch& patch, const ZoneSnapshot& snapshot) {
    const bool same_ranks = snapshot.ranks == ranks_;
    owner_ = same_ranks ? owners_in(snapshot) : by_id(patch.mesh, share_out(patch.mesh, ranks_, {}, {}, snapshot.flow));
    flow_ = snapshot.flow;
    weighed_cost_ = same_ranks ? snapshot.weighed_cost : 0.0;
}

/// By id; parts have that of their whole.
std::vector<double> ZoneSharing::flow_in(const Patch& next, const EnrichedMesh& present) const {
    std::map<int, double> known;
    for (std::size_t e = 0; e < flow_.size(); ++e) known.emplace_hint(known.end(), present.element_ids[e], flow_[e]);
    std::vector<double> flow;
    for (std::size_t e = 0; e < next.mesh.elements.size(); ++e) {
        const bool is_part = !next.part_of.empty() && next.part_of[e] >= 0;
        const auto found = known.find(is_part ? next.part_of[e] : next.mesh.element_ids[e]);
        flow.push_back(found != known.end() ? found->second : 0.0);
    }
    return flow;
}

void ZoneSharing::note(const Digest& digest) {
    constexpr double newest = 1.0 / 64.0;  // of a mean that forgets: about a cycle
    for (std::size_t e = 0; e < flow_.size(); ++e)
        flow_[e] += newest * ((digest.yielding_points[e] > 0 ? 1.0 : 0.0) - flow_[e]);
}

}  // namespace stria::coupling
