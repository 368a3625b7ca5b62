#include "app/report/cycle_figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "coarse/load/growth_schedule.hpp"
#include "common/case/case_questions.hpp"

namespace stria::report {

namespace {

using charts::Curve;
using charts::Figure;
using charts::LineChart;
using charts::Sheet;

constexpr const char* K_unit = "MPa sqrt(mm)";

/// The columns of cycles.csv for one tip, under their own names.
Sheet columns_of(const RunRecord& run, std::size_t tip, const std::string& name,
                 const std::vector<std::string>& columns) {
    return charts::sheet_of(run.cycles, fmt::format("{}-tip-{}", name, tip), rows_of_tip(run.cycles, tip), columns);
}

std::string name_of_tip(const RunRecord& run, std::size_t tip, const std::string& what) {
    return run.tips() == 1 ? what : fmt::format("{}{}tip {}", what, what.empty() ? "" : ", ", tip);
}

/// One quantity over another, a curve per tip; the tables under it.
std::string chart_of_tips(const RunRecord& run, const std::string& file, const std::vector<std::string>& columns,
                          LineChart chart) {
    std::string links;
    for (std::size_t tip = 0; tip < run.tips(); ++tip) {
        const Sheet sheet = columns_of(run, tip, file, columns);
        chart.curves.push_back(curve_of(sheet, columns[0], columns[1], name_of_tip(run, tip, columns[1])));
        links += csv_link(sheet);
    }
    return charts::captioned(svg(chart), links);
}

bool grows(const Sheet& rates) {
    return std::ranges::any_of(rates["dadN"], [](double rate) { return rate > 0.0; });
}

/// What most charts stand over: the length, or the cycle where no tip grows.
std::string abscissa(const RunRecord& run) { return grows(growth_rates(run, 0)) ? "a" : "cycle"; }

std::string label_of(const std::string& abscissa) { return abscissa == "a" ? "a, mm" : abscissa; }

/// The rows of a tip at which it has come to another place.
std::vector<std::size_t> steps_of_tip(const RunRecord& run, std::size_t tip) {
    const std::vector<double>&x = run.history["x"], &y = run.history["y"];
    std::vector<std::size_t> steps;
    for (const std::size_t row : rows_of_tip(run.history, tip))
        if (steps.empty() || x[row] != x[steps.back()] || y[row] != y[steps.back()]) steps.push_back(row);
    return steps;
}

/// The places of the tips, where a way bends.
std::string ways(const RunRecord& run) {
    LineChart chart{.title = "Way of the tip: y over x, mm", .x_label = "x, mm"};
    std::string links;
    bool bends = false;
    if (!run.history.columns.contains("x")) return "";
    for (std::size_t tip = 0; tip < run.tips(); ++tip) {
        Sheet sheet{.name = fmt::format("way-tip-{}", tip)};
        const std::vector<std::size_t> rows = steps_of_tip(run, tip);
        for (const char* column : {"x", "y", "a"})
            sheet.columns.push_back({column, values_of(run.history, column, rows)});
        if (rows.empty()) continue;
        const auto [low, high] = std::ranges::minmax(sheet["y"]);
        bends = bends || high - low > 1e-3 * sheet["a"].back();
        chart.curves.push_back(curve_of(sheet, "x", "y", name_of_tip(run, tip, "y")));
        chart.curves.back().markers = false;
        links += csv_link(sheet);
    }
    return bends ? charts::captioned(svg(chart), links) : "";
}

Figure growth(const RunRecord& run) {
    return {.title = "Growth",
            .charts = {chart_of_tips(run, "a-N", {"N", "a", "da", "dN"},
                                     {.title = "Crack length a, mm", .x_label = "N, cycles"}),
                       ways(run)}};
}

Figure rates(const RunRecord& run) {
    Figure figure{.title = "Growth rate",
                  .sentence = "Secants between one row of cycles.csv and the next, at the means of their ranges; dK "
                              "is that of ASTM E647, without what lies in compression."};
    for (std::size_t tip = 0; tip < run.tips(); ++tip) {
        const Sheet sheet = growth_rates(run, tip);
        if (!grows(sheet)) continue;
        LineChart chart{
            .title = name_of_tip(run, tip, "da/dN, mm per cycle"),
            .x_label = fmt::format("dK and dK_eff, {}", K_unit),
            .log_x = true,
            .log_y = true,
            .curves = {curve_of(sheet, "dK", "dadN", "over dK"), curve_of(sheet, "dK_eff", "dadN", "over dK_eff")}};
        for (Curve& curve : chart.curves) curve.line = false;
        figure.charts.push_back(charts::captioned(svg(chart), csv_link(sheet)));
    }
    return figure;
}

/// Opening loads over K_max, by each definition that was measured.
std::string opening_loads(const RunRecord& run, std::size_t tip) {
    const std::string x = abscissa(run);
    Sheet sheet = columns_of(run, tip, "opening-loads",
                             {x, "N", "K_max", "K_min", "K_op", "K_cl", "K_op_contact", "K_op_offset", "K_op_tension"});
    LineChart chart{.title = name_of_tip(run, tip, "K_op / K_max"), .x_label = label_of(x), .from_zero = true};
    for (const char* definition : {"contact", "offset", "tension"}) {
        Curve curve = curve_of(sheet, x, std::string("K_op_") + definition, definition);
        for (std::size_t k = 0; k < curve.y.size(); ++k) curve.y[k] /= sheet["K_max"][k];
        if (std::ranges::any_of(curve.y, [](double y) { return std::isfinite(y); })) chart.curves.push_back(curve);
    }
    if (chart.curves.size() == 1) chart.title += ", definition " + chart.curves.front().name;
    return charts::captioned(svg(chart), csv_link(sheet));
}

Figure closure(const RunRecord& run) {
    Figure figure{.title = "Opening loads",
                  .sentence = "An opening load equal to K_min belongs to a crack that never closes. The definitions "
                              "are those of docs/notation.md."};
    for (std::size_t tip = 0; tip < run.tips(); ++tip) figure.charts.push_back(opening_loads(run, tip));
    const std::string x = abscissa(run);
    figure.charts.push_back(chart_of_tips(run, "U", {x, "U", "dK_eff"},
                                          {.title = "U = dK_eff / dK", .x_label = label_of(x), .from_zero = true}));
    return figure;
}

Figure zones(const RunRecord& run) {
    Figure figure{.title = "Plastic zones",
                  .sentence = "The largest distance from the tip to a point that flows, in loading and in unloading."};
    const std::string x = abscissa(run);
    for (std::size_t tip = 0; tip < run.tips(); ++tip) {
        const Sheet sheet =
            columns_of(run, tip, "zones", {x, "forward_zone", "cyclic_zone", "forward_zone_axis", "cyclic_zone_axis"});
        if (std::ranges::none_of(sheet["forward_zone"], [](double zone) { return zone > 0.0; })) continue;
        LineChart chart{.title = name_of_tip(run, tip, "Extent of the plastic zone, mm"),
                        .x_label = label_of(x),
                        .from_zero = true};
        for (const char* column : {"forward_zone", "cyclic_zone", "forward_zone_axis", "cyclic_zone_axis"})
            chart.curves.push_back(curve_of(sheet, x, column));
        figure.charts.push_back(charts::captioned(svg(chart), csv_link(sheet)));
    }
    return figure;
}

/// What each load alone does to a tip at its factor 1; K_II only where it is one in a hundred of the largest K_I or
/// more.
std::string stress_intensities_of_loads(const RunRecord& run, std::size_t tip) {
    const std::string x = abscissa(run);
    Sheet sheet{.name = fmt::format("load-cases-tip-{}", tip)};
    const std::vector<std::size_t> rows = rows_of_tip(run.load_cases, tip);
    std::vector<std::string> names{x};
    for (const LoadCaseSection& load_case : run.input->load_cases)
        for (const char* mode : {"K_I_", "K_II_"}) names.push_back(mode + load_case.name);
    names.insert(names.begin() + 1, {"K_I", "K_II"});
    double largest = 0.0;
    const auto size_of = [&](const std::string& name) {
        double size = 0.0;
        for (const double K : sheet[name]) size = std::fmax(size, std::abs(K));
        return size;
    };
    for (const std::string& name : names) {
        sheet.columns.push_back({name, values_of(run.load_cases, name, rows)});
        if (name.starts_with("K_I") && !name.starts_with("K_II")) largest = std::max(largest, size_of(name));
    }
    LineChart chart{.title = name_of_tip(run, tip, fmt::format("K of each load alone at its factor 1, {}", K_unit)),
                    .x_label = label_of(x)};
    for (const std::string& name : names)
        if (name != x && (!name.starts_with("K_II") || size_of(name) > 0.01 * largest))
            chart.curves.push_back(curve_of(sheet, x, name));
    return charts::captioned(svg(chart), csv_link(sheet));
}

Figure load_cases(const RunRecord& run) {
    Figure figure{.title = "Load cases",
                  .sentence = "Nominal, of the elastic body with open cracks: times the factors, the sum of these is "
                              "the nominal K. Without a name: of [load]."};
    for (std::size_t tip = 0; tip < run.tips(); ++tip) figure.charts.push_back(stress_intensities_of_loads(run, tip));
    return figure;
}

}  // namespace

Sheet growth_rates(const RunRecord& run, std::size_t tip) {
    const Sheet cycles = columns_of(run, tip, "", {"a", "da", "dN", "K_max", "K_min", "dK_eff"});
    const auto range = [&](std::size_t k) {
        return std::max(cycles["K_max"][k], 0.0) - std::max(cycles["K_min"][k], 0.0);
    };
    Sheet rates{.name = fmt::format("dadN-tip-{}", tip)};
    rates.columns = {{"a", {}}, {"dadN", {}}, {"dK", {}}, {"dK_eff", {}}};
    // Growth may be counted some rows behind it; the first place is the last one in front of it. Of two tips of a crack
    // each grows by its own, and `a` by the mean.
    std::size_t first = 0;
    double grown = 0.0;
    for (std::size_t k = 1; k < cycles["a"].size(); ++k) {
        grown += cycles["da"][k];
        if (cycles["dN"][k] > 0.0) {
            const auto mean = [&](const char* column) { return 0.5 * (cycles[column][first] + cycles[column][k]); };
            const double rate = grown / cycles["dN"][k];
            const std::array row = {mean("a"), rate, 0.5 * (range(first) + range(k)), mean("dK_eff")};
            for (std::size_t c = 0; c < row.size(); ++c) rates.columns[c].values.push_back(row[c]);
        }
        if (cycles["dN"][k] > 0.0 || grown == 0.0) {
            first = k;
            grown = 0.0;
        }
    }
    return rates;
}

std::vector<Figure> cycle_figures(const RunRecord& run) {
    if (run.cycles.rows == 0) return {};
    std::vector<Figure> figures;
    if (grows(growth_rates(run, 0))) figures.push_back(growth(run));
    // Where it is prescribed the rate is given, not found. A mean rate is that of many ranges.
    const bool given = run.input && run.input->growth && is_prescribed(*run.input->growth);
    if (!given && !(run.input && coarse::takes_mean_rate(*run.input))) figures.push_back(rates(run));
    if (!run.input || some_touch(run.input->cracks)) figures.push_back(closure(run));
    figures.push_back(zones(run));
    if (run.input && run.load_cases.rows > 0) figures.push_back(load_cases(run));
    return figures;
}

}  // namespace stria::report
