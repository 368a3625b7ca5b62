// All that the fine side remembers of the past, by element and by place: what a checkpoint holds of it. Any number of
// ranks can give it and take it.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "coupling/frozen_tip.hpp"

namespace stria::coupling {

/// A contact multiplier, known by its place.
struct MultiplierSnapshot {
    std::int32_t crack = 0;
    Vec2 place = Vec2::Zero();           // mm
    double pressure = 0.0, shear = 0.0;  // MPa
    std::int8_t status = 0;              // as in the digest
    double widened = 0.0, slid = 0.0;    // of faces apart: gap and slip in the last increment, mm
    double until_met = 0.0;              // what they are to slide yet, mm
    double settled_slip = 0.0;           // from where slips count, mm: the committed one, but for a growth's
    std::int32_t changes = 0;            // of its status: bit j: in the half cycle j before this one
    std::int8_t resting = 0;             // with these tractions, MPa:
    double rest_pressure = 0.0, rest_shear = 0.0;
    // Of pressure and shear, like those of the displacement.
    std::vector<double> increments, shear_increments;
};

struct ZoneSnapshot {
    std::int32_t ranks = 1;  // that gave it

    // Per element.
    std::vector<std::int32_t> element;      // id in the whole mesh
    std::vector<std::int32_t> rank;         // whose it is
    std::vector<std::int32_t> points;       // how many it has
    std::vector<std::int32_t> recent_flow;  // bit k: in the half cycle k before the last one
    std::vector<std::int32_t> unknowns;     // how many it has
    std::vector<std::int32_t> resting;      // since `rest_displacement`
    std::vector<double> flow;               // part of the recent iterations in which it yielded; one rank: 0

    // Per unknown of each element, element by element: the displacement at which the element's points stand, mm.
    std::vector<double> stand;

    double weighed_cost = 0.0;  // of an iteration, when the ranks last thought of another sharing

    // Per point, element by element, a row of `columns` numbers: x, y, xi, eta, weight, side, region, the plastic
    // strain of this half cycle, the frozen displacement gradient (xx, xy, yx, yy), then the state of its material law.
    std::int32_t columns = 0;
    std::vector<double> history;
    bool half_cycle_ended = false;

    // Of all unknowns of the patch's mesh, mm.
    Eigen::VectorXd displacement;
    Eigen::VectorXd rest_displacement;
    std::vector<Eigen::VectorXd> increments;  // the last ones, for predictors; the last of all first
    Eigen::VectorXd held;                     // by opening faces, N/mm: zero between increments, but for a growth's

    std::vector<MultiplierSnapshot> multipliers;  // crack by crack, along each
    std::vector<FrozenTip> frozen_tips;
};

/// Where in `history` the points of an element are, and its part of `stand`.
struct ElementHistory {
    std::size_t first_row = 0, rows = 0;
    std::size_t first_unknown = 0, unknowns = 0;
};

/// Of each element of a snapshot, in its order.
std::vector<ElementHistory> histories_of_elements(const ZoneSnapshot& snapshot);

/// What of it belongs to a part's mesh, elements in its order; `unknowns`: of the patch, of each unknown of the part.
ZoneSnapshot part_of(const ZoneSnapshot& whole, const EnrichedMesh& part, const std::vector<int>& unknowns);

/// One more part, that of a rank; `unknowns` as above. `whole` has its displacement vectors already.
void add(ZoneSnapshot& whole, const ZoneSnapshot& part, std::int32_t rank, const std::vector<int>& unknowns);

}  // namespace stria::coupling
