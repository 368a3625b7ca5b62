// Where the points of elements stand, and what follows from there while the elements are elastic.
#pragma once

#include <algorithm>

#include "fine/bulk/bulk_elements.hpp"
#include "fine/bulk/points/elastic_bound.hpp"
#include "fine/bulk/points/element_kernels.hpp"
#include "fine/bulk/points/element_values.hpp"
#include "fine/bulk/points/point_history.hpp"

namespace stria::fine {

/// The points of an element *stand* at the displacement at which their law was last asked for a state that was then
/// committed. From there on the element has been elastic: its force, stresses and energy follow by its elastic matrix,
/// and nobody moves its points until they might flow. Displacements are in mm, those of an element in the order of its
/// unknowns; forces per thickness, N/mm.
class StandingPoints {
public:
    /// `old`: null, or those of the zone before, where elements that have stayed stand as they did. The others stand
    /// nowhere yet.
    StandingPoints(const BulkElements& elements, const StandingPoints* old);

    /// An element's points have come here, with their committed states.
    void stand_at(int e, const Eigen::VectorXd& element_u, const BulkElements& elements, const PointHistory& history);

    /// The points of an element that is elastic up to a displacement of all unknowns go there.
    void bring_to(int e, const Eigen::VectorXd& u, const BulkElements& elements, PointHistory& history);

    [[nodiscard]] auto displacement(int e) const { return displacement_.of(e); }
    /// How often an element's points have come to stand somewhere.
    [[nodiscard]] int times_moved(int e) const { return times_moved_[at(e)]; }
    /// What an element is ahead of its points at a displacement of all unknowns.
    [[nodiscard]] Eigen::VectorXd ahead(const ElementOperator& op, int e, const Eigen::VectorXd& u) const {
        return gather(u, op.unknowns) - displacement(e);
    }

    /// Its points stand at a displacement of all unknowns.
    [[nodiscard]] bool stands_at(const ElementOperator& op, int e, const Eigen::VectorXd& u) const {
        return std::ranges::equal(op.unknowns, displacement(e), {}, [&](int unknown) { return u[unknown]; });
    }

    /// Nodal, of an element that is elastic up to a displacement of all unknowns.
    void find_force(int e, const Eigen::VectorXd& u, const BulkElements& elements, ElementValues& force) const;
    /// What it stores on its way from where its points stand to a displacement of all unknowns, N.
    [[nodiscard]] double stored(int e, const Eigen::VectorXd& u, const BulkElements& elements) const;

    /// As ElasticBound has it.
    [[nodiscard]] bool proves_at(int e, const Eigen::VectorXd& u, double part = 1.0) const {
        return bound_.proves_at(e, u, part);
    }
    /// Whether an element that has been elastic so far would yield at a displacement of all unknowns. Its points stay
    /// where they stand; what proves it elastic from now on begins where it was looked at.
    [[nodiscard]] bool would_yield_at(int e, const Eigen::VectorXd& u, const BulkElements& elements,
                                      PointHistory& history);
    /// It begins again where its points stand.
    void look_back(int e, const PointHistory& history) {
        bound_.look_at(e, displacement(e), history.elastic_margin(e));
    }

private:
    ElementValues displacement_, force_;
    std::vector<int> times_moved_;
    ElasticBound bound_;
};

}  // namespace stria::fine
