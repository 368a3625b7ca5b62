#include "common/geometry/points_by_place.hpp"

#include <bit>
#include <cmath>

#include "common/index.hpp"

namespace stria {

// Points of a grid lie inside cells, so that mostly one cell is looked into.
PointsByPlace::PointsByPlace(std::span<const Vec2> points, double distance)
    : points_(points), cell_(distance), tolerance_(1e-6 * distance),
      origin_(points.empty() ? Vec2::Zero() : Vec2(points.front() - 0.5 * Vec2(distance, distance))),
      first_(std::bit_ceil(points.size() + 1), -1), next_(points.size(), -1) {
    for (int p = 0; p < std::ssize(points); ++p) {
        const Vec2& x = points[at(p)];
        int& first = first_[list_of(cell_along(x.x(), 0), cell_along(x.y(), 1))];
        next_[at(p)] = first;
        first = p;
    }
}

int PointsByPlace::at_place(const Vec2& x) const {
    const std::int64_t right = cell_along(x.x() + tolerance_, 0), top = cell_along(x.y() + tolerance_, 1);
    for (std::int64_t column = cell_along(x.x() - tolerance_, 0); column <= right; ++column)
        for (std::int64_t row = cell_along(x.y() - tolerance_, 1); row <= top; ++row)
            for (int p = first_[list_of(column, row)]; p >= 0; p = next_[at(p)])
                if ((points_[at(p)] - x).squaredNorm() <= tolerance_ * tolerance_) return p;
    return -1;
}

std::int64_t PointsByPlace::cell_along(double coordinate, int axis) const {
    return static_cast<std::int64_t>(std::floor((coordinate - origin_[axis]) / cell_));
}

std::size_t PointsByPlace::list_of(std::int64_t column, std::int64_t row) const {
    constexpr std::uint64_t odd = 0x9e3779b97f4a7c15, other = 0xc2b2ae3d27d4eb4f;
    const std::uint64_t mixed = static_cast<std::uint64_t>(column) * odd + static_cast<std::uint64_t>(row) * other;
    return (mixed ^ (mixed >> 32U)) & (first_.size() - 1);
}

}  // namespace stria
