// Elements at rest: where nothing has yielded for a cycle the zone is a linear substructure about its stored plastic
// strain (docs/equations.md, rest). Their points stay where they were until one of them would yield.
#pragma once

#include <vector>

#include "common/index_set.hpp"
#include "fine/bulk/bulk_elements.hpp"
#include "fine/bulk/elastic_bound.hpp"
#include "fine/bulk/element_values.hpp"
#include "fine/bulk/point_history.hpp"

namespace stria::fine {

/// Displacements are those of all unknowns of the mesh, mm.
class RestingElements {
public:
    RestingElements(const std::vector<ElementOperator>& operators, const Eigen::VectorXd& displacement);

    [[nodiscard]] bool contains(int e) const { return elements_.contains(e); }
    [[nodiscard]] const ElementSet& elements() const { return elements_; }
    /// Where they came to rest: the displacement of their points' states.
    [[nodiscard]] const Eigen::VectorXd& displacement() const { return displacement_; }

    /// These rest from now on, at a displacement.
    void rest(const ElementSet& elements, const Eigen::VectorXd& displacement,
              const std::vector<ElementOperator>& operators);
    void wake(int e) { elements_.erase(e); }

    /// What the unknowns of an element have moved since it came to rest, mm.
    [[nodiscard]] Eigen::VectorXd moved(const ElementOperator& op, const Eigen::VectorXd& u) const {
        return gather(u, op.unknowns) - gather(displacement_, op.unknowns);
    }

    /// Those that would yield at a displacement. `bound` keeps how far the others are from it. The history stays.
    [[nodiscard]] std::vector<int> would_yield(const Eigen::VectorXd& u, const BulkElements& bulk,
                                               PointHistory& history, ElasticBound& bound);

    /// A half cycle ends: counts those in which each element has stayed elastic.
    void count_half_cycle(const PointHistory& history);
    [[nodiscard]] const std::vector<int>& elastic_half_cycles() const { return elastic_half_cycles_; }
    void set_elastic_half_cycles(int e, int count) { elastic_half_cycles_[at(e)] = count; }
    /// Elements that have stayed elastic for a whole cycle, or cannot do else.
    [[nodiscard]] ElementSet may_rest(const PointHistory& history) const;

private:
    [[nodiscard]] bool would_yield(int e, const Eigen::VectorXd& u, const Eigen::VectorXd& since_rest,
                                   const BulkElements& bulk, PointHistory& history, ElasticBound& bound);

    ElementSet elements_;
    Eigen::VectorXd displacement_;
    ElementValues looked_at_;               // displacement at which the bound's margin was measured, mm
    std::vector<int> elastic_half_cycles_;  // per element, since it has yielded
};

}  // namespace stria::fine
