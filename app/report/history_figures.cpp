#include "app/report/history_figures.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "app/charts/sheet.hpp"
#include "app/report/time_chart.hpp"

namespace stria::report {

namespace {

using charts::Curve;
using charts::Figure;
using charts::LineChart;
using charts::Sheet;
using Rows = std::vector<std::size_t>;

constexpr std::size_t most_loops = 5, most_increments = 1500;

std::string chart_of(const Sheet& sheet, const std::vector<std::string>& curves, LineChart chart) {
    for (const std::string& column : curves) {
        chart.curves.push_back(curve_of(sheet, sheet.columns.front().name, column));
        chart.curves.back().markers = false;
    }
    return svg(chart);
}

/// Those of the columns that are not zero throughout.
std::vector<std::string> telling(const Sheet& sheet, std::vector<std::string> columns) {
    std::erase_if(columns, [&](const std::string& column) {
        return std::ranges::none_of(sheet[column], [](double value) { return std::isfinite(value) && value != 0.0; });
    });
    return columns;
}

/// Whole cycles, evenly over the run, the last one among them; each as its rows and the one that it starts from.
std::vector<Rows> loops(const RunRecord& run, const Rows& rows) {
    std::vector<Rows> cycles;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const double cycle = run.history["cycle"][rows[k]];
        if (cycle < 1.0) continue;
        if (cycles.empty() || run.history["cycle"][cycles.back().back()] != cycle) {
            cycles.emplace_back();
            if (k > 0) cycles.back().push_back(rows[k - 1]);
        }
        cycles.back().push_back(rows[k]);
    }
    std::vector<Rows> chosen;
    const std::size_t count = std::min(most_loops, cycles.size());
    for (std::size_t k = 0; k < count; ++k)
        chosen.push_back(cycles[count == 1 ? 0 : k * (cycles.size() - 1) / (count - 1)]);
    return chosen;
}

std::string loops_over(const RunRecord& run, const std::vector<Rows>& cycles, const std::string& column,
                       const std::string& title, const std::string& label) {
    LineChart chart{.title = title, .x_label = label};
    Rows all;
    for (const Rows& rows : cycles) {
        chart.curves.push_back({.name = fmt::format("cycle {}", run.history["cycle"][rows.back()]),
                                .x = values_of(run.history, column, rows),
                                .y = values_of(run.history, "load", rows),
                                .markers = false});
        all.insert(all.end(), rows.begin(), rows.end());
    }
    const Sheet sheet = charts::sheet_of(run.history, "load-" + column, all, {"increment", "cycle", "load", column});
    return charts::captioned(svg(chart), csv_link(sheet));
}

Figure hysteresis(const RunRecord& run) {
    const std::vector<Rows> cycles = loops(run, rows_of_tip(run.history, 0));
    const std::string title = "Load, N/mm";
    return {.title = "Loops of load against opening",
            .sentence = "The first tip; whole cycles, evenly over the run.",
            .charts = {loops_over(run, cycles, "CMOD", title, "CMOD, mm"),
                       loops_over(run, cycles, "opening", title, "opening at closure.distance behind the tip, mm")}};
}

/// All rows, or those that end a cycle where they are too many for a page.
Rows shown_rows(const RunRecord& run) {
    const Rows rows = rows_of_tip(run.history, 0);
    if (rows.size() <= most_increments) return rows;
    Rows ends;
    for (std::size_t k = 0; k < rows.size(); ++k)
        if (k + 1 == rows.size() || run.history["cycle"][rows[k + 1]] != run.history["cycle"][rows[k]])
            ends.push_back(rows[k]);
    return ends;
}

std::string note_on(const RunRecord& run, const Rows& shown) {
    return shown.size() < rows_of_tip(run.history, 0).size() ? " The last increment of each cycle; all are in "
                                                               "history.csv."
                                                             : "";
}

Figure fracture(const RunRecord& run, const Rows& rows) {
    const Sheet sheet =
        charts::sheet_of(run.history, "fracture", rows,
                         {"increment", "load_factor", "K_I", "K_II", "J", "contact_length", "plastic_zone"});
    const std::string x = "increment";
    return {.title = "From increment to increment",
            .sentence = "The first tip." + note_on(run, rows),
            .charts = {chart_of(sheet, {"K_I", "K_II"}, {.title = "K_I and K_II, MPa sqrt(mm)", .x_label = x}),
                       chart_of(sheet, {"J"}, {.title = "J, N/mm", .x_label = x}),
                       chart_of(sheet, telling(sheet, {"contact_length", "plastic_zone"}),
                                {.title = "Closed length and plastic zone, mm", .x_label = x})},
            .tables = csv_link(sheet)};
}

Figure work(const RunRecord& run, const Rows& rows) {
    const Sheet sheet = charts::sheet_of(run.history, "work", rows,
                                         {"increment", "external_work", "stored_energy", "dissipation",
                                          "released_energy", "frictional_dissipation", "balance_error"});
    return {
        .title = "Work balance",
        .sentence = "Per mm of thickness, total so far. The error is what the loads have done less what is "
                    "stored, dissipated and released." +
                    note_on(run, rows),
        .charts = {chart_of(sheet, telling(sheet, {"external_work", "stored_energy", "dissipation", "released_energy"}),
                            {.title = "Work, N", .x_label = "increment"}),
                   chart_of(sheet, telling(sheet, {"balance_error"}),
                            {.title = "Error of the balance, N", .x_label = "increment"})},
        .tables = csv_link(sheet)};
}

Figure convergence(const RunRecord& run, const Rows& rows) {
    Figure figure{.title = "Convergence"};
    const LineChart empty{.title = "Newton iterations", .x_label = "increment", .from_zero = true};
    if (rows.size() == rows_of_tip(run.history, 0).size()) {
        const Sheet sheet = charts::sheet_of(run.history, "iterations", rows, {"increment", "newton_iterations"});
        figure.charts.push_back(chart_of(sheet, {"newton_iterations"}, empty));
        figure.tables = csv_link(sheet);
    }
    const Sheet cycles = charts::sheet_of(run.cycles, "effort", rows_of_tip(run.cycles, 0),
                                          {"cycle", "newton_iterations", "wall_s", "fine_points", "fine_unknowns"});
    if (run.cycles.rows < 2) return figure;
    LineChart of_cycle{.title = "Newton iterations of a cycle", .x_label = "cycle", .from_zero = true};
    figure.charts.push_back(chart_of(cycles, {"newton_iterations"}, of_cycle));
    LineChart time{.title = "Time of a cycle, s", .x_label = "cycle", .from_zero = true};
    figure.charts.push_back(chart_of(cycles, {"wall_s"}, time));
    figure.tables += csv_link(cycles);
    return figure;
}

Figure timing(const RunRecord& run) {
    charts::BarChart chart = time_chart("Time by phase");
    chart.bars.push_back(
        time_bar("this run", [&](const std::string& phase) { return run.summary.number("timing." + phase); }));
    Sheet sheet{.name = "timing"};
    for (const auto& [name, value] : run.summary.numbers)
        if (name.starts_with("timing.")) sheet.columns.push_back({name.substr(7), {value}});
    return {.title = "Time", .charts = {charts::captioned(svg(chart), csv_link(sheet))}};
}

}  // namespace

std::vector<Figure> history_figures(const RunRecord& run) {
    if (run.history.rows == 0) return {};
    const Rows rows = shown_rows(run);
    return {hysteresis(run), fracture(run, rows), work(run, rows), convergence(run, rows), timing(run)};
}

}  // namespace stria::report
