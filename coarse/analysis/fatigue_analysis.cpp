#include "coarse/analysis/fatigue_analysis.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <new>
#include <utility>

#include "coarse/advice/limit_load_hint.hpp"
#include "coarse/advice/settled_stress.hpp"
#include "coarse/analysis/run_texts.hpp"
#include "common/error.hpp"
#include "common/stopwatch.hpp"

namespace stria::coarse {

FatigueAnalysis::FatigueAnalysis(const Scene& scene, EquilibriumFactory& factory, Listener listener,
                                 const AnalysisState* from)
    : listener_(std::move(listener)), guard_(scene.input.fine.guard), body_(scene, effort_, listener_.note, from),
      controller_(graded_load(scene.input, body_.nominal_at_start()), scene.input.solver, CaseHistories(scene.input)),
      closure_(
          ClosureMeter(scene.input.closure, scene.yield_stress_at_tips(), scene.input.cracks, body_.K_of_closure()),
          from != nullptr ? from->closure : ClosureMemory()),
      cycle_meter_(scene.input, closure_.meter(), scene.enriched.tips, controller_.looks_ahead()),
      model_(body_, scene.input.solver, closure_.meter(), factory, effort_, listener_.note, from) {
    controller_.set_scale(body_.load_scale());
    if (scene.input.growth)
        growth_.emplace(scene.input, listener_.note, from != nullptr ? from->growth : GrowthMemory());
    if (from == nullptr) return;
    controller_.resume(from->load);
    look_ahead();
    cycle_meter_.resume(from->cycle);
    last_cycle_ = from->last_cycle;
    due_growth_ = from->due_growth;
    release_ = from->release;
    effort_.counts = from->counts;
}

void FatigueAnalysis::look_ahead() {
    if (const std::optional<LegEnds> leg = controller_.leg_that_begins(body_.unit_displacement()))
        controller_.expect(closure_.outlook(*leg, body_.nominal()));
}

AnalysisState FatigueAnalysis::state() const {
    if (before_change_) return *before_change_;
    AnalysisState state = state_beside_zone();
    model_.write_dear(state);
    return state;
}

AnalysisState FatigueAnalysis::state_beside_zone() const {
    AnalysisState state;
    body_.write(state);
    model_.write(state);
    state.closure = closure_.memory();
    state.cycle = cycle_meter_.memory();
    state.last_cycle = last_cycle_;
    state.counts = effort_.counts;
    if (growth_) state.growth = growth_->memory();
    state.due_growth = due_growth_;
    state.release = release_;
    state.load = controller_.position();
    return state;
}

void FatigueAnalysis::run() {
    const Stopwatch watch(effort_.run_s);
    const bool settles = effort_.counts.increments == 0 && body_.scene().initial_stress().any();
    if (settles && !settle_initial_stress()) return;
    if (!grow_where_due() || !release_new_faces()) return;  // where a run goes on that was stopped there
    while (const std::optional<LoadStep> step = next()) {
        if (is_to_end()) return;
        compare_increments();
        std::optional<NewtonReport> found = solve_equilibrium(*step);
        if (!found) continue;  // the increment is made again, shorter or with a larger zone
        std::optional<std::vector<OpeningChange>> changes = measure_closure(*step, *found);
        if (!changes) continue;
        accept(*step, *found, std::move(*changes));
        controller_.accepted(openings(accepted_.tips));
        controller_.stands_at(accepted_.machine.displacement);
        look_ahead();
        if (const std::optional<double> off = controller_.take_missed_accuracy())
            listener_.note(misses_accuracy(*off, body_.scene().input.load.accuracy));
        if (growth_) growth_->take(accepted_, body_.scene());
        if (growth_ && growth_->is_due_at(*step)) due_growth_ = {true, step->cycle, step->moment};
        if (!grow_where_due()) return;
        if (!listener_.reached(*step)) return;
    }
}

// Equilibrium without load: what follows differs from it by the load's alone.
bool FatigueAnalysis::settle_initial_stress() {
    LoadStep step;
    step.settles = true;
    NewtonReport report;
    do {
        report = attempt(step);
        if (report.stopped) return false;
        if (!report.converged) {
            listener_.breaks_off();
            throw NumericalFailure(stress_does_not_settle(report));
        }
    } while (zone_must_grow(step));
    accept(step, report, {});
    controller_.stands_at(accepted_.machine.displacement);
    judge_settled_stress(body_.scene(), model_.work().stored, listener_.note);
    return true;
}

void FatigueAnalysis::compare_increments() {
    const std::optional<LoadStep> two = controller_.two_as_one();
    if (!two) return;
    const NewtonReport found = attempt(*two);
    model_.rollback();
    if (found.converged) controller_.tried_as_one(found.iterations.back().residual.opening);
}

bool FatigueAnalysis::is_to_end() const {
    if (listener_.goes_on()) return false;
    listener_.breaks_off();
    return true;
}

std::optional<NewtonReport> FatigueAnalysis::solve_equilibrium(const LoadStep& step) {
    NewtonReport report = attempt(step);
    if (!report.converged) {
        cut_or_fail(step, report);
        return std::nullopt;
    }
    if (zone_must_grow(step)) return std::nullopt;
    controller_.judge_predictor(report.was_misled());
    return report;
}

NewtonReport FatigueAnalysis::attempt(const LoadStep& step) {
    NewtonReport report = model_.solve(step, listener_.waits);
    listener_.attempted(step, report);
    return report;
}

void FatigueAnalysis::cut_or_fail(const LoadStep& step, const NewtonReport& report) {
    model_.rollback();
    if (report.stopped) return;
    if (!controller_.cut())
        fail(no_equilibrium(step, report, controller_.max_cuts(),
                            {effort_.counts.increments, controller_.reached_target(), model_.load_factor()}));
    listener_.note(fmt::format("{}: {}; the increment is halved", to_text(step.target), report.failure));
}

// The proof that "elastic outside the zone" held (docs/method.md, section 8).
bool FatigueAnalysis::zone_must_grow(const LoadStep& step) {
    const std::vector<int> yielding = model_.elements_beyond_yield();
    if (yielding.empty()) return false;
    if (guard_ == Guard::Warn) {
        if (effort_.counts.yield_warnings++ == 0) listener_.note(elements_stay_elastic(step, yielding.size()));
        return false;
    }
    listener_.note(elements_join_zone(step, yielding.size()));
    const ElementSet inside = model_.prepare_extension();
    change_body(fmt::format("{}: the zone cannot grow", to_text(step.target)),
                [&] { model_.extend_zone(yielding, inside); });
    controller_.forget_increments();
    return true;
}

// Where what is known does not tell, the increment is tried in parts, and then made as it was.
std::optional<std::vector<OpeningChange>> FatigueAnalysis::measure_closure(const LoadStep& step, NewtonReport& report) {
    if (!closure_.has_changed(step, report)) return std::vector<OpeningChange>();
    bool tried = false, stopped = false;
    const auto try_part = [&](const LoadStep& part) {
        if (!std::exchange(tried, true)) model_.put_aside();
        const ClosureMeter::Trial found{attempt(part), model_.trial_load_factor()};
        stopped = stopped || found.report.stopped;
        return found;
    };
    const ClosureMeasurement::End from{controller_.reached_target(), model_.load_factor()};
    const ClosureMeasurement::End to{step.target, model_.trial_load_factor()};
    auto changes =
        closure_.changes(step, report, {from, to, controller_.part_of_loads(), controller_.scale()}, try_part);
    if (tried) model_.rollback();
    if (stopped || (tried && !makes_again(step, report))) return std::nullopt;
    note_lost(step, changes);
    return changes;
}

// That takes one iteration, unless the tangents that Newton's method begins with lead elsewhere. Then the increment is
// halved like any other.
bool FatigueAnalysis::makes_again(LoadStep step, NewtonReport& report) {
    step.predictor = {1.0, 0};
    NewtonReport again = attempt(step);
    if (!again.converged) {
        cut_or_fail(step, again);
        return false;
    }
    Residual& last = report.iterations.back().residual;  // that of the state that will be committed
    again.iterations.back().residual.status_changes = last.status_changes;
    last = std::move(again.iterations.back().residual);
    return true;
}

void FatigueAnalysis::note_lost(const LoadStep& step, const std::vector<OpeningChange>& changes) const {
    const auto lost = std::ranges::find_if(changes, [](const auto& change) { return std::isnan(change.load_factor); });
    if (lost != changes.end())
        listener_.note(load_left_empty(step, {step.target.control, controller_.reached()}, lost->tip,
                                       closure_.meter().what_a_tip_does(*lost)));
}

void FatigueAnalysis::accept(const LoadStep& step, const NewtonReport& report, std::vector<OpeningChange> changes) {
    Increment increment = model_.commit(step, report);
    increment.number = ++effort_.counts.increments;
    increment.signal = closure_.commit(step, report, changes, controller_.scale());
    increment.opening_changes = std::move(changes);
    increment.nominal = body_.nominal();
    for (const std::string& doubt : count_doubts(increment, body_.scene(), effort_.counts)) listener_.note(doubt);
    cycle_meter_.add(increment);
    if (step.ends_cycle) end_cycle(increment);
    listener_.accepted(increment, body_.structure());
    accepted_ = std::move(increment);
}

void FatigueAnalysis::end_cycle(Increment& increment) {
    increment.cycles = cycle_meter_.finish(peaks_ahead(increment, controller_.next_quarter()));
    if (growth_) growth_->count_cycles(increment.step.cycle, increment.cycles, body_.scene());
    last_cycle_ = increment.cycles;
}

// Figure 3: (a) the cracks are longer, and forces hold their new faces; (b) at constant load the body finds equilibrium
// without them.
bool FatigueAnalysis::grow_where_due() {
    if (!due_growth_.due) return true;
    model_.prepare_growth();
    change_body(fmt::format("cycle {}: the cracks cannot grow", due_growth_.cycle), [&] {
        GrownScene grown = growth_->next(body_, last_cycle_);
        if (growth_->ended() && accepted_.number > 0) listener_.growth_ended(accepted_, body_.structure());
        if (!grown.longer) return;
        if (!model_.lengthen_cracks(std::move(grown), due_growth_.cycle)) controller_.forget_increments();
        controller_.set_scale(body_.load_scale());
        release_ = {.cycle = due_growth_.cycle, .moment = due_growth_.moment, .held = 1.0};
    });
    due_growth_ = {};
    return release_new_faces();
}

// Where it fails, also for want of memory, only the state before it is whole.
void FatigueAnalysis::change_body(const std::string& what, const std::function<void()>& change) {
    AnalysisState before = state_beside_zone();
    const auto break_off = [&] {
        model_.write_kept(before);
        before_change_ = std::move(before);
        listener_.breaks_off();
    };
    try {
        change();
    } catch (const NumericalFailure& failure) {
        break_off();
        throw NumericalFailure(what + ": " + failure.what());
    } catch (const CaseError&) {
        break_off();
        throw;
    } catch (const std::bad_alloc&) {
        break_off();
        throw;
    }
}

// At once where Newton's method gets there; else in parts, halved like any increment.
bool FatigueAnalysis::release_new_faces() {
    while (release_.held > 0.0) {
        if (is_to_end()) return false;
        const LoadStep step = release_.next(controller_.reached_target());
        const NewtonReport report = attempt(step);
        if (!report.converged) {
            cut_release_or_fail(step, report);
            continue;
        }
        if (zone_must_grow(step)) continue;
        accept(step, report, {});
        controller_.committed_besides(step.cycle, openings(accepted_.tips));
        release_.advance();
        look_ahead();  // of the longer crack, as a run does that goes on from here
    }
    return true;
}

void FatigueAnalysis::cut_release_or_fail(const LoadStep& step, const NewtonReport& report) {
    model_.rollback();
    if (report.stopped) return;
    if (release_.cuts >= controller_.max_cuts()) fail(faces_not_released(step, report, release_, body_.nominal()));
    listener_.note(released_in_parts(step, report));
    release_.halve();
    ++effort_.counts.release_cuts;
}

// The committed state is whole.
void FatigueAnalysis::fail(const std::string& what) const {
    listener_.breaks_off();
    throw NumericalFailure(what + limit_load_hint(body_.scene(), std::abs(model_.loaded_displacement())));
}

}  // namespace stria::coarse
