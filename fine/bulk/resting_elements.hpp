// Elements at rest: where nothing yields in a half cycle the zone is a linear substructure about its stored plastic
// strain (docs/equations.md, rest). Their points stay where they were until one of them would yield.
#pragma once

#include <vector>

#include "common/index_set.hpp"
#include "fine/bulk/bulk_elements.hpp"
#include "fine/bulk/points/point_history.hpp"

namespace stria::fine {

/// Displacements are those of all unknowns of the mesh, mm.
class RestingElements {
public:
    RestingElements(const BulkElements& bulk, const Eigen::VectorXd& displacement);

    [[nodiscard]] bool contains(int e) const { return elements_.contains(e); }
    [[nodiscard]] const ElementSet& elements() const { return elements_; }
    /// The others, ascending.
    [[nodiscard]] const std::vector<int>& awake() const { return awake_; }
    /// Where they came to rest.
    [[nodiscard]] const Eigen::VectorXd& displacement() const { return displacement_; }

    /// These rest from now on, at a displacement.
    void rest(const ElementSet& elements, const Eigen::VectorXd& displacement);
    void wake(const ElementSet& waking);

    /// A half cycle ends: notes where something has yielded in it.
    void note_half_cycle(const PointHistory& history);
    /// Per element, bit k: something has yielded in the half cycle k before the last one. All unknown bits are set.
    [[nodiscard]] const std::vector<int>& recent_flow() const { return recent_flow_; }
    void set_recent_flow(int e, int flow) { recent_flow_[at(e)] = flow; }
    /// Elements that have stayed elastic in the last half cycle of the direction that comes, together with those
    /// around them: tips, and flow with them, move a little. And those that cannot do else. None of `softened`,
    /// whose tangents are not elastic.
    [[nodiscard]] ElementSet may_rest(const BulkElements& bulk, const PointHistory& history,
                                      const ElementSet& softened) const;

private:
    ElementSet elements_;
    std::vector<int> awake_;  // so that an evaluation does not pass over the others
    Eigen::VectorXd displacement_;
    std::vector<int> recent_flow_;
};

}  // namespace stria::fine
