#include "app/study/convergence/convergence_table.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>

#include "app/charts/drawing.hpp"

namespace stria::study {
namespace {

using charts::escaped;

/// Relative, of the elements at the tip. Nothing where the axis is about something else.
std::optional<double> element_size(const std::string& key, const std::string& value) {
    const std::optional<double> number = number_in(value);
    if (!number || *number <= 0.0) return std::nullopt;
    if (key == "mesh.size") return number;
    if (key == "fine.refine") return 1.0 / *number;
    return std::nullopt;
}

/// Values by size, for each combination of the other axes in the order of the variants.
struct Combination {
    std::string others;
    std::vector<GridValue> grids = {};
};
std::vector<Combination> along(const Report& report, std::size_t axis, const char* result) {
    std::vector<Combination> all;
    for (const Row& row : report.rows) {
        const Setting& setting = row.settings[axis];
        const std::optional<double> size = element_size(setting.key, setting.value);
        const double value = row.outcome.value(result);
        if (!size || !std::isfinite(value)) continue;
        const std::string name = to_text(without(row.settings, axis));
        auto found = std::ranges::find(all, name, &Combination::others);
        if (found == all.end()) found = all.insert(all.end(), {name});
        if (std::ranges::find(found->grids, *size, &GridValue::size) == found->grids.end())
            found->grids.push_back({*size, value});
    }
    return all;
}

/// Of a study's results in the same unit. What is less than rounding of it is nothing.
double largest_in(const Report& report, const std::string& unit) {
    double largest = 0.0;
    for (const auto& group : {endings(), results()})
        for (const Quantity& result : group)
            for (const Row& row : report.rows)
                if (const double value = std::abs(row.outcome.value(result.name));
                    result.unit == unit && value > largest)
                    largest = value;
    return largest;
}

std::string number(double value, const char* format = "{:.6g}") {
    return std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : "";
}

double in_percent(const GridConvergence& found) {
    return 100.0 * found.uncertainty / std::abs(found.finest);  // no number where that is nothing
}

std::string label(const ConvergenceRow& row) {
    return row.others.empty() ? row.result : row.result + " at " + row.others;
}

}  // namespace

std::vector<ConvergenceRow> convergence_rows(const Report& report) {
    std::vector<ConvergenceRow> rows;
    for (std::size_t axis = 0; axis < report.axes.size(); ++axis) {
        for (const auto& group : {endings(), results()}) {
            for (const Quantity& result : group) {
                for (const Combination& combination : along(report, axis, result.name)) {
                    if (combination.grids.size() < 2) continue;
                    const GridConvergence found = grid_convergence(combination.grids);
                    const double nothing = rounding * largest_in(report, result.unit);
                    if (found.approach == Approach::Same || std::abs(found.finest) <= nothing) continue;
                    rows.push_back({.result = result.name,
                                    .unit = result.unit,
                                    .along = report.axes[axis].key,
                                    .others = combination.others,
                                    .sizes = static_cast<int>(combination.grids.size()),
                                    .found = found});
                }
            }
        }
    }
    return rows;
}

std::vector<std::string> convergence_columns() {
    return {"result", "unit", "along", "others", "sizes", "approach", "finest", "order", "limit", "uncertainty"};
}

std::vector<Cell> cells(const ConvergenceRow& row) {
    const GridConvergence& found = row.found;
    return {row.result,   row.unit,    row.along,   row.others,       std::int64_t{row.sizes}, to_text(found.approach),
            found.finest, found.order, found.limit, found.uncertainty};
}

std::string convergence_section(const std::vector<ConvergenceRow>& rows) {
    if (rows.empty()) return "";
    std::string text =
        "<h2>Convergence with the size of elements</h2>\n"
        "<p>By the grid convergence index of the three smallest sizes, or of two with first order assumed. A result is "
        "within its uncertainty of the value on the smallest elements if the sizes are small enough to show how it "
        "converges. Results that are equal to rounding on the two smallest sizes are left out.</p>\n"
        "<div class=\"wide\"><table>\n<caption>All columns are in convergence.csv.</caption>\n<thead><tr>";
    for (const char* head : {"result", "along", "others"})
        text += fmt::format("<th scope=\"col\" class=\"word\">{}</th>", head);
    text += "<th scope=\"col\">sizes</th><th scope=\"col\" class=\"word\">approach</th>";
    for (const char* head : {"smallest elements", "order", "limit", "uncertainty, %"})
        text += fmt::format("<th scope=\"col\">{}</th>", head);
    text += "</tr></thead>\n<tbody>\n";
    for (const ConvergenceRow& row : rows) {
        const std::string result = row.unit.empty() ? row.result : row.result + ", " + row.unit;
        text += "<tr>";
        for (const std::string& word : {result, row.along, row.others})
            text += fmt::format("<td class=\"word\">{}</td>", escaped(word));
        text += fmt::format("<td>{}</td><td class=\"word\">{}</td>", row.sizes, to_text(row.found.approach));
        for (const std::string& cell : {number(row.found.finest), number(row.found.order, "{:.2f}"),
                                        number(row.found.limit), number(in_percent(row.found), "{:.2g}")})
            text += fmt::format("<td>{}</td>", cell);
        text += "</tr>\n";
    }
    return text + "</tbody></table></div>\n";
}

std::string sentence(const ConvergenceRow& row) {
    const GridConvergence& found = row.found;
    const std::string finest = fmt::format("{}: {:.6g}{} on the smallest elements", label(row), found.finest,
                                           row.unit.empty() ? "" : " " + row.unit);
    const double percent = in_percent(found);
    const std::string uncertain = std::isfinite(percent) ? fmt::format(", uncertain by {:.2g} %", percent) : "";
    switch (found.approach) {
    case Approach::Same:
        return finest + " and on all";
    case Approach::Away:
        return finest + "; it does not converge on these";
    case Approach::Oscillating:
        return finest + uncertain + "; it oscillates with the size";
    case Approach::Assumed:
        return finest + fmt::format(", {:.6g} in the limit by first order", found.limit) + uncertain;
    case Approach::Monotone:
        return finest + fmt::format(", {:.6g} in the limit (order {:.2f})", found.limit, found.order) + uncertain;
    }
    return finest;
}

}  // namespace stria::study
