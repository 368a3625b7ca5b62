// Node positions along one axis of a structured mesh, graded towards points and intervals.
#pragma once

#include <span>
#include <vector>

namespace stria::coarse {

/// What one grading of the case asks of one axis: edge length `size` within [low, high], growing linearly to
/// `outer_size` at the distance `radius` from it, and by `growth` mm per mm beyond.
struct AxisGrading {
    double low;         // mm
    double high;        // mm
    double size;        // mm
    double outer_size;  // mm
    double radius;      // mm
    double growth;      // mm per mm
    bool centred;       // an anchor: the middle of [low, high] lies in the middle of a cell
};

/// Positions 0 ... length such that cells have the length h(x), the smallest of all wishes and `size`. Counts of cells
/// are rounded up, so that no cell is longer than the largest h in it; without gradings to the nearest. An anchor
/// nearer to an end of the axis than 3/4 of its cell, or to an anchor before it than one cell, is graded to but not
/// centred: the cells there would be slivers. `lines`: ascending; those inside the axis are positions, and an anchor
/// nearer to one than 3/4 of its cell is not centred. Throws CaseError if there would be more than a million positions.
std::vector<double> graded_axis(double length, double size, std::span<const AxisGrading> gradings,
                                std::span<const double> lines = {});

}  // namespace stria::coarse
