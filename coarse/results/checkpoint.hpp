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

/// How the writing of checkpoints has gone so far.
struct CheckpointEffort {
    bool has_one = false;
    double seconds = 0.0;       // that it took
    double of_the_run_s = 0.0;  // what all has taken
};

/// Whether one is to be written where a step has ended. `every`: cycles; auto: after 10 of them, as long as checkpoints
/// have taken less than a twentieth of the time, for a cycle may take less than its checkpoint.
[[nodiscard]] bool checkpoint_is_due(const OrAuto<int>& every, const LoadStep& step, const CheckpointEffort& so_far);

/// With a checksum. An earlier one at `path` becomes the previous one (result_files.hpp).
void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint);

/// Throws CaseError where the file is damaged or of another version.
Checkpoint read_checkpoint(const std::filesystem::path& path);

}  // namespace stria::coarse
