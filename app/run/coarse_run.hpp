// The coarse side of one run, from case to results, whoever finds equilibrium: begun or resumed, written down on the
// way, and ended by the load, by the numbers or by the user.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "app/run/fine_side.hpp"
#include "app/run/progress.hpp"
#include "app/run/run_options.hpp"
#include "coarse/results/checkpoint.hpp"

namespace stria {

/// What only the mesh can tell is wrong names the case file too.
coarse::Scene scene_of(const RunOptions& options, const Case& input);

class CoarseRun {
public:
    struct Manner {
        std::string mode;
        int ranks = 1;
        bool terminal = false;  // the user's own output is one
    };

    /// Reads the checkpoint where the run is to be resumed; throws CaseError where it is of another case or damaged.
    CoarseRun(const RunOptions& options, const Case& input, Manner manner);

    /// Runs to the end or to an interruption; the exit code. `fine`: null where it is no component of its own.
    int perform(coarse::EquilibriumFactory& factory, const FineSide* fine);

    [[nodiscard]] const coarse::Scene& scene() const { return scene_; }

private:
    [[nodiscard]] double seconds() const;
    [[nodiscard]] std::filesystem::path checkpoint_path() const { return directory_ / "checkpoint.h5"; }
    void read_last_checkpoint();
    [[nodiscard]] bool is_due(const coarse::LoadStep& step) const;
    void write_checkpoint(const coarse::FatigueAnalysis& analysis, const coarse::RunRecorder& recorder);
    [[nodiscard]] std::string last_checkpoint() const;
    void summarise(const char* status, const coarse::FatigueAnalysis& analysis, const coarse::RunRecorder& recorder,
                   const FineSide* fine) const;

    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    const RunOptions& options_;
    std::filesystem::path directory_;
    Manner manner_;
    coarse::Scene scene_;
    double mesh_s_;  // and enrichment
    double checkpoint_s_ = 0.0;
    Progress progress_;
    coarse::CaseMark mark_;
    std::optional<coarse::Checkpoint> from_;  // what to go on from
    std::optional<int> saved_;                // increment of the last checkpoint
};

}  // namespace stria
