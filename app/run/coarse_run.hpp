// The coarse side of one run, from the case to the results. It begins or resumes the run, records it, and ends it when
// the load history ends, when no equilibrium is found, or when the user interrupts. Any equilibrium factory serves.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/run/fine_side.hpp"
#include "app/run/progress.hpp"
#include "app/run/run_lock.hpp"
#include "app/run/run_options.hpp"
#include "coarse/analysis/fatigue_analysis.hpp"
#include "coarse/results/checkpoint.hpp"
#include "coarse/results/summary.hpp"

namespace stria {

/// Makes the scene of a case (refined_scene.hpp). Some errors show only once there is a mesh: their CaseError names the
/// case file, too.
coarse::Scene scene_of(const RunOptions& options, const Case& input,
                       const std::function<void(const coarse::Scene&)>& before_solving = {});

class CoarseRun {
public:
    struct Manner {
        RunMode mode = RunMode::Mpi;
        int ranks = 1;
        bool terminal = false;  // the user watches on a terminal
    };

    /// Reads the checkpoint where the run is to be resumed. Throws CaseError where the checkpoint is damaged or belongs
    /// to another case.
    CoarseRun(const RunOptions& options, const Case& input, Manner manner);

    /// Runs to the end or to an interruption and returns the exit code. `fine` is null where the run has no separate
    /// fine component.
    int perform(coarse::EquilibriumFactory& factory, const FineSide* fine);

    [[nodiscard]] const coarse::Scene& scene() const { return scene_; }

private:
    /// What lives as long as the run is performed.
    struct Course {
        const FineSide* fine;
        coarse::FatigueAnalysis* analysis = nullptr;
        std::unique_ptr<coarse::RunRecorder> recorder = nullptr;  // from the first increment on
    };

    [[nodiscard]] coarse::Listener listener_of(Course& course);
    void take_note(const std::string& text);
    void take_increment(Course& course, const coarse::Increment& increment, const coarse::Structure& structure);
    /// Whether the run goes on once a load has been reached. Writes a checkpoint where one is due.
    [[nodiscard]] bool goes_on_after(const coarse::LoadStep& step, const Course& course);
    void warn_of_case(const coarse::FatigueAnalysis& analysis);
    void begin_tables(Course& course, coarse::EquilibriumFactory& factory);
    void run_analysis(const Course& course);
    /// Returns the exit code.
    int end(const Course& course);

    [[nodiscard]] double seconds() const;
    [[nodiscard]] std::filesystem::path checkpoint_path() const {
        return directory_ / coarse::result_files::checkpoint;
    }
    void read_last_checkpoint();
    void note_sizes(const coarse::Structure& structure);
    [[nodiscard]] bool is_due(const coarse::LoadStep& step) const;
    void write_checkpoint(const coarse::FatigueAnalysis& analysis, const coarse::RunRecorder& recorder);
    [[nodiscard]] std::string last_checkpoint() const;
    void summarise(coarse::RunStatus status, const Course& course) const;

    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    const RunOptions& options_;
    std::filesystem::path directory_;
    RunLock lock_;
    Manner manner_;
    std::string mesh_file_;  // checksum of what is in mesh.file before it is read; empty without one
    coarse::Scene scene_;
    double mesh_s_;  // time of mesh and enrichment, s
    double checkpoint_s_ = 0.0;
    Progress progress_;
    coarse::CaseMark mark_;
    std::optional<coarse::Checkpoint> from_;  // where the run resumes
    /// Of the case, of what the run came upon, an earlier part of it too, and of its end.
    struct Warnings {
        std::vector<std::string> of_case, met, at_end;
    } warnings_;
    std::optional<int> saved_;  // increment of the last checkpoint

    /// Of the last structure that has borne an increment: what fails in the middle of a growth has none.
    struct Sizes {
        std::int64_t unknowns = 0, on_gamma = 0;
    } sizes_;
};

}  // namespace stria
