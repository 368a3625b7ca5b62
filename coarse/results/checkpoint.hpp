// checkpoint.h5: all that a run needs to go on to the same numbers, there whole or not at all.
#pragma once

#include <filesystem>

#include "coarse/analysis/analysis_state.hpp"
#include "coarse/results/case_mark.hpp"
#include "coarse/results/run_recorder.hpp"

namespace stria::coarse {

struct Checkpoint {
    CaseMark mark;
    AnalysisState analysis;
    RecorderState recorder;
};

void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint);

/// Throws CaseError where the file is damaged or of another version.
Checkpoint read_checkpoint(const std::filesystem::path& path);

}  // namespace stria::coarse
