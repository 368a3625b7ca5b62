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
/// drives them to and fro, farther each time, and drags the nodes beside along. Sides of up to a hundredth of their
/// element are thin. What strains one may do nothing in any other element, as where a crack begins to part from a line
/// of the mesh. Metal of it that flows far is driven to and fro as well, until all else is nearly in balance.
class IdleSides {
public:
    /// None.
    IdleSides() = default;

    /// `tolerance`: relative residual. A stress s makes a nodal force of s h in an element of edge h, and of s A / h on
    /// a side of area A; the largest force is that of the largest edge.
    IdleSides(const BulkElements& elements, double tolerance) : idle_(elements.count()), thin_(elements.count()) {
        constexpr double most = 0.01;  // of an element, whatever is tolerated
        double largest = 0.0;
        std::vector<Areas> areas;
        for (const ElementOperator& op : elements.operators())
            largest = std::max(largest, whole(areas.emplace_back(areas_of(op))));
        for (int e = 0; e < elements.count(); ++e) {
            const double area = whole(areas[at(e)]);
            thin_.note(e, areas[at(e)], most * area);
            idle_.note(e, areas[at(e)], std::min(tolerance * std::sqrt(largest * area), most * area));
        }
    }

    /// Whether a point of an element is on one of them, or on a thin side of an element that flows far. `flow`: its
    /// largest plastic strain of an increment in the first states of it; then 0. It is looked at in few elements: this
    /// is asked of all that flow.
    [[nodiscard]] bool contain(int element, const IntegrationPoint& point, double flow) const {
        constexpr double far = 1e-3;  // about the strain of yield
        return (flow > far ? thin_ : idle_).contain(element, point.side);
    }

private:
    using Areas = std::array<double, 3>;  // mm2: on the minus side, of no side, on the plus side

    class Sides {
    public:
        explicit Sides(int elements = 0) : minus_(elements), plus_(elements) {}
        void note(int element, const Areas& areas, double most) {
            if (areas[0] > 0.0 && areas[0] <= most) minus_.insert(element);
            if (areas[2] > 0.0 && areas[2] <= most) plus_.insert(element);
        }
        [[nodiscard]] bool contain(int element, int side) const {
            return element < plus_.size() && side != 0 && (side > 0 ? plus_ : minus_).contains(element);
        }

    private:
        ElementSet minus_, plus_;
    };

    [[nodiscard]] static Areas areas_of(const ElementOperator& op) {
        Areas areas{};
        for (const IntegrationPoint& point : op.points) areas[at(point.side + 1)] += point.weight;
        return areas;
    }
    [[nodiscard]] static double whole(const Areas& areas) { return areas[0] + areas[1] + areas[2]; }

    Sides idle_, thin_;
};

}  // namespace stria::fine
