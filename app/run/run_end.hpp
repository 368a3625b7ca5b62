// What a run says of itself once it has ended, however that was.
#pragma once

#include <string>
#include <vector>

#include "app/run/fine_side.hpp"
#include "coarse/analysis/fatigue_analysis.hpp"
#include "coarse/results/run_recorder.hpp"
#include "coarse/results/summary.hpp"

namespace stria {

/// "life N = 264000 cycles, a = 13 mm", as in the last rows of cycles.csv, of each crack; empty before the first cycle
/// has ended, and where no crack grows. What has grown in the last cycle belongs to the cycles that follow.
[[nodiscard]] std::string cycles_passed(const coarse::FatigueAnalysis& analysis, double N);

/// What is doubtful in N, and in the balance of work.
[[nodiscard]] std::vector<std::string> warnings_at_end(const coarse::FatigueAnalysis& analysis, const Case& input,
                                                       double N);

/// What the components have counted. `fine`: null where the run has no separate fine component. Left open is what only
/// the run knows: its status and manner, sizes of the structure, warnings, and times of mesh, output and the whole. In
/// the time of the coarse solution that of the output is still contained.
[[nodiscard]] coarse::Summary summary_of(const coarse::FatigueAnalysis& analysis, const coarse::RunRecorder& recorder,
                                         const FineSide* fine);

}  // namespace stria
