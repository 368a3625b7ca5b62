// Writes what a run leaves behind, increment by increment: history.csv, cycles.csv, faces.csv, fields and summary.json.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>

#include "coarse/fatigue_analysis.hpp"
#include "coarse/results/csv.hpp"
#include "coarse/results/field_writer.hpp"
#include "coarse/results/summary.hpp"
#include "coarse/results/tables.hpp"

namespace stria::coarse {

class RunRecorder {
public:
    /// `zone_state`: asks the zone for its full state where fields are due.
    RunRecorder(const Scene& scene, std::filesystem::path directory, std::function<coupling::ZoneState()> zone_state);

    void record(const Increment& increment, const Structure& structure, const std::vector<TipResult>& nominal);

    [[nodiscard]] const std::vector<HistoryRow>& last_rows() const { return last_; }
    [[nodiscard]] const coupling::StepReport& last_zone() const { return zone_; }
    [[nodiscard]] double output_seconds() const { return output_s_; }

private:
    struct CycleSoFar {
        double K_max = -1e300, K_min = 1e300, J_max = 0.0, CTOD_max = -1e300, CTOD_min = 1e300;
        double K_op = missing, K_cl = missing, a = 0.0;
        bool touched = false;   // contact beyond the measuring distance came or went
        bool was_open = false;  // there was none at some increment
        double forward = 0.0, cyclic = 0.0, forward_axis = 0.0, cyclic_axis = 0.0;
    };
    void record_history(const Increment& increment, const Structure& structure);
    void record_cycle(const Increment& increment);
    void begin_cycle();
    void finish_cycle(const Increment& increment);
    [[nodiscard]] bool due(Written wish, const LoadStep& step) const;
    [[nodiscard]] double load(const Increment& increment) const;
    [[nodiscard]] double displacement(const Increment& increment) const;

    const Scene& scene_;
    const Scene* present_ = nullptr;  // of the increment at hand: cracks grow
    std::function<coupling::ZoneState()> zone_state_;
    std::optional<LoadedBoundary> loaded_;
    CsvWriter history_, cycles_, faces_;
    FieldWriter fields_;
    std::vector<HistoryRow> last_;
    coupling::StepReport zone_;
    std::vector<TipResult> nominal_;
    std::vector<CycleSoFar> cycle_;
    int cycle_iterations_ = 0;
    double last_target_ = 0.0, output_s_ = 0.0, cycle_start_s_ = 0.0;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace stria::coarse
