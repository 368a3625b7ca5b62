#include "app/study/variants/outcome.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "app/results/run_files.hpp"
#include "app/results/run_tables.hpp"
#include "coarse/results/result_files.hpp"
#include "common/io/number_table.hpp"

namespace stria::study {

namespace result_files = coarse::result_files;

namespace {

constexpr double same_load = 1e-9;  // of the range of the load: controlled loads are reached to rounding

constexpr std::array<Quantity, 5> size_list = {{{"coarse_unknowns", ""},
                                                {"interface_unknowns", ""},
                                                {"fine_unknowns", ""},
                                                {"fine_points", ""},
                                                {"multipliers", ""}}};
constexpr std::array<Quantity, 10> phase_list = {{{"mesh", "s"},
                                                  {"setup", "s"},
                                                  {"coarse_factor", "s"},
                                                  {"fine_constitutive", "s"},
                                                  {"fine_contact", "s"},
                                                  {"fine_factor", "s"},
                                                  {"exchange", "s"},
                                                  {"coarse_solve", "s"},
                                                  {"output", "s"},
                                                  {"total", "s"}}};
constexpr std::array<Quantity, 9> work_list = {{{"newton_iterations", ""},
                                                {"step_cuts", ""},
                                                {"zone_extensions", ""},
                                                {"yield_warnings", ""},
                                                {"messages", ""},
                                                {"bytes", ""},
                                                {"messages_per_iteration", ""},
                                                {"bytes_per_iteration", ""},
                                                {"ms_per_iteration", "ms"}}};
constexpr std::array<Quantity, 9> result_list = {{{"J", "N/mm"},
                                                  {"K_I", "MPa sqrt(mm)"},
                                                  {"CTOD", "mm"},
                                                  {"CMOD", "mm"},
                                                  {"plastic_zone", "mm"},
                                                  {"contact_length", "mm"},
                                                  {"contact_edge", "mm"},
                                                  {"opening_at_max", "mm"},
                                                  {"opening_at_min", "mm"}}};

constexpr std::array<Quantity, 5> ending_list = {
    {{"a_end", "mm"}, {"N_end", "cycles"}, {"K_op_end", "MPa sqrt(mm)"}, {"U_end", ""}, {"life", "cycles"}}};

void keep(Outcome& outcome, const std::string& name, double value) {
    if (std::isfinite(value)) outcome.values[name] = value;
}

void read_summary(const std::filesystem::path& folder, Outcome& outcome) {
    const JsonObject summary = read_json(folder / result_files::summary);
    outcome.status = coarse::run_status(summary.word("status")).value_or(RunStatus::NotRun);
    const auto take = [&](const std::string& name, const std::string& path) {
        if (const auto found = summary.numbers.find(path); found != summary.numbers.end())
            keep(outcome, name, found->second);
    };
    for (const Quantity& size : sizes()) take(size.name, size.name);
    for (const Quantity& phase : phases()) take(phase.name, std::string("timing.") + phase.name);
    for (const Quantity& count : work()) take(count.name, count.name);
    const double iterations = outcome.value("newton_iterations");
    keep(outcome, "messages_per_iteration", outcome.value("messages") / iterations);
    keep(outcome, "bytes_per_iteration", outcome.value("bytes") / iterations);
    const double solving = outcome.value("exchange") + outcome.value("coarse_solve");
    keep(outcome, "ms_per_iteration", 1e3 * solving / iterations);
}

/// The first row at the largest load (`sign` 1) or the smallest (-1).
std::size_t extreme_row(const NumberTable& history, const std::vector<std::size_t>& rows, double sign) {
    const std::vector<double>& load = history["load_factor"];
    const auto [least, most] = std::ranges::minmax_element(rows, {}, [&](std::size_t row) { return sign * load[row]; });
    const double bound = sign * load[*most] - same_load * std::abs(load[*most] - load[*least]);
    return *std::ranges::find_if(rows, [&](std::size_t row) { return sign * load[row] >= bound; });
}

Profile profile_at(const NumberTable& faces, double increment) {
    const std::vector<std::size_t> rows = rows_of_crack(faces, 0, increment);
    return {.s = values_of(faces, "s", rows), .opening = values_of(faces, "opening", rows)};
}

/// The closed station with the largest s; NaN where none is closed.
double contact_edge(const NumberTable& faces, double increment) {
    double edge = missing;
    for (const std::size_t row : rows_of_crack(faces, 0, increment))
        if (faces["status"][row] > 0.0) edge = faces["s"][row];
    return edge;
}

/// Increments; NaN where the run has not come to them.
struct LastExtremes {
    double maximum = missing, minimum = missing;
};

/// With faces, in the last cycle that has any: the last at its smallest load, and at the largest that it reaches from
/// there. The whole history may have other extremes, the ramp to the first maximum too. What a cycle starts from
/// belongs to the one before, and may be an overload. Growth may end a run at the minimum, or before there is one.
LastExtremes last_extremes(const NumberTable& history, const NumberTable& faces) {
    const std::vector<double>&load = history["load_factor"], &cycle = history["cycle"];
    const std::set<double> increments(faces["increment"].begin(), faces["increment"].end());
    const auto has_faces = [&](std::size_t row) { return increments.contains(history["increment"][row]); };
    double last_cycle = missing;
    for (std::size_t row = 0; row < history.rows; ++row)
        if (has_faces(row)) last_cycle = cycle[row];
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < history.rows; ++row)
        if (cycle[row] == last_cycle) rows.push_back(row);
    if (rows.empty()) return {};
    const auto load_of = [&](std::size_t row) { return load[row]; };
    const auto lowest = std::ranges::min_element(rows, {}, load_of);
    const auto highest = std::ranges::max_element(lowest, rows.end(), {}, load_of);
    const double least = load[*lowest], most = load[*highest];
    const double rounding = same_load * std::max(std::abs(least), std::abs(most));
    const auto last_at = [&](double wanted) {
        double found = missing;
        for (const std::size_t row : rows)
            if (has_faces(row) && std::abs(load[row] - wanted) <= rounding) found = history["increment"][row];
        return found;
    };
    return {.maximum = most > least + rounding ? last_at(most) : missing, .minimum = last_at(least)};
}

void read_faces(const std::filesystem::path& folder, const NumberTable& history, Outcome& outcome) {
    const NumberTable faces = read_table(folder / result_files::faces);
    if (faces.rows == 0) return;
    const LastExtremes last = last_extremes(history, faces);
    outcome.at_maximum = profile_at(faces, last.maximum);
    outcome.at_minimum = profile_at(faces, last.minimum);
    keep(outcome, "opening_at_max", mean_opening(outcome.at_maximum));
    keep(outcome, "opening_at_min", mean_opening(outcome.at_minimum));
    keep(outcome, "contact_edge", contact_edge(faces, last.minimum));
}

void read_endings(const std::filesystem::path& folder, Outcome& outcome) {
    keep(outcome, "life", read_json(folder / result_files::summary).number("life"));
    const NumberTable cycles = read_table(folder / result_files::cycles);
    if (cycles.rows == 0) return;
    const std::size_t last = rows_of_tip(cycles, 0).back();
    for (const char* name : {"a", "N", "K_op", "U"})
        if (cycles.columns.contains(name)) keep(outcome, std::string(name) + "_end", cycles[name][last]);
}

void read_results(const std::filesystem::path& folder, Outcome& outcome) {
    const NumberTable history = read_table(folder / result_files::history);
    if (history.rows == 0) return;
    const std::vector<std::size_t> rows = rows_of_tip(history, 0);
    const std::size_t maximum = extreme_row(history, rows, 1.0), minimum = extreme_row(history, rows, -1.0);
    for (const char* name : {"J", "K_I", "CTOD", "CMOD", "plastic_zone"}) keep(outcome, name, history[name][maximum]);
    keep(outcome, "contact_length", history["contact_length"][minimum]);
    read_faces(folder, history, outcome);
}

}  // namespace

