#include "coarse/analysis/fatigue_analysis.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "coarse/analysis/growth_law.hpp"
#include "coarse/load/growth_schedule.hpp"
#include "coarse/zone/zone_selection.hpp"
#include "common/error.hpp"
#include "common/stopwatch.hpp"

namespace stria::coarse {
namespace {

constexpr double closure_precision = 0.002;  // of the larger load of a half cycle

}  // namespace

FatigueAnalysis::FatigueAnalysis(const Scene& scene, EquilibriumFactory& factory, Listener listener,
                                 const AnalysisState* from)
    : scene_(&scene), factory_(factory), listener_(std::move(listener)),
      controller_(scene.input.load, scene.input.solver), guard_(scene.input.material) {
    const Stopwatch watch(setup_s_);
    if (!scene.free_motions.text.empty()) listener_.note(scene.free_motions.text);
    committed_ = Eigen::VectorXd::Zero(scene.enriched.unknowns);
    std::vector<double> largest_K_I;
    if (!scene.enriched.tips.empty() || scene.input.load.control != Control::Load) {
        far_ = far_elements(scene, ElementSet(scene.mesh.elements.size()));
        NominalSolution nominal = solve_nominal_of(scene);
        largest_K_I = largest_nominal_K(nominal);
        structure_ = std::move(nominal.structure);
    }
    if (!nominal_.empty()) first_length_ = nominal_.front().a;
    closure_ = ClosureMeter(scene.input, largest_K_I);
    cycle_meter_ = CycleMeter(scene.input.closure.definition, closure_, nominal_.size());
    if (from != nullptr)
        restore(*from);
    else
        build(select_zone(scene, largest_K_I));
}

// Structures one after another, each with what serves of the last one's factors.
std::unique_ptr<Structure> FatigueAnalysis::condense(const Scene& scene, const ElementSet& in_zone) {
    const Stopwatch watch(coarse_factor_s_);
    const bool known = knows_far_body();
    auto structure = std::make_unique<Structure>(scene, in_zone, far_, std::exchange(factors_, {}));
    factors_ = structure->factors();
    if (!known && factors_.far) ++own_work_.far_factorisations;
    return structure;
}

bool FatigueAnalysis::knows_far_body() const { return factors_.far && factors_.far->far() == far_; }

// Of the first tip.
double FatigueAnalysis::grown() const { return first_length_ > 0.0 ? nominal_.front().a - first_length_ : 0.0; }

void FatigueAnalysis::build(const ElementSet& in_zone, const AnalysisState* from) {
    const bool has_zone = !in_zone.none();
    const std::shared_ptr<const NearFactor> near = factors_.near;
    if (!structure_ || &structure_->scene() != scene_ || structure_->in_zone() != in_zone) {  // else the nominal one
        far_ = from != nullptr ? from->far : far_elements(*scene_, in_zone, far_);
        note_if_large("condensing the structure onto the zone's boundary");
        if (!equilibrium_) structure_.reset();  // the nominal one: two factors at once would take twice the memory
        structure_ = condense(*scene_, in_zone);
    }
    ++(near && factors_.near == near ? own_work_.structure_factors_kept : own_work_.structure_factorisations);
    guard_.turn_to(*structure_, nominal_displacement_);
    rings_.emplace(*structure_);
    const coupling::Patch patch = has_zone ? patch_of(in_zone, structure_->gamma()) : coupling::Patch();
    if (equilibrium_) {
        earlier_exchange_s_ += equilibrium_->exchange_seconds();
        own_work_ += equilibrium_->work();
    }
    const coupling::Patch* zone_patch = has_zone ? &patch : nullptr;
    if (from != nullptr)
        equilibrium_ = factory_.resume(*structure_, zone_patch, committed_, from->zone);
    else
        equilibrium_ = factory_.make(*structure_, zone_patch, committed_, load_factor_);
    if (has_zone) restart(work_, *structure_, committed_);
    controller_.forget_increments();
    listener_.note(fmt::format("{} elements, {} of them in the zone; {} unknowns of the structure, {} on the interface",
                               in_zone.size(), in_zone.count(), structure_->unknowns(), structure_->gamma().size()));
}

coupling::Patch FatigueAnalysis::patch_of(const ElementSet& in_zone, const std::vector<int>& gamma) const {
    coupling::Patch patch = make_patch(*scene_, in_zone, gamma, committed_);
    patch.ahead = closure_.ahead(scene_->enriched);
    return patch;
}

// Where a factor takes seconds, the user should know what is going on.
void FatigueAnalysis::note_if_large(const char* phase) const {
    if (scene_->mesh.elements.size() > 100'000)
        listener_.note(fmt::format("{} ({} elements) ...", phase, scene_->mesh.elements.size()));
}

void FatigueAnalysis::run() {
    const Stopwatch watch(run_s_);
    while (!finished()) {
        const LoadStep step = *controller_.next();
        if (reach(step) && !listener_.reached(step)) return;
    }
}

// False where the increment is to be made again, shorter or with a larger zone.
bool FatigueAnalysis::reach(const LoadStep& step) {
    NewtonReport report = attempt(step);
    if (!report.converged) {
        cut_or_fail(step, report);
        return false;
    }
    if (zone_must_grow(step)) return false;
    const std::vector<OpeningChange> changes = measure_closure(step, report);
    accept(step, report, changes);
    controller_.accepted();
    if (scene_->input.growth && grows_at(*scene_->input.growth, step))
        growth_ended_ = has_grown_enough() || !grow(step);
    return true;
}

NewtonReport FatigueAnalysis::attempt(const LoadStep& step) {
    NewtonReport report =
        find_equilibrium(*equilibrium_, step.target, step.predictor, scene_->input.solver, largest_force_);
    newton_iterations_ += report.count();
    listener_.attempted(step, report);
    return report;
}

// K_op and K_cl by sub-stepping: contact that came or went within the increment is looked for between its ends, and
// then the increment is made as it was.
std::vector<OpeningChange> FatigueAnalysis::measure_closure(const LoadStep& step, NewtonReport& report) {
    const std::vector<char> now = closure_.closed(report);
    if (step.cycle == 0 || closed_.size() != now.size() || now == closed_) return {};
    const double from = controller_.reached(), to = step.target.value;
    const double precision = closure_precision * controller_.extreme();
    const auto changes = closure_.locate(closed_, now, from, to, precision, [&](double target) {
        equilibrium_->rollback();
        LoadStep trial = step;
        trial.target.value = target;
        trial.predictor.factor *= (target - from) / (to - from);
        ClosureMeter::Trial found{attempt(trial), 0.0};
        found.load_factor = equilibrium_->load_factor();
        return found;
    });
    equilibrium_->rollback();
    report = attempt(step);
    if (!report.converged)
        throw NumericalFailure(
            fmt::format("an increment that had converged, to {}, did not again", to_text(step.target)));
    return changes;
}

void FatigueAnalysis::cut_or_fail(const LoadStep& step, const NewtonReport& report) {
    equilibrium_->rollback();
    if (!controller_.cut()) {
        throw NumericalFailure(
            fmt::format("increment {} (cycle {}) towards {}: {} after {} halvings; the last converged "
                        "one is {}, load factor {:.6g}",
                        increment_ + 1, step.cycle, to_text(step.target), report.failure, scene_->input.solver.max_cuts,
                        to_text({step.target.control, controller_.reached()}), load_factor_));
    }
    listener_.note(fmt::format("{}: {}; the increment is halved", to_text(step.target), report.failure));
}

// The proof that "elastic outside the zone" held (docs/method.md, section 8).
bool FatigueAnalysis::zone_must_grow(const LoadStep& step) {
    const std::vector<int> yielding = guard_.elements_beyond(*equilibrium_);
    if (yielding.empty()) return false;
    if (scene_->input.fine.guard == Guard::Warn) {
        if (warnings_++ == 0) {
            listener_.note(fmt::format("warning: {}: {} elements outside the zone are beyond yield; "
                                       "they stay elastic (fine.guard = \"warn\")",
                                       to_text(step.target), yielding.size()));
        }
        return false;
    }
    listener_.note(fmt::format("{}: {} elements outside the zone would yield; they join it and the increment is redone",
                               to_text(step.target), yielding.size()));
    extend_zone(yielding);
    return true;
}

void FatigueAnalysis::extend_zone(const std::vector<int>& yielding) {
    equilibrium_->rollback();
    refresh_committed();
    ++extensions_;
    build(with_ring(*scene_, structure_->in_zone(), yielding));
}

// Only a new structure wants to know what the whole mesh did; the trial state must be the committed one.
void FatigueAnalysis::refresh_committed() {
    if (std::exchange(committed_behind_, false)) committed_ = equilibrium_->structure_displacement();
}

void FatigueAnalysis::accept(const LoadStep& step, const NewtonReport& report,
                             const std::vector<OpeningChange>& changes) {
    Increment increment;
    increment.number = ++increment_;
    increment.step = step;
    increment.opening_changes = changes;
    increment.load_factor = load_factor_ = equilibrium_->load_factor();
    increment.newton = report;
    largest_force_ = std::max(largest_force_, report.iterations.back().residual.scale);
    increment.machine = equilibrium_->machine_reading();
    equilibrium_->begin_commit(step.reversal);
    const RingIntegrals own = rings_->integrals(equilibrium_->near_displacement());
    increment.zone = equilibrium_->commit(step.reversal);
    increment.equilibrium = equilibrium_.get();
    increment.tips = fracture_parameters(*rings_, equilibrium_->near_displacement(), own, increment.zone);
    look_at_rings(increment);
    committed_behind_ = true;
    add_increment(work_, *structure_, equilibrium_->near_displacement(), load_factor_, increment.machine.imposed_force,
                  increment.zone);
    increment.work = work_;
    closed_ = increment.closed = closure_.closed(report);
    for (const TipResult& tip : nominal_) increment.nominal_K.push_back(tip.K_I);
    cycle_meter_.add(increment);
    if (step.ends_cycle) end_cycle(increment);
    listener_.accepted(increment, *structure_);
}

void FatigueAnalysis::end_cycle(Increment& increment) {
    increment.cycles = cycle_meter_.finish();
    if (const auto& growth = scene_->input.growth) {
        double grown = 0.0;
        for (const CycleResult& cycle : increment.cycles) grown = std::max(grown, cycle.da);
        const double before = fastest_rate(*growth, last_cycle_), after = fastest_rate(*growth, increment.cycles);
        for (CycleResult& cycle : increment.cycles) cycle.dN = cycles_passed(*growth, grown, before, after);
    }
    last_cycle_ = increment.cycles;
}

void FatigueAnalysis::look_at_rings(const Increment& increment) {
    const auto tip = std::ranges::find(increment.tips, true, &TipResult::rings_flow);
    if (tip == increment.tips.end()) return;
    if (flowing_rings_++ == 0) {
        listener_.note(
            fmt::format("load factor {:.6g}: no ring about tip {} lies outside what has flowed: K and T are no "
                        "elastic ones from here on",
                        increment.load_factor, tip - increment.tips.begin()));
    }
}

}  // namespace stria::coarse
