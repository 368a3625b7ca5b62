// Which of many points lies at a place.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "common/geometry/vec2.hpp"

namespace stria {

/// Points in square cells, one list of them for all cells with the same hash.
class PointsByPlace {
public:
    /// They must outlive it. `distance`: about that of two neighbours where they are closest, mm.
    PointsByPlace(std::span<const Vec2> points, double distance);

    /// The point at a place, to a millionth of that distance; -1: none.
    [[nodiscard]] int at_place(const Vec2& x) const;

private:
    [[nodiscard]] std::int64_t cell_along(double coordinate, int axis) const;
    [[nodiscard]] std::size_t list_of(std::int64_t column, std::int64_t row) const;

    std::span<const Vec2> points_;
    double cell_, tolerance_;
    Vec2 origin_;
    std::vector<int> first_, next_;  // per list, per point; -1: the end
};

}  // namespace stria
