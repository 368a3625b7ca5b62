// What sums the bulk up after each commit: energies, and how far plasticity reaches. Element by element, so that only
// those are looked at again whose points may have changed.
#pragma once

#include <vector>

#include "coupling/messages.hpp"
#include "fine/bulk/bulk.hpp"

namespace stria::fine {

/// Of the committed states of the points, per mm of thickness.
class BulkSummary {
public:
    /// Of all elements.
    explicit BulkSummary(const Bulk& bulk);

    /// After a commit of the same bulk: looks at elements whose points it has moved, and follows the others that do not
    /// rest. `half_cycle_begins`: with its increment.
    void update(const Bulk& bulk, bool half_cycle_begins);
    /// The points of this one have a new state.
    void look_at(const Bulk& bulk, int e);
    /// It has moved, and its points stand where they stood.
    void follow(const Bulk& bulk, int e) { stored_ahead_[at(e)] = bulk.stored_ahead_of_points(e); }

    [[nodiscard]] double dissipation() const { return sum(dissipation_); }  // N
    /// But for what elements at rest have stored since they came to rest, N.
    [[nodiscard]] double stored_energy() const { return sum(stored_) + sum(stored_ahead_); }
    /// An element about a tip holds a point that has ever flowed.
    [[nodiscard]] bool has_flowed(int e) const;
    /// How far plasticity reaches from a tip of the mesh. A point belongs to the tip that is nearest to it, and to no
    /// other one.
    struct PlasticExtent {
        std::vector<coupling::FlowShell> flow;       // in this half cycle, within 135 degrees of the line ahead; joined
        std::vector<coupling::FlowShell> flow_ever;  // joined
    };
    /// One per tip. `mesh`: of the bulk.
    [[nodiscard]] std::vector<PlasticExtent> plastic_extents(const EnrichedMesh& mesh) const;

private:
    [[nodiscard]] static double sum(const std::vector<double>& of_elements);

    struct Extent {
        double ever = 0.0;  // largest distance of a point that has ever yielded, mm
        double zone = 0.0;  // of one that has yielded in this half cycle, and not in the wake, mm
        double axis = 0.0;  // of these, within 15 degrees of the line ahead, mm
    };
    std::size_t tips_;
    std::vector<double> dissipation_, stored_;  // per element, where its points stand, N
    std::vector<double> stored_ahead_;          // per element, on the way from there, N
    std::vector<Extent> extents_;               // per element, tip by tip
};

}  // namespace stria::fine
