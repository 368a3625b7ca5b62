#include "app/study/figures.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>

#include "app/charts/chart.hpp"
#include "app/charts/drawing.hpp"
#include "app/report/time_chart.hpp"

namespace stria::study {

namespace {

using charts::Curve;
using charts::Figure;
using charts::LineChart;
using charts::svg;

constexpr double wide = 8.0;            // ratio of the extremes from which an axis is logarithmic
constexpr std::size_t most_curves = 7;  // as many as there are colours

using Number = std::function<double(const Row&)>;

Number value_of(const std::string& name, double factor = 1.0) {
    return [=](const Row& row) { return factor * row.outcome.value(name); };
}

Number error_of(const std::string& name) {
    return [=](const Row& row) { return row.error(name); };
}

std::string labelled(const char* name, const char* unit) {
    return *unit != 0 ? fmt::format("{}, {}", name, unit) : name;
}

bool is_numeric(const Axis& axis) {
    return std::ranges::all_of(differing_parts(axis.values),
                               [](const std::string& value) { return number_in(value).has_value(); });
}

/// What tells a value from the others of its axis.
std::string part_of(const Axis& axis, const std::string& value) {
    const auto place = static_cast<std::size_t>(std::ranges::find(axis.values, value) - axis.values.begin());
    return place < axis.values.size() ? differing_parts(axis.values)[place] : value;
}

/// Where the row stands on an axis: its number, or the place of its word.
double place_on(const Axis& axis, const std::string& value) {
    if (is_numeric(axis)) return number_in(part_of(axis, value)).value_or(NAN);
    return static_cast<double>(std::ranges::find(axis.values, value) - axis.values.begin());
}

/// The key; with an ellipsis where the values have more in common than that.
std::string label_of(const Axis& axis) {
    const std::string& value = axis.values.front();
    const std::string part = part_of(axis, value);
    if (part == value) return axis.key;
    const std::size_t start = value.find(part);
    const std::string before = value.substr(0, start), word = before.substr(before.find_last_of("{[, ") + 1);
    return axis.key + ": " + (word.empty() ? "..." : word + "...");
}

bool spans_decades(const std::vector<Curve>& curves, std::vector<double> Curve::*coordinate) {
    double low = INFINITY, high = 0.0;
    for (const Curve& curve : curves) {
        for (const double value : curve.*coordinate) {
            if (!std::isfinite(value)) continue;
            low = std::min(low, value);
            high = std::max(high, value);
        }
    }
    return low > 0.0 && high >= wide * low;
}

/// Points in the order of the axis `along`, a curve for each combination of the other axes.
std::vector<Curve> curves_along(const Report& report, std::size_t along, const Number& x, const Number& y,
                                bool name_points = false) {
    std::vector<Curve> curves;
    for (const Row& row : report.rows) {
        const std::string name = to_text(without(row.settings, along));
        auto curve = std::ranges::find(curves, name, &Curve::name);
        if (curve == curves.end()) curve = curves.insert(curves.end(), {.name = name});
        curve->x.push_back(x(row));
        curve->y.push_back(y(row));
        if (name_points) curve->points.push_back(part_of(report.axes[along], row.settings[along].value));
    }
    return curves;
}

bool all_zero(const Report& report, const Number& y) {
    return std::ranges::all_of(report.rows, [&](const Row& row) { return y(row) == 0.0; });
}

/// One quantity along each axis that varies; nothing of what the scene does not have.
void add_along_axes(const Report& report, const std::string& label, const Number& y, bool is_size, Figure& figure) {
    if (all_zero(report, y)) return;
    for (std::size_t k = 0; k < report.axes.size(); ++k) {
        const Axis& axis = report.axes[k];
        if (axis.values.size() < 2) continue;
        const bool words = !is_numeric(axis);
        const Number x = [&](const Row& row) { return place_on(axis, row.settings[k].value); };
        std::vector<Curve> curves = curves_along(report, k, x, y);
        const bool log_x = !words && spans_decades(curves, &Curve::x);
        const bool log_y = is_size && spans_decades(curves, &Curve::y);
        figure.charts.push_back(
            svg(LineChart{.title = label,
                          .x_label = label_of(axis),
                          .words = words ? differing_parts(axis.values) : std::vector<std::string>(),
                          .log_x = log_x,
                          .log_y = log_y,
                          .from_zero = is_size,
                          .curves = std::move(curves)}));
    }
}

/// Of all variants that have one, from 0; NaN where none has.
double largest_error(const Report& report, const std::string& result) {
    double largest = NAN;
    for (const Row& row : report.rows) largest = std::fmax(largest, row.error(result));
    return largest;
}

/// Errors at the level of rounding are said to be that: a curve through them would look like a result.
Figure error_against_time(const Report& report) {
    Figure figure{.title = "Error against time",
                  .sentence = "Relative errors, each with its variant; nothing is shown of a variant that is its own "
                              "reference."};
    std::string rounded;
    for (const auto& group : {results(), endings()}) {
        for (const Quantity& result : group) {
            const double largest = largest_error(report, result.name);
            if (largest <= rounding) {
                rounded += fmt::format("{}{} ({:.1g})", rounded.empty() ? "" : ", ", result.name, largest);
                continue;
            }
            LineChart chart{.title = fmt::format("Error of {}", result.name),
                            .x_label = "total time, s",
                            .log_x = true,
                            .log_y = true,
                            .curves = curves_along(report, 0, value_of("total"), error_of(result.name), true)};
            figure.charts.push_back(svg(chart));
        }
    }
    if (!rounded.empty())
        figure.tables = charts::escaped(fmt::format("Equal to rounding, with the largest error: {}.", rounded));
    return figure;
}

Figure results_along_axes(const Report& report) {
    Figure figure{.title = "Results at the extremes of the load",
                  .sentence = "J, K, CTOD, CMOD and plastic zone at the largest load, contact at the smallest; "
                              "openings are means along the crack."};
    for (const Quantity& result : results())
        add_along_axes(report, labelled(result.name, result.unit), value_of(result.name), false, figure);
    return figure;
}

Figure endings_along_axes(const Report& report) {
    Figure figure{.title = "At the end of the run",
                  .sentence = "The first tip after the last cycle; a life where growth has ended the run."};
    for (const Quantity& ending : endings())
        add_along_axes(report, labelled(ending.name, ending.unit), value_of(ending.name), false, figure);
    return figure;
}

std::string profiles(const Report& report, Profile Outcome::*which, const std::string& title) {
    LineChart chart{.title = title, .x_label = "s along the crack, mm"};
    for (const auto* rows : {&report.references, &report.rows}) {
        for (const Row& row : *rows) {
            const Profile& profile = row.outcome.*which;
            if (profile.s.empty() || chart.curves.size() >= most_curves) continue;
            const std::string name = (row.number == 0 ? "reference " : "") + to_text(row.settings);
            chart.curves.push_back({.name = name, .x = profile.s, .y = profile.opening, .markers = false});
        }
    }
    return svg(chart);
}

Figure openings(const Report& report) {
    const std::size_t runs = report.rows.size() + report.references.size();
    return {.title = "Opening of the first crack",
            .sentence = runs > most_curves ? fmt::format("The first {} of {} runs.", most_curves, runs) : "",
            .charts = {profiles(report, &Outcome::at_maximum, "Opening at the largest load, mm"),
                       profiles(report, &Outcome::at_minimum, "Opening at the smallest load, mm")}};
}

/// What tells the row from the others, alone: beside a bar there is no room for keys.
std::string parts_of(const Report& report, const Settings& settings) {
    std::string text;
    for (std::size_t k = 0; k < settings.size(); ++k)
        text += (k == 0 ? "" : ", ") + part_of(report.axes[k], settings[k].value);
    return text;
}

std::string time_by_phase(const Report& report) {
    std::string keys;
    for (const Axis& axis : report.axes) keys += (keys.empty() ? "" : ", ") + axis.key;
    charts::BarChart chart = report::time_chart("Time by phase for " + keys);
    for (const Row& row : report.rows)
        chart.bars.push_back(report::time_bar(parts_of(report, row.settings),
                                              [&](const std::string& phase) { return row.outcome.value(phase); }));
    return svg(chart);
}

Figure time_along_axes(const Report& report) {
    Figure figure{.title = "Time",
                  .sentence =
                      "Set-up includes the mesh; points, contact and fronts are the work of the zone, wire is what the "
                      "structure waits for beyond it.",
                  .charts = {time_by_phase(report)}};
    add_along_axes(report, "Total time, s", value_of("total"), true, figure);
    add_along_axes(report, "Time of a Newton iteration, ms", value_of("ms_per_iteration"), true, figure);
    add_along_axes(report, "Newton iterations", value_of("newton_iterations"), true, figure);
    return figure;
}

Figure sizes_along_axes(const Report& report) {
    Figure figure{.title = "Sizes and traffic"};
    add_along_axes(report, "Points of the zone", value_of("fine_points"), true, figure);
    add_along_axes(report, "Unknowns of the structure", value_of("coarse_unknowns"), true, figure);
    add_along_axes(report, "Unknowns on the interface", value_of("interface_unknowns"), true, figure);
    add_along_axes(report, "Unknowns of the zone", value_of("fine_unknowns"), true, figure);
    add_along_axes(report, "Messages in a Newton iteration", value_of("messages_per_iteration"), true, figure);
    add_along_axes(report, "Megabytes in a Newton iteration", value_of("bytes_per_iteration", 1e-6), true, figure);
    return figure;
}

}  // namespace

std::vector<Figure> figures(const Report& report) {
    return {endings_along_axes(report), error_against_time(report), results_along_axes(report),
            openings(report),           time_along_axes(report),    sizes_along_axes(report)};
}

}  // namespace stria::study
