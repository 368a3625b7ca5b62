// The outline of a part of a mesh: what bounds it outside and its holes.
#pragma once

#include <vector>

#include "app/report/fields/field_cells.hpp"

namespace stria::report {

/// Closed polygons about these cells, in mm: counterclockwise outside, clockwise about holes. Cells meet where their
/// edges do, whatever their points: a crack between two cells bounds nothing, and neither does a node that hangs on an
/// edge. Where an outline goes straight on it has no corner.
std::vector<std::vector<FieldPoint>> outline_of(const FieldCells& field, const std::vector<std::size_t>& cells);

}  // namespace stria::report