std::span<const Quantity> sizes() { return size_list; }
std::span<const Quantity> phases() { return phase_list; }
std::span<const Quantity> work() { return work_list; }
std::span<const Quantity> results() { return result_list; }
std::span<const Quantity> endings() { return ending_list; }

double Outcome::value(const std::string& name) const {
    const auto found = values.find(name);
    return found != values.end() ? found->second : missing;
}

Outcome read_outcome(const std::filesystem::path& folder) {
    Outcome outcome;
    read_summary(folder, outcome);
    if (outcome.status != RunStatus::Done) return outcome;
    read_results(folder, outcome);
    read_endings(folder, outcome);
    return outcome;
}

double relative_error(double value, double reference) {
    if (value == reference) return 0.0;
    return reference != 0.0 ? std::abs(value - reference) / std::abs(reference) : missing;
}

std::map<std::string, double> errors(const Outcome& outcome, const Outcome& reference) {
    std::map<std::string, double> all;
    for (const auto& group : {results(), endings()})
        for (const Quantity& result : group)
            all[result.name] = relative_error(outcome.value(result.name), reference.value(result.name));
    if (!reference.at_maximum.s.empty())
        all["opening_at_max"] = relative_error(outcome.at_maximum, reference.at_maximum);
    if (!reference.at_minimum.s.empty())
        all["opening_at_min"] = relative_error(outcome.at_minimum, reference.at_minimum);
    std::erase_if(all, [](const auto& error) { return !std::isfinite(error.second); });
    return all;
}

}  // namespace stria::study
