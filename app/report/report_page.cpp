#include "app/report/report_page.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "app/charts/drawing.hpp"
#include "app/charts/page.hpp"
#include "app/report/cycle_figures.hpp"
#include "app/report/faces_figure.hpp"
#include "app/report/fields/body_picture.hpp"
#include "app/report/fields/field_picture.hpp"
#include "app/report/history_figures.hpp"
#include "common/case/case_questions.hpp"

namespace stria::report {

namespace {

using charts::escaped;

constexpr std::size_t most_case_text = 200000;  // bytes: a spectrum in the case may be long

double last_of(const NumberTable& table, const std::string& column) {
    const std::vector<std::size_t> rows = table.rows > 0 ? rows_of_tip(table, 0) : std::vector<std::size_t>();
    return rows.empty() ? NAN : values_of(table, column, rows).back();
}

std::string sentence_on_status(const RunRecord& run) {
    const std::optional<coarse::RunStatus> status = run.status();
    if (status == coarse::RunStatus::Done) return "";
    const double increment = last_of(run.history, "increment");
    const std::string until =
        std::isnan(increment) ? "no increment yet" : fmt::format("results up to increment {}", increment);
    if (status == coarse::RunStatus::Failed) return "The run has failed: " + until + ".";
    if (status == coarse::RunStatus::Interrupted) return "The run was interrupted: " + until + ".";
    return "The run has not ended, or was cut off: " + until + ".";
}

/// "n increments ..." where the summary counts any.
std::string sentence_on_count(const RunRecord& run, const char* name, const std::string& rest) {
    const double count = run.summary.number(name);
    return count > 0.0 ? fmt::format("{} {}", count, rest) : "";
}

std::string sentence_on_opening_loads(const RunRecord& run) {
    if (!run.cycles.columns.contains("K_op") ||
        (run.input && !run.input->cracks.empty() && !some_touch(run.input->cracks)))
        return "";
    const auto lost = std::ranges::count_if(run.cycles["K_op"], [](double K) { return std::isnan(K); });
    return lost > 0
               ? fmt::format("{} rows of cycles.csv have no K_op: closed all cycle, or no trial equilibrium tells it.",
                             lost)
               : "";
}

std::string list_of_warnings(const RunRecord& run) {
    const std::vector<std::string> warnings = warnings_of(run);
    if (warnings.empty()) return "<p>No warnings.</p>\n";
    std::string items;
    for (const std::string& warning : warnings) items += fmt::format("<li>{}</li>\n", escaped(warning));
    return "<div class=\"alarm\" role=\"note\"><b>Warnings</b>\n<ul>\n" + items + "</ul></div>\n";
}

std::string fact(const std::string& name, double value, const std::string& unit) {
    return std::isfinite(value) ? fmt::format("<li>{}<b>{:.6g}{}</b></li>\n", name, value, unit) : "";
}

std::string facts(const RunRecord& run) {
    const double K_max = last_of(run.cycles, "K_max");
    std::string text = "<ul class=\"facts\">\n";
    text += fmt::format("<li>status<b>{}</b></li>\n", run.status() ? to_text(*run.status()) : "not ended");
    text += fact("N", last_of(run.cycles, "N"), " cycles");
    text += fact("life", run.summary.number("life"), " cycles");
    text += fact("a", last_of(run.cycles.rows > 0 ? run.cycles : run.history, "a"), " mm");
    text += fact("K_max", K_max, " MPa sqrt(mm)");
    text += fact("K_op / K_max", last_of(run.cycles, "K_op") / K_max, "");
    text += fact("U", last_of(run.cycles, "U"), "");
    text += fact("time", run.summary.number("timing.total"), " s");
    return text + "</ul>\n";
}

std::string origin(const RunRecord& run) {
    std::string text = std::filesystem::weakly_canonical(run.folder).filename().string();
    if (const std::string version = run.summary.word("version"); !version.empty())
        text += fmt::format(", {}, mode {}", version, run.summary.word("mode"));
    return "<p>" + escaped(text) + ". The last values are those of the first tip; units are N, mm, MPa.</p>\n";
}

std::string resolved_case(const RunRecord& run) {
    std::string text = run.resolved.substr(0, most_case_text);
    if (text.size() < run.resolved.size()) text += "\n... the rest is in case.resolved.toml\n";
    return text.empty() ? "" : "<h2>The case, resolved</h2>\n<pre>" + escaped(text) + "</pre>\n";
}

}  // namespace

std::vector<std::string> warnings_of(const RunRecord& run) {
    std::vector<std::string> all = {sentence_on_status(run)};
    const std::vector<std::string> met = run.summary.list("warnings");
    all.insert(all.end(), met.begin(), met.end());
    all.push_back(sentence_on_count(run, "yield_warnings", "increments with yield outside the zone."));
    all.push_back(sentence_on_count(run, "flowing_rings",
                                    "increments in which a tip had no ring outside what has flowed: K_I, K_II and T "
                                    "there are no elastic quantities."));
    all.push_back(sentence_on_count(run, "overlapping_faces",
                                    "increments in which faces without contact overlap, and metal flows by it."));
    all.push_back(sentence_on_opening_loads(run));
    std::erase(all, "");
    return all;
}

std::string page_of(const RunRecord& run) {
    std::string body = origin(run) + list_of_warnings(run) + facts(run);
    body += section(body_picture(run)) + section(faces_figure(run)) + section(field_picture(run));
    for (charts::Figure& figure : cycle_figures(run)) body += section(std::move(figure));
    for (charts::Figure& figure : history_figures(run)) body += section(std::move(figure));
    return charts::page(run.title(), body + resolved_case(run));
}

}  // namespace stria::report
