// checkpoint.h5: all that a run needs to go on to the same numbers, there whole or not at all.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "coarse/analysis/fatigue_analysis.hpp"
#include "coarse/results/run_recorder.hpp"

namespace stria::coarse {

/// Which case a checkpoint is of.
struct CaseMark {
    std::string text;               // all of the case that must not change on the way, as a case file
    std::vector<LoadBlock> blocks;  // of the load history, which may change where the load has not been yet
    double scale = 1.0;
    int repeat = 1;
    std::uint64_t mesh = 0;  // digest of its nodes
};

CaseMark mark_of(const Scene& scene);

struct Checkpoint {
    CaseMark mark;
    AnalysisState analysis;
    RecorderState recorder;
};

/// Throws CaseError, naming the first difference, where a run of another case cannot go on from a checkpoint.
void check_same_case(const Checkpoint& checkpoint, const CaseMark& now);

void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint);

/// Throws CaseError where the file is damaged or of another version.
Checkpoint read_checkpoint(const std::filesystem::path& path);

}  // namespace stria::coarse
