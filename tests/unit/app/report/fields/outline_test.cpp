#include "app/report/fields/outline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace stria::report {
namespace {

/// A square of 3 mm about a hole of 1 mm, of eight squares; the one in the lower left corner is split in four.
FieldCells holed_square() {
    FieldCells field;
    const auto add_square = [&](double x, double y, double size) {
        const int first = static_cast<int>(field.points.size());
        for (const auto& [right, up] : {std::pair(0.0, 0.0), {size, 0.0}, {size, size}, {0.0, size}})
            field.points.push_back({x + right, y + up});
        field.cells.push_back({first, first + 1, first + 2, first + 3});
    };
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            if ((row != 1 || column != 1) && row + column > 0) add_square(column, row, 1.0);
    for (const double y : {0.0, 0.5})
        for (const double x : {0.0, 0.5}) add_square(x, y, 0.5);
    return field;
}

double twice_area(const std::vector<FieldPoint>& polygon) {
    double sum = 0.0;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const auto &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
        sum += a.x * b.y - b.x * a.y;
    }
    return sum;
}

TEST(Outline, HasTheHolesAndNoNodeThatHangs) {
    const FieldCells field = holed_square();
    std::vector<std::size_t> all(field.cells.size());
    std::iota(all.begin(), all.end(), 0U);
    const auto polygons = outline_of(field, all);
    ASSERT_EQ(polygons.size(), 2);
    std::vector<double> areas = {0.5 * twice_area(polygons[0]), 0.5 * twice_area(polygons[1])};
    std::ranges::sort(areas);
    EXPECT_NEAR(areas[0], -1.0, 1e-9);  // clockwise about the hole
    EXPECT_NEAR(areas[1], 9.0, 1e-9);
    const auto split = outline_of(field, {7, 8, 9, 10});
    ASSERT_EQ(split.size(), 1);
    EXPECT_EQ(split[0].size(), 4);
    EXPECT_NEAR(twice_area(split[0]), 2.0, 1e-9);
}

}  // namespace
}  // namespace stria::report
