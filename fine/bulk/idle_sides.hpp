// Slivers that a crack leaves of elements: they bear less than any residual shows.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

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
        for (const ElementOperator& op : elements.operators()) largest = std::max(largest, whole(areas_of(op)));
        for (int e = 0; e < elements.count(); ++e) {
            const Areas areas = areas_of(elements.op(e));
            const double area = whole(areas), idle = std::min(tolerance * std::sqrt(largest * area), most * area);
            const auto is_idle = [&](double side) { return side > 0.0 && side <= idle; };
            if (is_idle(areas[0])) minus_.insert(e);
            if (is_idle(areas[2])) plus_.insert(e);
        }
    }

    /// `side`: of a point, -1 or 1; 0 where the element is not cut, and then never.
    [[nodiscard]] bool contain(int element, int side) const {
        const ElementSet& idle = side < 0 ? minus_ : plus_;
        return side != 0 && element < idle.size() && idle.contains(element);
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
