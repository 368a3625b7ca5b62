// What an increment and a cycle become in the tables.
#pragma once

#include <vector>

#include "coarse/cycle/closure_meter.hpp"
#include "coarse/cycle/increment.hpp"
#include "coarse/results/tables.hpp"
#include "common/enrichment/enriched_mesh.hpp"

namespace stria::coarse {

/// One row per tip; without tips, one. `load`, N/mm, and `displacement`, mm: of the loaded boundary, NaN without one.
[[nodiscard]] std::vector<HistoryRow> history_rows(const Increment& increment, const std::vector<Tip>& tips,
                                                   double load, double displacement);

/// Of a tip, of the cycle that an increment has ended. Iterations and wall time are left to the recorder.
[[nodiscard]] CycleRow cycle_row(const Increment& increment, int tip);

/// Likewise, one row per distance behind the tip.
[[nodiscard]] std::vector<ClosureRow> closure_rows(const Increment& increment, int tip, const ClosureMeter& closure);

[[nodiscard]] FaceRow face_row(std::int64_t increment, const coupling::FaceSample& sample);

/// Columns and cells of loads.csv: the factors of the load cases by their names, and where the middles of pressures
/// that travel are, mm; empty before they come on.
[[nodiscard]] std::vector<std::string> load_columns(const Case& input);
[[nodiscard]] std::vector<Cell> load_cells(const Case& input, const Increment& increment);

/// Columns and cells of load-cases.csv: what each load alone does to a tip at its factor 1, of the cycle that an
/// increment has ended; without the positions of pressures that travel.
[[nodiscard]] std::vector<std::string> load_case_columns(const Case& input);
[[nodiscard]] std::vector<Cell> load_case_cells(const Case& input, const Increment& increment, int tip);

}  // namespace stria::coarse
