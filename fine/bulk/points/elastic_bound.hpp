// Which elements surely stay elastic: their points need not be looked at.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "common/index.hpp"
#include "fine/bulk/points/stress_changes.hpp"

namespace stria::fine {

/// Of a von Mises yield surface, wherever its centre is: a point flows only where the von Mises stress of what its
/// stress changes by, elastically, reaches the distance to the surface.
class ElasticBound {
public:
    /// Numbered as they come.
    void add_element(const ElementOperator& op, const std::array<Vec2, 4>& corners, const VonMisesForm& form) {
        changes_.add_element(op, corners, form);
        margin_.push_back(0.0);
    }
    /// As StressChanges has it.
    void add_element_of(const ElasticBound& other, int element, const ElementOperator& op) {
        changes_.add_element_of(other.changes_, element, op);
        margin_.push_back(other.margin_[at(element)]);
    }
    void reserve(std::span<const ElementOperator> operators) { changes_.reserve(operators); }

    /// At a displacement in the order of its unknowns, mm, an element's points are so far from the yield surface, MPa:
    /// the smallest distance of any, below zero beyond it. The coming changes begin there.
    void look_at(int element, const Eigen::VectorXd& element_u, double margin) {
        changes_.look_at(element, element_u);
        margin_[at(element)] = std::max(margin, 0.0);
    }

    /// Nothing flows on the way from there to a displacement of all unknowns of the mesh, mm, nor on one that is longer
    /// by 1 / `part`.
    [[nodiscard]] bool proves_at(int element, const Eigen::VectorXd& u, double part = 1.0) const {
        constexpr double safety = 1.0 - 1e-6;  // what rounding may do
        const double margin = part * margin_[at(element)];
        return changes_.stay_below(element, u, safety * margin * margin);
    }

private:
    StressChanges changes_;
    std::vector<double> margin_;  // per element
};

}  // namespace stria::fine
