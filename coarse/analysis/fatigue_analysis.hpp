// The outer loop: load after load to equilibrium, the zone extended where the structure would yield, results recorded.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "coarse/analysis/cycle_meter.hpp"
#include "coarse/analysis/increment.hpp"
#include "coarse/equilibrium/equilibrium_factory.hpp"
#include "coarse/equilibrium/work_balance.hpp"
#include "coarse/fracture/load_scale.hpp"
#include "coarse/structure/structure.hpp"
#include "coarse/zone/yield_guard.hpp"

namespace stria::coarse {

/// What the analysis tells as it goes. app/ and tests listen.
struct Listener {
    std::function<void(const Increment&, const Structure&)> accepted = [](const Increment&, const Structure&) {};
    std::function<void(const std::string&)> note = [](const std::string&) {};  // one line for the log
    std::function<void(const LoadStep&, const NewtonReport&)> attempted = [](const LoadStep&, const NewtonReport&) {
    };  // converged or not
    /// The load has been reached and all that follows from that is done; false: stop here.
    std::function<bool(const LoadStep&)> reached = [](const LoadStep&) { return true; };
};

/// All that an analysis remembers between two increments. Whatever else it holds is a function of this and of the case,
/// so that going on from it changes no digit.
struct AnalysisState {
    struct Polyline {
        std::vector<double> x, y;  // mm
    };
    std::vector<Polyline> cracks;
    ElementSet in_zone;
    ElementSet far;                // with which the structure was condensed (it shows in the last bits)
    Eigen::VectorXd displacement;  // of the whole mesh, zero inside the zone, mm
    double load_factor = 0.0;
    double largest_force = 0.0;  // largest scale of a residual up to now, N/mm
    std::vector<char> closed;    // signals of the closure meter
    CycleMemory cycle;
    std::vector<CycleResult> last_cycle;  // one a tip, of the last cycle that ended
    std::vector<TipResult> nominal;       // of the present lengths
    int increment = 0, newton_iterations = 0, extensions = 0, warnings = 0, flowing_rings = 0;
    bool growth_ended = false;  // the growth has ended the run
    LoadPosition load;
    WorkBalance work;
    EquilibriumState equilibrium;
    coupling::ZoneSnapshot zone;  // empty without one
};

class FatigueAnalysis {
public:
    /// `from`: what to go on from, of the same case; null: the beginning.
    FatigueAnalysis(const Scene& scene, EquilibriumFactory& factory, Listener listener,
                    const AnalysisState* from = nullptr);

    /// Runs all blocks, or until the listener stops it. Throws NumericalFailure where an increment fails after cutting:
    /// what, where, at which load.
    void run();

    /// Nothing is left to do.
    [[nodiscard]] bool finished() const { return growth_ended_ || !controller_.next(); }

    /// Between increments: where the listener is told that a load has been reached, and after run() has returned.
    [[nodiscard]] AnalysisState state() const;

