// Slivers that a crack leaves of elements: they bear less than any residual shows.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "common/index_set.hpp"
#include "fine/bulk/bulk_elements.hpp"

namespace stria::fine {

/// Sides of cut elements that are idle (docs/equations.md): all that their stresses could do on a node is within the
/// residual that Newton's method leaves. So their equations hold whatever they do there, and where their metal flows it
/// drives them to and fro, farther each time, and drags the nodes beside along.
class IdleSides {
public:
    /// None.
    IdleSides() = default;

    /// `tolerance`: relative residual. A stress s makes a nodal force of s h in an element of edge h, and of s A / h on
    /// a side of area A; the largest force is that of the largest edge.
    IdleSides(const BulkElements& elements, double tolerance) : minus_(elements.count()), plus_(elements.count()) {
        constexpr double most = 0.01;  // of an element, whatever is tolerated
        double largest = 0.0;
        std::vector<Areas> areas;
        for (const ElementOperator& op : elements.operators())
            largest = std::max(largest, whole(areas.emplace_back(areas_of(op))));
        for (int e = 0; e < elements.count(); ++e) {
            const auto& [minus, uncut, plus] = areas[at(e)];
            const double area = whole(areas[at(e)]),
                         idle = std::min(tolerance * std::sqrt(largest * area), most * area);
            if (minus > 0.0 && minus <= idle) minus_.insert(e);
            if (plus > 0.0 && plus <= idle) plus_.insert(e);
        }
    }

    /// Whether a point of an element is on one of them. It is looked at in few elements: this is asked of all that
    /// flow.
    [[nodiscard]] bool contain(int element, const IntegrationPoint& point) const {
        return element < plus_.size() &&
               ((plus_.contains(element) && point.side > 0) || (minus_.contains(element) && point.side < 0));
    }

private:
    using Areas = std::array<double, 3>;  // mm2: on the minus side, of no side, on the plus side

    [[nodiscard]] static Areas areas_of(const ElementOperator& op) {
        Areas areas{};
        for (const IntegrationPoint& point : op.points) areas[at(point.side + 1)] += point.weight;
        return areas;
    }
    [[nodiscard]] static double whole(const Areas& areas) { return areas[0] + areas[1] + areas[2]; }

    ElementSet minus_, plus_;
};

}  // namespace stria::fine
