// What is reported of the bulk: its share of domain integrals, who yields, the force ahead of a tip, and the state of
// its points.
#pragma once

#include "common/fracture/domain_integral.hpp"
#include "coupling/messages.hpp"
#include "fine/bulk/bulk.hpp"
#include "fine/bulk/elastic_answers.hpp"

namespace stria::fine {

/// Adds the committed bulk's share to the domain integrals of a tip. `answers`: of this bulk to it, so far.
void add_to(RingSums& rings, const Bulk& bulk, EnergyDensity density, ElasticAnswers& answers);

/// Of the trial state, per element: points that yield.
[[nodiscard]] std::vector<std::int32_t> yielding_points(const Bulk& bulk);

/// Of the accumulated plastic strain in the trial increment, over all points that yield.
[[nodiscard]] double largest_plastic_increment(const Bulk& bulk);

/// Integral of the normal stress, across the line ahead, over the sector of 45 degrees to either side within a radius
/// (mm) of where the faces end, N; of the trial state. From the tip itself it would be half an element of open faces,
/// or lack as much of the metal ahead.
[[nodiscard]] double force_ahead(const Bulk& bulk, const Tip& tip, double radius);

/// Committed, point by point.
[[nodiscard]] coupling::ZoneState state_of(const Bulk& bulk);

}  // namespace stria::fine
