// Plates without cracks, put together by hand: regions of their own metal, boundaries that are held or moved.
#pragma once

#include <optional>
#include <vector>

#include "common/case/case.hpp"

namespace stria::test {

/// Of steel, mm.
inline Case steel_plate(double width, double height, double size) {
    Case input;
    input.mesh = {.specimen = "plate", .width = width, .height = height, .size = size, .grading = {}};
    input.material.young = 200e3;
    input.material.poisson = 0.3;
    return input;
}

inline RegionSection region_of(std::vector<Vec2> outline, double E, double nu) {
    RegionSection region;
    region.outline = std::move(outline);
    region.material.young = E;
    region.material.poisson = nu;
    return region;
}

/// By so many mm at the load factor 1; absent: free.
inline BoundarySection moved(const char* on, std::optional<double> x, std::optional<double> y) {
    BoundarySection section;
    section.on = on;
    section.displacement = {x, y};
    return section;
}

}  // namespace stria::test
