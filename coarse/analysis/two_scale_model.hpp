// Structure and zone of the present cracks in one equilibrium, and the state that both have committed.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "coarse/advice/mesh_adequacy.hpp"
#include "coarse/analysis/committed_displacement.hpp"
#include "coarse/analysis/cracked_body.hpp"
#include "coarse/cycle/closure_meter.hpp"
#include "coarse/equilibrium/equilibrium_factory.hpp"
#include "coarse/fracture/structure_rings.hpp"
#include "coarse/zone/yield_guard.hpp"

namespace stria::coarse {

class TwoScaleModel {
public:
    /// All references must outlive the model. `from`: a state to go on from; null: the unloaded body.
    TwoScaleModel(CrackedBody& body, const SolverSection& solver, const ClosureMeter& closure,
                  EquilibriumFactory& factory, CoarseEffort& effort, const Note& note, const AnalysisState* from);

    /// Newton's method, to a trial state. A body that gives way (limit_load_hint.hpp) has not converged.
    [[nodiscard]] NewtonReport solve(const LoadStep& step, const Waits& waits);
    void rollback() { equilibrium_->rollback(); }
    /// The state that an attempt has reached is wanted again before the next commit (Predictor, `back` 0).
    void put_aside() { equilibrium_->put_aside(); }
    /// Trial becomes committed. The increment holds what mechanics has to say of it: no number, no closure, no cycles.
    [[nodiscard]] Increment commit(const LoadStep& step, const NewtonReport& report);

    [[nodiscard]] double load_factor() const { return factors_.main; }  // committed
    [[nodiscard]] const WorkBalance& work() const { return work_; }     // likewise
    /// Of the trial state: mean, along the load's direction, mm.
    [[nodiscard]] double loaded_displacement() const { return equilibrium_->machine_reading().displacement; }
    [[nodiscard]] double trial_load_factor() const { return equilibrium_->load_factor(); }

    /// Elements outside the zone that the trial state takes beyond yield, ascending.
    [[nodiscard]] std::vector<int> elements_beyond_yield() { return guard_.elements_beyond(*equilibrium_); }
    /// Comes before extend_zone(): the trial state is lost, the zone is kept as it is. Returns what of the zone flowed.
    [[nodiscard]] ElementSet prepare_extension();
    /// They and their neighbours join the zone, split where they are large (fine.refine). `inside`: what flowed there.
    void extend_zone(const std::vector<int>& yielding, const ElementSet& inside);

    /// Comes before lengthen_cracks(): the zone is kept as it is.
    void prepare_growth();

    /// Figure 3 (a): no stress, no displacement, no internal variable changes. The last state must be committed. False
    /// where increments are not known any more, for predictors. `cycle`: in which they grow.
    [[nodiscard]] bool lengthen_cracks(GrownScene grown, int cycle);

    /// Of the present equilibrium and of the guard; what was before them is in the run's own record.
    [[nodiscard]] CoarseEffort effort() const;

    /// All but the dear parts: the zone, and what far elements do. `write_kept`: these as they were when
    /// prepare_growth() or prepare_extension() was called, beside what was written then.
    void write(AnalysisState& state) const;
    void write_dear(AnalysisState& state) const;
    void write_kept(AnalysisState& state) const;

private:
    /// With what somebody reads of an increment.
    [[nodiscard]] coupling::Commit commit_of(const LoadStep& step) const;
    /// Of the trial state, at the factors that it has.
    [[nodiscard]] RingIntegrals structure_integrals();
    /// What is asked of the mesh once so many cycles have passed.
    [[nodiscard]] MeshDemands demands(int passed) const;
    void keep_zone();
    void turn_to(const ElementSet& in_zone, std::optional<coupling::Patch> begun = {});
    void couple(const std::optional<coupling::Patch>& patch, const AnalysisState* from = nullptr);
    CrackedBody::Outgrown split_elements(FinerScene finer);
    [[nodiscard]] const EnrichedMesh& mesh() const { return body_.scene().enriched; }
    [[nodiscard]] coupling::Patch patch_of(const Scene& scene, const ElementSet& in_zone,
                                           const Eigen::VectorXd& displacement) const;

    CrackedBody& body_;
    const SolverSection& solver_;
    const ClosureMeter& closure_;
    EquilibriumFactory& factory_;
    CoarseEffort& effort_;
    const Note& note_;
    double gives_way_at_;  // mm: limit_load_hint.hpp
    bool peaks_between_;   // K may be largest between the extremes of the load
    YieldGuard guard_;
    std::unique_ptr<Equilibrium> equilibrium_;
    std::optional<StructureRings> rings_;  // of the present structure
    MeshJudge mesh_judge_;
    CommittedDisplacement displacement_;
    bool is_kept_ = false;        // keep_zone() has met one
    LoadFactors factors_;         // committed
    double largest_force_ = 0.0;  // largest scale of a residual that was committed, N/mm
    WorkBalance work_;            // committed
};

}  // namespace stria::coarse
