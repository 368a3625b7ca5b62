#include "app/report/fields/plan_view.hpp"

#include <algorithm>

namespace stria::report {

void Window::enclose(FieldPoint point) {
    x = {std::min(x.low, point.x), std::max(x.high, point.x)};
    y = {std::min(y.low, point.y), std::max(y.high, point.y)};
}

void Window::widen(double by) {
    x = {x.low - by, x.high + by};
    y = {y.low - by, y.high + by};
}

void Window::square() {
    const double excess = 0.5 * ((y.high - y.low) - (x.high - x.low));
    if (excess > 0.0) x = {x.low - excess, x.high + excess};
}

bool Window::holds(FieldPoint point) const {
    return point.x >= x.low && point.x <= x.high && point.y >= y.low && point.y <= y.high;
}

Plan plan_of(Window& window) {
    charts::Scale x(charts::linear_ticks(window.x, 6), false, {charts::left, charts::left + picture_width});
    window.x = {x.ticks().front(), x.ticks().back()};
    const double tall = picture_width * (window.y.high - window.y.low) / (window.x.high - window.x.low);
    return {x, charts::Scale({window.y.low, window.y.high}, false, {charts::top + tall, charts::top})};
}

std::string axis_below(const Plan& plan) {
    std::string text;
    const std::vector<std::string> labels = charts::tick_labels(plan.x.ticks());
    for (std::size_t k = 0; k < labels.size(); ++k)
        text += charts::text_at(plan.x(plan.x.ticks()[k]), plan.bottom() + 15.0, "middle", labels[k]);
    return text + charts::text_at(charts::left + 0.5 * picture_width, plan.bottom() + 31.0, "middle", "x, mm");
}

}  // namespace stria::report
