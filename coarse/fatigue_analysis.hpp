// The outer loop: load after load to equilibrium, the zone extended where the structure would yield, results recorded.
#pragma once

#include <functional>
#include <memory>

#include "coarse/cycle_meter.hpp"
#include "coarse/increment.hpp"
#include "coarse/structure.hpp"
#include "coarse/work_balance.hpp"
#include "coupling/fine_scale.hpp"

namespace stria::coarse {

/// How equilibrium is found once structure and zone are known: condensed over a port, or monolithic. Only app/ chooses.
class EquilibriumFactory {
public:
    EquilibriumFactory() = default;
    EquilibriumFactory(const EquilibriumFactory&) = delete;
    EquilibriumFactory& operator=(const EquilibriumFactory&) = delete;
    virtual ~EquilibriumFactory() = default;

    /// `patch`: null where the scene has no zone. `committed`: displacement of the whole mesh, reached at
    /// `load_factor`.
    virtual std::unique_ptr<Equilibrium> make(const Structure& structure, const coupling::Patch* patch,
                                              const Eigen::VectorXd& committed, double load_factor) = 0;

    /// Full committed state of the zone.
    virtual coupling::ZoneState zone_state() = 0;
};

/// Equilibrium of structure and zone over the port (null: no fine component).
class CondensedFactory : public EquilibriumFactory {
public:
    explicit CondensedFactory(coupling::FineScale* fine) : fine_(fine) {}
    std::unique_ptr<Equilibrium> make(const Structure& structure, const coupling::Patch* patch,
                                      const Eigen::VectorXd& committed, double load_factor) override;
    coupling::ZoneState zone_state() override { return fine_->state(); }

private:
    coupling::FineScale* fine_;
};

/// What the analysis tells as it goes. app/ and tests listen.
struct Listener {
    std::function<void(const Increment&, const Structure&)> accepted = [](const Increment&, const Structure&) {};
    std::function<void(const std::string&)> note = [](const std::string&) {};  // one line for the log
    std::function<void(const LoadStep&, const NewtonReport&)> attempted = [](const LoadStep&, const NewtonReport&) {
    };  // converged or not
};

class FatigueAnalysis {
public:
    FatigueAnalysis(const Scene& scene, EquilibriumFactory& factory, Listener listener);

    /// Runs all blocks. Throws NumericalFailure where an increment fails after cutting: what, where, at which load.
    void run();

    [[nodiscard]] const Structure& structure() const { return *structure_; }
    /// Elastic, traction-free stress intensities for the load factor 1, one a tip (nominal K, INTERFACE).
    [[nodiscard]] const std::vector<TipResult>& nominal() const { return nominal_; }
    [[nodiscard]] const ClosureMeter& closure() const { return closure_; }
    [[nodiscard]] int newton_iterations() const { return newton_iterations_; }
    [[nodiscard]] int cuts() const { return controller_.cuts(); }
    [[nodiscard]] int zone_extensions() const { return extensions_; }
    [[nodiscard]] int yield_warnings() const { return warnings_; }
    /// Increments in which some tip had no ring outside what has flowed.
    [[nodiscard]] int flowing_rings() const { return flowing_rings_; }
    [[nodiscard]] double exchange_seconds() const { return earlier_exchange_s_ + equilibrium_->exchange_seconds(); }
    [[nodiscard]] double setup_seconds() const { return setup_s_; }
    [[nodiscard]] double run_seconds() const { return run_s_; }
    [[nodiscard]] double coarse_factor_seconds() const { return coarse_factor_s_; }

private:
    std::vector<double> solve_nominal();
    void build(const std::vector<char>& in_zone);
    void note_if_large(const char* phase) const;
    [[nodiscard]] bool zone_must_grow(const LoadStep& step);
    void extend_zone(const std::vector<int>& yielding);
    void cut_or_fail(const LoadStep& step, const NewtonReport& report);
    [[nodiscard]] NewtonReport attempt(const LoadStep& step);
    void accept(const LoadStep& step, const NewtonReport& report, const std::vector<OpeningChange>& changes);
    void end_cycle(Increment& increment);
    [[nodiscard]] bool has_grown_enough() const;
    [[nodiscard]] double grown() const;
    [[nodiscard]] bool grow(const LoadStep& reached);
    [[nodiscard]] std::unique_ptr<Scene> scene_of_longer_cracks(const Case& input);
    void take_into_zone(const EnrichedMesh& longer);
    [[nodiscard]] std::vector<OpeningChange> measure_closure(const LoadStep& step, NewtonReport& report);
    void look_at_rings(const Increment& increment);

    const Scene* scene_;
    std::unique_ptr<Scene> grown_;  // the present one, once a crack has grown
    EquilibriumFactory& factory_;
    Listener listener_;
    LoadController controller_;
    std::unique_ptr<Structure> structure_;
    std::unique_ptr<Equilibrium> equilibrium_;
    std::vector<TipResult> nominal_;
    Eigen::VectorXd committed_;  // displacement of the whole mesh
    double load_factor_ = 0.0;   // committed
    WorkBalance work_;           // committed
    ClosureMeter closure_;
    std::vector<char> closed_;  // signals of the closure meter, committed
    CycleMeter cycle_meter_;
    std::vector<CycleResult> last_cycle_;  // one a tip, of the last cycle that ended
    double first_length_ = 0.0;            // of the crack of the first tip at the start, mm
    int increment_ = 0, newton_iterations_ = 0, extensions_ = 0, warnings_ = 0, flowing_rings_ = 0;
    double setup_s_ = 0.0, run_s_ = 0.0, coarse_factor_s_ = 0.0, earlier_exchange_s_ = 0.0;
};

}  // namespace stria::coarse
