// The outer loop: load after load to equilibrium, the zone extended where the structure would yield, the cracks grown.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "coarse/analysis/crack_growth.hpp"
#include "coarse/analysis/two_scale_model.hpp"
#include "coarse/cycle/closure_measurement.hpp"

namespace stria::coarse {

class FatigueAnalysis {
public:
    /// `from`: a state of the same case to go on from; null: the beginning. `scene` and `factory` must outlive the
    /// analysis.
    FatigueAnalysis(const Scene& scene, EquilibriumFactory& factory, Listener listener,
                    const AnalysisState* from = nullptr);
    FatigueAnalysis(const FatigueAnalysis&) = delete;
    FatigueAnalysis& operator=(const FatigueAnalysis&) = delete;

    /// Runs all blocks, or until the listener stops it. Throws NumericalFailure where an increment fails after cutting,
    /// new faces are not released, or the cracks or the zone cannot grow: what, where, at which load. CaseError where
    /// the body that this would make is one that no case may ask for.
    void run();

    /// Nothing is left to do.
    [[nodiscard]] bool finished() const { return !due_growth_.due && release_.held == 0.0 && !next(); }

    /// Growth has ended the run, and neither arrest nor the mesh: the cycles up to now are the life.
    [[nodiscard]] bool life_is_over() const { return growth_ && growth_->life_is_over(); }
    /// As CrackGrowth has it, mm.
    [[nodiscard]] double uncounted_growth() const { return growth_ ? growth_->rates().uncounted() : 0.0; }
    [[nodiscard]] double life_in_doubt() const { return growth_ ? growth_->rates().life_in_doubt() : 0.0; }

    [[nodiscard]] const WorkBalance& work() const { return model_.work(); }  // of the committed state

    /// Between increments: where the listener is told that a load has been reached or that none will be, and after
    /// run() has returned.
    [[nodiscard]] AnalysisState state() const;

    /// One per tip, of the last cycle that has ended; empty before.
    [[nodiscard]] const std::vector<CycleResult>& last_cycle() const { return last_cycle_; }

    [[nodiscard]] const Structure& structure() const { return body_.structure(); }
    /// Elastic, traction-free stress intensities for the load factor 1, one per tip: nominal K of docs/method.md,
    /// section 9.
    [[nodiscard]] const std::vector<TipResult>& nominal() const { return body_.nominal(); }
    /// Of the load history, one per tip, MPa sqrt(mm), for the cracks there are.
    [[nodiscard]] const std::vector<double>& largest_K() const { return body_.largest_K(); }
    /// Of the cracks that the run began with.
    [[nodiscard]] const UnitResponse& nominal_at_start() const { return body_.nominal_at_start(); }
    [[nodiscard]] const ClosureMeter& closure() const { return closure_.meter(); }
    /// Increments that were halved.
    [[nodiscard]] int cuts() const { return controller_.cuts() + effort_.counts.release_cuts; }
    [[nodiscard]] CoarseEffort effort() const {
        CoarseEffort total = effort_;
        return total += model_.effort();
    }

private:
    [[nodiscard]] AnalysisState state_beside_zone() const;
    /// To the half cycle that begins, if one does.
    void look_ahead();
    /// Each two increments differ from one: by that a leg is known to have enough of them (IncrementSchedule).
    void compare_increments();
    [[nodiscard]] bool is_to_end() const;
    [[nodiscard]] bool settle_initial_stress();
    [[nodiscard]] std::optional<LoadStep> next() const {
        return growth_ && growth_->ended() ? std::nullopt : controller_.next();
    }
    [[nodiscard]] std::optional<NewtonReport> solve_equilibrium(const LoadStep& step);
    [[nodiscard]] NewtonReport attempt(const LoadStep& step);
    void cut_or_fail(const LoadStep& step, const NewtonReport& report);
    [[nodiscard]] bool zone_must_grow(const LoadStep& step);
    [[nodiscard]] std::optional<std::vector<OpeningChange>> measure_closure(const LoadStep& step, NewtonReport& report);
    /// An increment that has been found and put aside.
    [[nodiscard]] bool makes_again(LoadStep step, NewtonReport& report);
    void accept(const LoadStep& step, const NewtonReport& report, std::vector<OpeningChange> changes);
    void note_lost(const LoadStep& step, const std::vector<OpeningChange>& changes) const;
    void end_cycle(Increment& increment);
    /// Both: false where the run is to end.
    bool grow_where_due();
    bool release_new_faces();
    void cut_release_or_fail(const LoadStep& step, const NewtonReport& report);
    /// Turns to longer cracks or another zone. `what`: that cannot be done, where it fails.
    void change_body(const std::string& what, const std::function<void()>& change);
    [[noreturn]] void fail(const std::string& what) const;

    Listener listener_;
    CoarseEffort effort_;
    Guard guard_;  // what to do where coarse elements would yield
    CrackedBody body_;
    LoadController controller_;
    ClosureMeasurement closure_;
    CycleMeter cycle_meter_;
    Increment accepted_;                   // the last one
    std::vector<CycleResult> last_cycle_;  // one per tip, of the last cycle that ended
    std::optional<CrackGrowth> growth_;
    DueGrowth due_growth_;
    std::optional<AnalysisState> before_change_;  // that has failed: the last state that is whole
    FaceRelease release_;
    TwoScaleModel model_;
};

}  // namespace stria::coarse
