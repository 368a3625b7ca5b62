// Which rank has which elements of the zone, from patch to patch, and how much of late has flowed in them.
#pragma once

#include <map>
#include <vector>

#include "coupling/messages.hpp"
#include "coupling/zone_snapshot.hpp"

namespace stria::coupling {

/// Elements keep their rank unless a crack ties together those of several, or another sharing costs much less. That is
/// looked at where the cost is another one than when it was looked at last. While elements are split their history
/// stays where it is.
class ZoneSharing {
public:
    explicit ZoneSharing(int ranks) : ranks_(ranks) {}

    /// Of the next patch, of which nothing is known yet but in the `present` mesh. `used`: ranks that have elements
    /// there. True where elements change their rank that have a history: it moves first.
    [[nodiscard]] bool turn_to(const Patch& next, const EnrichedMesh& present, int used);
    /// The next patch is there: flow() is that of its elements.
    void arrive() { flow_ = std::move(next_flow_); }

    /// What a snapshot of as many ranks says; else the zone is shared out anew.
    void resume(const Patch& patch, const ZoneSnapshot& snapshot);

    /// Counts which elements yield in an iteration.
    void note(const Digest& digest);

    [[nodiscard]] const std::map<int, int>& owner() const { return owner_; }  // rank by id of an element
    [[nodiscard]] const std::vector<double>& flow() const { return flow_; }   // of each element: cost_of_sharing()
    [[nodiscard]] double weighed_cost() const { return weighed_cost_; }       // ZoneSnapshot::weighed_cost

private:
    [[nodiscard]] std::vector<double> flow_in(const Patch& next, const EnrichedMesh& present) const;

    int ranks_;
    std::map<int, int> owner_;
    std::vector<double> flow_, next_flow_;
    double weighed_cost_ = 0.0;
};

}  // namespace stria::coupling
