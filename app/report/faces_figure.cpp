#include "app/report/faces_figure.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "app/charts/chart.hpp"
#include "app/charts/sheet.hpp"
#include "app/report/record/face_states.hpp"

namespace stria::report {

namespace {

using charts::Curve;
using charts::Frame;
using charts::LineChart;

constexpr std::size_t most_frames = 30, most_stations = 120, most_cracks = 4;
constexpr double micrometres = 1e3;
constexpr double seen = 1e-6;     // of the largest opening: less of slip is rounding
constexpr double touched = 1e-3;  // of the largest pressure: less has hardly touched
constexpr double closed = 1e-6;   // mm: an opening below it is rounding
constexpr double near_tip = 0.15, as_wide = 0.5;

using States = std::vector<FaceState>;

double largest(const States& states, std::vector<double> FaceState::*values) {
    double most = 0.0;
    for (const FaceState& state : states)
        for (const double value : state.*values) most = std::fmax(most, std::abs(value));
    return most;
}

/// Both faces as one outline: half of the opening to either side.
Curve gap(const FaceState& state, double from) {
    Curve outline{.name = "gap between the faces", .markers = false, .filled = true};
    for (std::size_t k = 0; k < state.s.size(); ++k) {
        if (state.s[k] < from) continue;
        outline.x.push_back(state.s[k]);
        outline.y.push_back(0.5 * micrometres * state.opening[k]);
    }
    for (std::size_t k = outline.x.size(); k-- > 0;) {
        outline.x.push_back(outline.x[k]);
        outline.y.push_back(-outline.y[k]);
    }
    return outline;
}

/// The faces where they touch, on their line.
Curve touching(const FaceState& state, double from) {
    Curve shut{.name = "faces under pressure", .markers = false};
    for (std::size_t k = 0; k < state.s.size(); ++k) {
        if (state.s[k] < from) continue;
        shut.x.push_back(state.s[k]);
        shut.y.push_back(state.pressure[k] > 0.0 ? 0.0 : NAN);
    }
    return shut;
}

/// The last state in which the faces touch, else the last one.
std::size_t first_shown(const States& states) {
    const double bound = touched * largest(states, &FaceState::pressure);
    for (std::size_t k = states.size(); k-- > 0;)
        if (std::ranges::any_of(states[k].pressure, [&](double pressure) { return pressure > bound; })) return k;
    return states.size() - 1;
}

std::string chart_of(const States& states, const std::string& title, auto curves) {
    LineChart chart{.title = title, .x_label = "s along the crack, mm", .shown = first_shown(states)};
    for (const FaceState& state : states) chart.frames.push_back({.name = "", .curves = curves(state)});
    return svg(chart);
}

std::string chart_of_values(const States& states, const std::string& title, std::vector<double> FaceState::*values,
                            double factor = 1.0) {
    return chart_of(states, title, [&](const FaceState& state) {
        Curve curve{.name = "", .x = state.s, .y = state.*values, .markers = false};
        for (double& value : curve.y) value *= factor;
        return std::vector{curve};
    });
}

/// Where the last stretch before the tips begins, if that is much shorter than what is written.
double tip_window(const States& states) {
    double begin = INFINITY, end = 0.0, first_end = INFINITY;
    for (const FaceState& state : states) {
        begin = std::min(begin, state.s.front());
        end = std::max(end, state.s.back());
        first_end = std::min(first_end, state.s.back());
    }
    const double from = first_end - near_tip * (first_end - begin);
    return end - from < as_wide * (end - begin) ? from : NAN;
}

std::string name_of(const RunRecord& run, const FaceState& state) {
    const auto& increments = run.history["increment"];
    const auto found = std::ranges::find(increments, state.increment);
    if (found == increments.end()) return fmt::format("increment {}", state.increment);
    const auto row = static_cast<std::size_t>(found - increments.begin());
    const double a = run.history["a"][row];
    return fmt::format("increment {}: cycle {}, load factor {:.5g}{}", state.increment, run.history["cycle"][row],
                       run.history["load_factor"][row], std::isnan(a) ? "" : fmt::format(", a = {:.6g} mm", a));
}

charts::Sheet sheet_of_faces(const States& states, int crack) {
    charts::Sheet sheet{.name = fmt::format("faces-{}", crack)};
    sheet.columns = {{"increment", {}}, {"s", {}}, {"opening", {}}, {"slip", {}}, {"pressure", {}}, {"shear", {}}};
    for (const FaceState& state : states) {
        for (std::size_t k = 0; k < state.s.size(); ++k) {
            const std::array row = {state.increment, state.s[k],        state.opening[k],
                                    state.slip[k],   state.pressure[k], state.shear[k]};
            for (std::size_t c = 0; c < row.size(); ++c) sheet.columns[c].values.push_back(row[c]);
        }
    }
    std::erase_if(sheet.columns, [](const auto& column) {
        return (column.name == "slip" || column.name == "shear") &&
               std::ranges::all_of(column.values, [](double value) { return std::abs(value) < 1e-9; });
    });
    return sheet;
}

std::string slides_of(const RunRecord& run, const States& states, int crack) {
    const auto faces = [](double from) {
        return [from](const FaceState& state) { return std::vector{gap(state, from), touching(state, from)}; };
    };
    std::vector<std::string> charts = {
        chart_of(states, "Faces, each half the opening from the crack, micrometres", faces(-INFINITY))};
    if (const double from = tip_window(states); !std::isnan(from))
        charts.push_back(chart_of(states, "Faces behind the tip, micrometres", faces(from)));
    if (largest(states, &FaceState::pressure) > 0.0)
        charts.push_back(chart_of_values(states, "Contact pressure, MPa", &FaceState::pressure));
    if (largest(states, &FaceState::shear) > 0.0)
        charts.push_back(chart_of_values(states, "Shear on the faces, MPa", &FaceState::shear));
    if (largest(states, &FaceState::slip) > seen * largest(states, &FaceState::opening))
        charts.push_back(chart_of_values(states, "Slip, micrometres", &FaceState::slip, micrometres));
    std::vector<std::string> names;
    for (const FaceState& state : states) names.push_back(name_of(run, state));
    return charts::slides(charts, names, first_shown(states), csv_link(sheet_of_faces(states, crack)));
}

}  // namespace

charts::Figure faces_figure(const RunRecord& run) {
    const std::vector<double> written = written_increments(run);
    const std::vector<double> chosen = chosen_increments(run, written, most_frames);
    charts::Figure figure{.title = "Crack faces"};
    const std::size_t cracks = run.input ? std::min(run.input->cracks.size(), most_cracks) : 1;
    for (std::size_t crack = 0; crack < cracks; ++crack) {
        const States states = face_states(run, static_cast<int>(crack), chosen, most_stations);
        if (!states.empty()) figure.charts.push_back(slides_of(run, states, static_cast<int>(crack)));
    }
    figure.sentence = "The slider goes through the increments at which the faces were written.";
    if (chosen.size() < written.size())
        figure.sentence += fmt::format(" It shows {} of {}; all are in faces.csv.", chosen.size(), written.size());
    return figure;
}

}  // namespace stria::report
