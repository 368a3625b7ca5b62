// A part of the plane on paper: one scale for both directions, as wide as a chart.
#pragma once

#include <cmath>
#include <string>

#include "app/charts/drawing.hpp"
#include "app/charts/scale.hpp"
#include "app/report/fields/field_cells.hpp"

namespace stria::report {

inline constexpr double picture_width = charts::width - charts::left - charts::right;  // pixels

struct Window {
    charts::Range x{INFINITY, -INFINITY}, y{INFINITY, -INFINITY};  // mm

    void enclose(FieldPoint point);
    void widen(double by);
    /// No taller than it is wide.
    void square();
    [[nodiscard]] bool holds(FieldPoint point) const;
};

/// From millimetres to pixels.
struct Plan {
    charts::Scale x, y;

    [[nodiscard]] double bottom() const { return y(y.ticks().front()); }
    [[nodiscard]] double top() const { return y(y.ticks().back()); }
};

/// The window grows to the round numbers on either side.
Plan plan_of(Window& window);

/// The numbers below the picture, and what they are. They need 35 pixels.
std::string axis_below(const Plan& plan);

}  // namespace stria::report
