#include "app/report/record/face_states.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "coarse/results/result_files.hpp"

namespace stria::report {

namespace {

constexpr std::size_t fewest_cycles = 3;  // rather fewer increments of each than fewer cycles

/// `count` places evenly over 0 ... size - 1, the last one among them.
std::vector<std::size_t> evenly(std::size_t size, std::size_t count) {
    std::vector<std::size_t> places(std::min(size, count));
    for (std::size_t k = 0; k < places.size(); ++k) places[k] = (k + 1) * size / places.size() - 1;
    return places;
}

FaceState state_of(const NumberTable& faces, const std::vector<std::size_t>& rows, std::size_t most_stations) {
    std::vector<std::size_t> kept;
    for (const std::size_t place : evenly(rows.size(), most_stations)) kept.push_back(rows[place]);
    return {.increment = faces["increment"][rows.front()],
            .s = values_of(faces, "s", kept),
            .opening = values_of(faces, "opening", kept),
            .slip = values_of(faces, "slip", kept),
            .pressure = values_of(faces, "pressure", kept),
            .shear = values_of(faces, "shear", kept)};
}

}  // namespace

std::vector<double> written_increments(const RunRecord& run) {
    std::vector<double> written;
    static_cast<void>(read_table(run.folder / coarse::result_files::faces, [&](double increment) {
        if (written.empty() || written.back() != increment) written.push_back(increment);
        return false;  // no row is kept
    }));
    return written;
}

std::vector<double> chosen_increments(const RunRecord& run, const std::vector<double>& written, std::size_t most) {
    std::map<double, double> cycle_of;
    for (std::size_t row = 0; row < run.history.rows; ++row)
        cycle_of[run.history["increment"][row]] = run.history["cycle"][row];
    std::vector<std::vector<double>> cycles;
    double last_cycle = NAN;
    for (const double increment : written) {
        const auto found = cycle_of.find(increment);
        if (found == cycle_of.end()) continue;
        if (found->second != last_cycle) cycles.emplace_back();
        last_cycle = found->second;
        cycles.back().push_back(increment);
    }
    std::size_t longest = 1;
    for (const std::vector<double>& cycle : cycles) longest = std::max(longest, cycle.size());
    std::vector<double> chosen;
    const std::size_t count = std::min(cycles.size(), std::max(fewest_cycles, most / longest));
    for (const std::size_t cycle : evenly(cycles.size(), count))
        for (const std::size_t place : evenly(cycles[cycle].size(), most / count))
            chosen.push_back(cycles[cycle][place]);
    return chosen;
}

std::vector<FaceState> face_states(const RunRecord& run, int crack, const std::vector<double>& increments,
                                   std::size_t most_stations) {
    const NumberTable faces = read_table(run.folder / coarse::result_files::faces, [&](double increment) {
        return std::ranges::find(increments, increment) != increments.end();
    });
    std::vector<FaceState> states;
    for (const double increment : increments) {
        const std::vector<std::size_t> rows = rows_of_crack(faces, crack, increment);
        if (!rows.empty()) states.push_back(state_of(faces, rows, most_stations));
    }
    return states;
}

}  // namespace stria::report
