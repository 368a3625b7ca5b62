// Points and what they remember as rows of numbers: ZoneSnapshot::history (coupling/zone_snapshot.hpp).
#pragma once

#include <vector>

#include "coupling/zone_snapshot.hpp"
#include "fine/bulk/points/point_history.hpp"

namespace stria::fine {

/// The points of an element, from its rows.
std::vector<IntegrationPoint> points_of(const coupling::ZoneSnapshot& snapshot, const coupling::ElementHistory& rows);

/// Committed states, row by row. Throws std::logic_error where the rows are not those of such points and such a law.
void read_rows(const coupling::ZoneSnapshot& snapshot, const std::vector<ElementOperator>& operators,
               PointHistory& history);

void write_rows(const std::vector<ElementOperator>& operators, const PointHistory& history,
                coupling::ZoneSnapshot& snapshot);

}  // namespace stria::fine
