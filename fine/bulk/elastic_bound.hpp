// Which elements surely stay elastic: their points need not be looked at until the increment is committed.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "common/index.hpp"
#include "fine/bulk/stress_changes.hpp"

namespace stria::fine {

/// Of a von Mises yield surface, wherever its centre is: a point flows only where the von Mises stress of what its
/// stress changes by, elastically, reaches the distance to the surface. Displacements are those of all unknowns of the
/// mesh, mm.
class ElasticBound {
public:
    /// Numbered as they come.
    void add_element(const ElementOperator& op, const VonMisesForm& form) {
        changes_.add_element(op, form);
        margin_.push_back(0.0);
    }
    /// As StressChanges has it.
    void add_element_of(const ElasticBound& other, int element, const ElementOperator& op) {
        changes_.add_element_of(other.changes_, element, op);
        margin_.push_back(0.0);
    }
    void reserve(std::span<const ElementOperator> operators) { changes_.reserve(operators); }

    /// The smallest distance to the yield surface of an element's points, MPa: of what the coming changes begin with.
    void set_margin(int element, double margin) { margin_[at(element)] = margin; }
    /// They begin with this displacement, for proves_at().
    void look_at(int element, const Eigen::VectorXd& u) { changes_.look_at(element, u); }

    /// Nothing flows on the way of an increment, or to a displacement.
    [[nodiscard]] bool proves(int element, const Eigen::VectorXd& increment) const {
        return is_within(element, changes_.by(element, increment));
    }
    [[nodiscard]] bool proves_at(int element, const Eigen::VectorXd& u) const {
        return is_within(element, changes_.at_displacement(element, u));
    }

private:
    [[nodiscard]] bool is_within(int element, double change) const {
        constexpr double safety = 1.0 - 1e-6;  // what rounding may do
        return change < safety * margin_[at(element)] * margin_[at(element)];
    }

    StressChanges changes_;
    std::vector<double> margin_;  // per element
};

}  // namespace stria::fine
