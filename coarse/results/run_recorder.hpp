// Writes what a run leaves behind, increment by increment: history.csv, cycles.csv, faces.csv, fields and summary.json.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>

#include "coarse/cycle/closure_meter.hpp"
#include "coarse/cycle/increment.hpp"
#include "coarse/fields/field_writer.hpp"
#include "coarse/model/loads/boundary_conditions.hpp"
#include "coarse/results/tables.hpp"
#include "common/io/csv.hpp"

namespace stria::coarse {

/// All that a recorder remembers between two increments.
struct RecorderState {
    std::uint64_t history_rows = 0, cycle_rows = 0, face_rows = 0, closure_rows = 0, load_rows = 0;
    std::vector<FieldWriter::Step> fields;
    int cycle_iterations = 0;
    double cycle_s = 0.0;  // that the cycle has taken so far
    double N = 0.0;        // cycles, with all that the computed ones stand for
};

class RunRecorder {
public:
    /// `zone_state`: asks the zone for its full state where fields are due. `from`: what to go on from; rows written
    /// later are cut off. Null: tables begin anew.
    RunRecorder(const Scene& scene, std::filesystem::path directory, std::function<coupling::ZoneState()> zone_state,
                const RecorderState* from = nullptr);

    /// With what it says on the disk: a checkpoint must not know of rows that a power cut could take.
    [[nodiscard]] RecorderState state() const;

    void record(const Increment& increment, const Structure& structure, const ClosureMeter& closure);

    /// Growth has ended the run at the increment last recorded: its faces and fields are those of the end.
    void record_end(const Increment& last, const Structure& structure);

    [[nodiscard]] const std::vector<HistoryRow>& last_rows() const { return last_; }
    /// Of each tip, at the same increment: K of the initial stress alone, MPa sqrt(mm).
    [[nodiscard]] const std::vector<double>& last_K_initial() const { return last_K_initial_; }
    [[nodiscard]] const coupling::StepReport& last_zone() const { return zone_; }
    /// Cycles up to now, with all that the computed ones stand for.
    [[nodiscard]] double N() const { return N_; }
    [[nodiscard]] double output_seconds() const { return output_s_; }

private:
    void record_history(const Increment& increment, const Scene& present);
    void record_faces(const Increment& increment, const Structure& structure);
    void record_fields(const Increment& increment, const Structure& structure);
    void record_cycle(const Increment& increment, const ClosureMeter& closure, const Case& input);
    void begin_cycle();
    [[nodiscard]] double seconds() const;
    [[nodiscard]] bool due(Written wish, const Increment& increment) const;
    [[nodiscard]] bool in_last_cycle(const Increment& increment) const;
    [[nodiscard]] double load(const Increment& increment) const;

    OutputSection output_;
    int last_cycle_;  // of the load history
    std::optional<GrowthSection> growth_;
    std::function<coupling::ZoneState()> zone_state_;
    std::optional<LoadedBoundary> loaded_;
    CsvWriter history_, cycles_, faces_;
    std::optional<CsvWriter> closure_;  // where a profile of opening loads is asked for
    std::optional<CsvWriter> loads_;    // where there are load cases or pressures that travel
    std::optional<CsvWriter> load_cases_;
    FieldWriter fields_;
    std::vector<HistoryRow> last_;
    std::vector<double> last_K_initial_;
    coupling::StepReport zone_;
    int cycle_iterations_ = 0;
    double N_ = 0.0;
    double output_s_ = 0.0, cycle_start_s_ = 0.0;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace stria::coarse