    [[nodiscard]] const Structure& structure() const { return *structure_; }
    /// Elastic, traction-free stress intensities for the load factor 1, one per tip: nominal K of docs/method.md,
    /// section 9.
    [[nodiscard]] const std::vector<TipResult>& nominal() const { return nominal_; }
    [[nodiscard]] const ClosureMeter& closure() const { return closure_; }
    [[nodiscard]] int newton_iterations() const { return newton_iterations_; }
    [[nodiscard]] int cuts() const { return controller_.cuts(); }
    [[nodiscard]] int zone_extensions() const { return extensions_; }
    [[nodiscard]] int yield_warnings() const { return warnings_; }
    /// Of the structure.
    [[nodiscard]] coupling::WorkCounts work() const { return own_work_ + equilibrium_->work() + guard_.work(); }
    /// Increments in which some tip had no ring outside what has flowed.
    [[nodiscard]] int flowing_rings() const { return flowing_rings_; }
    [[nodiscard]] double exchange_seconds() const { return earlier_exchange_s_ + equilibrium_->exchange_seconds(); }
    [[nodiscard]] double setup_seconds() const { return setup_s_; }
    [[nodiscard]] double growth_seconds() const { return growth_s_; }
    [[nodiscard]] double run_seconds() const { return run_s_; }
    [[nodiscard]] double coarse_factor_seconds() const { return coarse_factor_s_; }

private:
    [[nodiscard]] std::unique_ptr<Structure> condense(const Scene& scene, const ElementSet& in_zone);
    [[nodiscard]] bool knows_far_body() const;
    [[nodiscard]] NominalSolution solve_nominal_of(const Scene& scene);
    [[nodiscard]] std::vector<double> largest_nominal_K(const NominalSolution& nominal);
    void restore(const AnalysisState& from);
    void build(const ElementSet& in_zone, const AnalysisState* from = nullptr);
    [[nodiscard]] coupling::Patch patch_of(const ElementSet& in_zone, const std::vector<int>& gamma) const;
    void refresh_committed();
    void note_if_large(const char* phase) const;
    [[nodiscard]] bool zone_must_grow(const LoadStep& step);
    void extend_zone(const std::vector<int>& yielding);
    void cut_or_fail(const LoadStep& step, const NewtonReport& report);
    [[nodiscard]] bool reach(const LoadStep& step);
    [[nodiscard]] NewtonReport attempt(const LoadStep& step);
    void accept(const LoadStep& step, const NewtonReport& report, const std::vector<OpeningChange>& changes);
    void end_cycle(Increment& increment);
    [[nodiscard]] bool has_grown_enough() const;
    [[nodiscard]] double grown() const;
    [[nodiscard]] bool grow(const LoadStep& reached);
    [[nodiscard]] std::unique_ptr<Scene> scene_of_longer_cracks(const Case& input);
    void take(std::unique_ptr<Scene> longer);
    [[nodiscard]] ElementSet zone_about(const Scene& longer);
    [[nodiscard]] std::vector<OpeningChange> measure_closure(const LoadStep& step, NewtonReport& report);
    void look_at_rings(const Increment& increment);

    const Scene* scene_;
    std::unique_ptr<Scene> grown_;  // the present one, once a crack has grown
    EquilibriumFactory& factory_;
    Listener listener_;
    LoadController controller_;
    ElementSet far_;  // near_elements.hpp
    StructureFactors factors_;
    std::unique_ptr<Structure> structure_;
    std::optional<StructureRings> rings_;
    YieldGuard guard_;
    std::unique_ptr<Equilibrium> equilibrium_;
    std::vector<TipResult> nominal_;
    Eigen::VectorXd nominal_displacement_;  // of the whole mesh for the load factor 1; empty: its far body is known
    Eigen::VectorXd committed_;             // displacement of the whole mesh; behind while increments are accepted:
    bool committed_behind_ = false;         // refresh_committed()
    double load_factor_ = 0.0;              // committed
    double largest_force_ = 0.0;            // scale of the residual, over all that was committed, N/mm
    WorkBalance work_;                      // committed
    ClosureMeter closure_;
    std::vector<char> closed_;  // signals of the closure meter, committed
    CycleMeter cycle_meter_;
    std::vector<CycleResult> last_cycle_;  // one a tip, of the last cycle that ended
    double first_length_ = 0.0;            // of the crack of the first tip at the start, mm
    bool growth_ended_ = false;
    int increment_ = 0, newton_iterations_ = 0, extensions_ = 0, warnings_ = 0, flowing_rings_ = 0;
    double setup_s_ = 0.0, growth_s_ = 0.0, run_s_ = 0.0, coarse_factor_s_ = 0.0, earlier_exchange_s_ = 0.0;
    coupling::WorkCounts own_work_;  // and that of equilibria before the present one
};

}  // namespace stria::coarse
