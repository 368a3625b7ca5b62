#include "app/study/page.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/charts/drawing.hpp"
#include "app/charts/page.hpp"
#include "app/study/convergence/convergence_table.hpp"
#include "app/study/figures.hpp"

namespace stria::study {

namespace {

using charts::escaped;

struct Column {
    std::string head;
    std::string unit;
    std::string quantity;
    double factor = 1.0;
};

std::vector<Column> shown_columns(const Report& report) {
    std::vector<Column> all = {{"time", "s", "total"},
                               {"iterations", "", "newton_iterations"},
                               {"iteration", "ms", "ms_per_iteration"},
                               {"points", "", "fine_points"},
                               {"structure", "unknowns", "coarse_unknowns"},
                               {"interface", "unknowns", "interface_unknowns"},
                               {"zone", "unknowns", "fine_unknowns"},
                               {"traffic", "MB", "bytes", 1e-6}};
    for (const auto& group : {endings(), results()})
        for (const Quantity& result : group) all.push_back({result.name, result.unit, result.name});
    std::erase_if(all, [&](const Column& column) {
        return std::ranges::none_of(report.rows,
                                    [&](const Row& row) { return std::isfinite(row.outcome.value(column.quantity)); });
    });
    return all;
}

std::vector<Quantity> shown_errors(const Report& report) {
    std::vector<Quantity> shown;
    for (const auto& group : {endings(), results()})
        for (const Quantity& result : group)
            if (std::ranges::any_of(report.rows, [&](const Row& row) { return row.errors.contains(result.name); }))
                shown.push_back(result);
    return shown;
}

std::string number(double value) { return std::isfinite(value) ? fmt::format("{:.6g}", value) : ""; }

std::string percent(double error) {
    if (!std::isfinite(error)) return "";
    return error > 0.0 && error <= rounding ? "rounding" : fmt::format("{:.3g}", 100.0 * error);
}

std::string head_of(const Report& report, const std::vector<Column>& columns, const std::vector<Quantity>& errors) {
    std::string text = "<thead><tr><th scope=\"col\" class=\"word\">run</th>";
    for (const Axis& axis : report.axes)
        text += fmt::format("<th scope=\"col\" class=\"word\">{}</th>", escaped(axis.key));
    text += "<th scope=\"col\" class=\"word\">status</th>";
    for (const Column& column : columns)
        text +=
            fmt::format("<th scope=\"col\">{}{}</th>", column.head, column.unit.empty() ? "" : "<br>" + column.unit);
    for (const Quantity& error : errors) text += fmt::format("<th scope=\"col\">error of<br>{}, %</th>", error.name);
    return text + "</tr></thead>\n";
}

std::string line_of(const Row& row, const Report& report, const std::vector<Column>& columns,
                    const std::vector<Quantity>& errors) {
    std::string text = row.outcome.exit_code == 0 ? "<tr>" : "<tr class=\"bad\">";
    text +=
        fmt::format("<td class=\"word\">{}</td>", row.number > 0 ? std::to_string(row.number) : escaped(row.folder));
    for (const Axis& axis : report.axes) {
        const auto setting = std::ranges::find(row.settings, axis.key, &Setting::key);
        text += fmt::format("<td class=\"word\">{}</td>", setting != row.settings.end() ? escaped(setting->value) : "");
    }
    text += fmt::format("<td class=\"word\">{}</td>", to_text(row.outcome.status));
    for (const Column& column : columns)
        text += fmt::format("<td>{}</td>", number(column.factor * row.outcome.value(column.quantity)));
    for (const Quantity& error : errors) text += fmt::format("<td>{}</td>", percent(row.error(error.name)));
    return text + "</tr>\n";
}

std::string table_of(const Report& report) {
    const std::vector<Column> columns = shown_columns(report);
    const std::vector<Quantity> errors = shown_errors(report);
    std::string text = "<div class=\"wide\"><table>\n<caption>All columns are in study.csv.</caption>\n";
    text += head_of(report, columns, errors) + "<tbody>\n";
    for (const auto* rows : {&report.rows, &report.references})
        for (const Row& row : *rows) text += line_of(row, report, columns, errors);
    return text + "</tbody></table></div>\n";
}

std::string complaints(const Report& report) {
    std::string items;
    for (const auto* rows : {&report.rows, &report.references})
        for (const Row& row : *rows)
            if (!row.outcome.message.empty())
                items += fmt::format("<li>{}: {}</li>\n", escaped(row.folder), escaped(row.outcome.message));
    return items.empty() ? "" : "<p>What is not done, and why:</p>\n<ul>\n" + items + "</ul>\n";
}

std::string introduction(const Report& report) {
    const auto is_done = [](const Row& row) { return row.outcome.status == RunStatus::Done; };
    const auto running = [](const Row& row) { return row.outcome.status == RunStatus::Running; };
    const auto done = std::ranges::count_if(report.rows, is_done);
    std::string text =
        fmt::format("<p>{} of {} variants of {} done.", done, report.rows.size(), escaped(report.case_path));
    if (std::ranges::any_of(report.rows, running) || std::ranges::any_of(report.references, running))
        text += " The study goes on: load this page again for more.";
    for (const Axis& axis : report.axes)
        text += escaped(fmt::format(" {} = {}.", axis.key, fmt::join(axis.values, ", ")));
    if (!report.fixed.empty()) text += escaped(fmt::format(" In all: {}.", fmt::join(report.fixed, ", ")));
    if (!report.reference.empty()) text += escaped(fmt::format(" Reference: {}.", report.reference));
    return text + fmt::format(" {}.</p>\n", escaped(report.version));
}

}  // namespace

std::string page(const Report& report) {
    std::string body = introduction(report) + complaints(report);
    for (charts::Figure& figure : figures(report)) body += section(std::move(figure));
    body += convergence_section(convergence_rows(report));
    return charts::page(report.title, body + "<h2>Variants</h2>\n" + table_of(report));
}

}  // namespace stria::study
