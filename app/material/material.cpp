#include "app/material/material.hpp"

#include <array>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>

#include "app/charts/chart.hpp"
#include "app/material/cyclic_test.hpp"
#include "app/process/exit_code.hpp"
#include "app/process/writable_folder.hpp"
#include "common/case/schema/case_file.hpp"
#include "common/error.hpp"
#include "common/io/csv.hpp"
#include "common/io/whole_file.hpp"

namespace stria::material {

namespace {

namespace fs = std::filesystem;

fs::path claimed_folder(const RunOptions& options, const Case& input) {
    const fs::path folder =
        options.output_directory.empty() ? "runs/" + input.name + "-material" : options.output_directory;
    if (!options.force && fs::exists(folder / "loop.csv"))
        throw CaseError(
            fmt::format("{} holds a material test; --force overwrites it, -o DIR writes elsewhere", folder.string()));
    make_writable_folder(folder);
    return folder;
}

void write_loop(const fs::path& path, const std::vector<TestRow>& rows) {
    CsvWriter table(path, {"increment", "cycle", "strain", "stress", "plastic_strain", "back_stress", "yield_stress",
                           "accumulated_plastic_strain", "work", "stored_energy", "dissipation"});
    for (const TestRow& row : rows)
        table.row(std::array<Cell, 11>{row.increment, row.cycle, row.strain, row.stress, row.plastic_strain,
                                       row.back_stress, row.yield_stress, row.accumulated, row.work, row.stored,
                                       row.dissipation});
}

void write_cycles(const fs::path& path, const std::vector<CycleSummary>& cycles) {
    CsvWriter table(path, {"cycle", "strain_max", "strain_min", "stress_max", "stress_min", "mean_stress",
                           "plastic_range", "ratchet_strain", "dissipation", "stored_energy"});
    for (const CycleSummary& c : cycles)
        table.row(std::array<Cell, 10>{c.cycle, c.strain_max, c.strain_min, c.stress_max, c.stress_min, c.mean_stress(),
                                       c.plastic_range, c.ratchet, c.dissipation, c.stored});
}

/// The first, the second, the fifth, the tenth and so on, and the last.
std::vector<int> told_cycles(int count) {
    std::vector<int> cycles;
    for (int decade = 1; decade < count; decade *= 10)
        for (const int step : {1, 2, 5})
            if (step * decade < count) cycles.push_back(step * decade);
    cycles.push_back(count);
    return cycles;
}

/// At most so many loops stand in one chart: the last ones of those that are told, and the first.
constexpr std::size_t most_loops = 6;

std::string loop_chart(const Case& input, const std::vector<TestRow>& rows, int cycles) {
    const bool shear = input.material_test->mode == TestMode::Shear;
    charts::LineChart chart{.title = fmt::format("{}: {}, MPa", input.name, shear ? "tau" : "stress"),
                            .x_label = shear ? "gamma" : "strain"};
    std::vector<int> shown = told_cycles(cycles);
    while (shown.size() > most_loops) shown.erase(shown.begin() + 1);
    for (const int cycle : shown) {
        charts::Curve curve{.name = cycle == 1 ? "to the end of cycle 1" : fmt::format("cycle {}", cycle),
                            .markers = false};
        for (std::size_t k = 0; k < rows.size(); ++k) {
            const bool begins = k + 1 < rows.size() && rows[k].ends_cycle && rows[k + 1].cycle == cycle;
            if (!begins && rows[k].cycle != cycle && (cycle > 1 || rows[k].cycle > 1)) continue;
            curve.x.push_back(rows[k].strain);
            curve.y.push_back(rows[k].stress);
        }
        chart.curves.push_back(std::move(curve));
    }
    return charts::svg(chart);
}

/// Less than rounding leaves is nothing.
double told(double value, double scale) { return std::abs(value) < 1e-10 * scale ? 0.0 : value; }

void print_cycles(const std::vector<CycleSummary>& cycles) {
    fmt::print("{:>7} {:>12} {:>12} {:>10} {:>10} {:>10} {:>12} {:>12} {:>12} {:>12}\n", "cycle", "strain max",
               "strain min", "stress max", "stress min", "mean", "plastic rng", "ratchet", "dissipated", "stored");
    for (const int cycle : told_cycles(static_cast<int>(cycles.size()))) {
        const CycleSummary& c = cycles[static_cast<std::size_t>(cycle - 1)];
        fmt::print("{:7} {:12.6g} {:12.6g} {:10.3f} {:10.3f} {:10.3f} {:12.6g} {:12.4g} {:12.6g} {:12.4g}\n", c.cycle,
                   c.strain_max, c.strain_min, c.stress_max, c.stress_min, told(c.mean_stress(), c.stress_range()),
                   c.plastic_range, told(c.ratchet, c.plastic_range), c.dissipation, told(c.stored, c.dissipation));
    }
}

/// The last cycle, how far it still differs from the one before, and from that of increments half as large.
void print_last(const std::vector<CycleSummary>& cycles, const CycleSummary& of_halved_increments) {
    const CycleSummary& last = cycles.back();
    fmt::print("stress range {:.6g} MPa, plastic range {:.6g}, ratchet {:.4g} per cycle, mean stress {:.6g} MPa\n",
               last.stress_range(), last.plastic_range, told(last.ratchet, last.plastic_range),
               told(last.mean_stress(), last.stress_range()));
    fmt::print("dissipated {:.6g} N/mm2 per cycle, stored {:.4g}\n", last.dissipation,
               told(last.stored, last.dissipation));
    const auto print_change = [&](const char* what, const CycleSummary& now, const CycleSummary& then) {
        const auto percent = [](double a, double b) {
            return std::abs(a - b) < 1e-10 * std::abs(b) || b == 0.0 ? 0.0 : 100.0 * (a / b - 1.0);
        };
        fmt::print("{}: stress range {:+.2g} %, plastic range {:+.2g} %, ratchet {:+.2g} %, dissipated {:+.2g} %\n",
                   what, percent(now.stress_range(), then.stress_range()),
                   percent(now.plastic_range, then.plastic_range),
                   percent(told(now.ratchet, now.plastic_range), told(then.ratchet, then.plastic_range)),
                   percent(now.dissipation, then.dissipation));
    };
    if (cycles.size() > 1) print_change("since the cycle before", last, cycles[cycles.size() - 2]);
    print_change("with increments half as large", of_halved_increments, last);
}

CycleSummary last_of_halved_increments(Case input) {
    input.material_test->steps *= 2;
    return summaries(go_through_cycles(input)).back();
}

}  // namespace

int test_material(const RunOptions& options) {
    const Case input = read_case(options.case_path, options.overrides);
    const std::vector<TestRow> rows = go_through_cycles(input);
    const std::vector<CycleSummary> cycles = summaries(rows);
    const fs::path folder = claimed_folder(options, input);
    write_loop(folder / "loop.csv", rows);
    write_cycles(folder / "cycles.csv", cycles);
    write_whole_text(folder / "loop.svg", loop_chart(input, rows, static_cast<int>(cycles.size())));
    if (options.quiet) return Done;
    print_cycles(cycles);
    print_last(cycles, last_of_halved_increments(input));
    fmt::print("{}: loop.csv, cycles.csv, loop.svg\n", folder.string());
    return Done;
}

}  // namespace stria::material
