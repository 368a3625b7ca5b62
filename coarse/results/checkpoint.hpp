// checkpoint.h5: all that a run needs to go on to the same numbers, there whole or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "coarse/analysis/analysis_state.hpp"
#include "coarse/results/case_mark.hpp"
#include "coarse/results/result_files.hpp"
#include "coarse/results/run_recorder.hpp"

namespace stria::coarse {

struct Checkpoint {
    CaseMark mark;
    AnalysisState analysis;
    RecorderState recorder;
    std::vector<std::string> warnings;  // what the run came upon so far
};

/// Where the run ends at another cycle than when the checkpoint was written, the rows and fields of the former last one
/// are no extremes of the last: an undisturbed run would not have written them.
void forget_former_end(Checkpoint& checkpoint, const CaseMark& now, const OutputSection& output);

/// With a checksum. An earlier one at `path` becomes the previous one (result_files.hpp).
void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint);

/// Throws CaseError where the file is damaged or of another version.
Checkpoint read_checkpoint(const std::filesystem::path& path);

}  // namespace stria::coarse
