#include "fine/zone/zone_system.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "common/case/case_questions.hpp"
#include "common/enrichment/same_functions.hpp"
#include "common/index.hpp"
#include "common/stopwatch.hpp"
#include "fine/bulk/bulk_report.hpp"
#include "fine/bulk/joining_elements.hpp"
#include "fine/zone/zone_report.hpp"

namespace stria::fine {

ZoneSystem::ZoneSystem(const ZoneSections& input)
    : input_(input), memory_{.increments =
                                 IncrementMemory<ZoneUnknowns>(remembered_increments(input.steps_per_cycle))} {}

TakenOver ZoneSystem::set_patch(const coupling::Patch& patch) {
    if (bulk_) wake_all();
    const bool stays = bulk_ && patch.part_of.empty() && patch_.boundary == patch.boundary &&
                       same_but_for_tips(patch_.mesh, patch.mesh) && same_arc_lengths(patch_.mesh, patch.mesh);
    return stays ? move_tips(patch) : begin_zone(patch);
}

// The elements are the same, and so are the faces; of an attempt nothing is left.
TakenOver ZoneSystem::move_tips(const coupling::Patch& patch) {
    contact_->restore(contact_->committed_statuses(), contact_->approach());
    carry_increments(memory_, patch_.mesh, *contact_, patch, *contact_);
    bulk_->move_tips(patch.mesh.tips);
    const EnrichedMesh before = std::move(patch_.mesh);
    const Eigen::VectorXd slips = contact_->settled_slips();
    begin_with(patch);
    contact_->hold_slips(slips);
    memory_.opening.follow(before, patch_.mesh);
    return taken_over(bulk_->elements(), true, *contact_, contact_.get());
}

TakenOver ZoneSystem::begin_zone(const coupling::Patch& patch) {
    const std::unique_ptr<Bulk> old = std::move(bulk_);
    const std::unique_ptr<ContactInterface> old_contact = std::move(contact_);
    const Eigen::VectorXd force = old && forgets() ? committed_force(*old, *old_contact) : Eigen::VectorXd();
    const Eigen::VectorXd committed = memory_.committed.displacement;
    const bool keeps_slips = old && forgets() && has_friction(input_.cracks);
    FrozenTips let_go;
    if (old && patch.part_of.empty() && (keeps_slips || !forgets()))
        freeze_what_is_left(forgets() ? let_go : memory_.frozen, committed, patch_.mesh, patch);
    contact_ = make_contact(patch, memory_.frozen);
    carry_unknowns(memory_, patch_.mesh, old_contact.get(), patch, *contact_);
    if (old_contact) carry_increments(memory_, patch_.mesh, *old_contact, patch, *contact_);
    if (memory_.committed.displacement.isZero(0.0)) contact_->begin_touching();
    bulk_ = std::make_unique<Bulk>(patch.mesh, input_.materials, make_laws(), input_.rule(), old.get(),
                                   memory_.committed.displacement);
    const EnrichedMesh before = std::move(patch_.mesh);
    rings_.clear();
    begin_with(patch);
    if (keeps_slips)
        contact_->hold_slips(
            slips_to_hold(*old_contact, committed, *make_contact(patch, let_go), memory_.committed.displacement));
    if (old) open_new_faces(before, force);
    return taken_over(bulk_->elements(), false, *contact_, old_contact.get());
}

std::unique_ptr<ContactInterface> ZoneSystem::make_contact(const coupling::Patch& patch,
                                                           const FrozenTips& frozen) const {
    std::vector<int> boundary = patch.boundary;
    std::ranges::sort(boundary);
    return std::make_unique<ContactInterface>(patch.mesh, boundary, input_.cracks, subcells_at_crack(input_.fine),
                                              input_.materials.largest_plane_modulus(), frozen);
}

void ZoneSystem::begin_with(const coupling::Patch& patch) {
    patch_ = patch;
    trial_ = memory_.committed;
    soft_jumps_ = SoftJumps(bulk_->elements(), patch_.boundary, input_.tolerance);
    summary_.emplace(*bulk_);  // new weights are no flow
    at_rest_ = ZoneAtRest(*bulk_, *contact_, UnknownSet(patch_.mesh.unknowns + contact_->tractions()));
    contact_->settle(memory_.committed.displacement);
    rings_ = rings_of(patch_, input_.materials, input_.cracks, subcells_at_crack(input_.fine), std::move(rings_));
}

Eigen::VectorXd ZoneSystem::committed_force(Bulk& bulk, const ContactInterface& contact) const {
    bulk.evaluate(memory_.committed.displacement);
    Eigen::VectorXd force = bulk.internal_force();
    contact.operators().add_force(memory_.committed.traction, force);
    return force;
}

// No stress has changed: what is out of balance on a new jump is what the metal transmitted there. Where stresses have
// changed with functions that are let go, what has come out of balance by that is held as well.
void ZoneSystem::open_new_faces(const EnrichedMesh& before, const Eigen::VectorXd& force) {
    if (std::ranges::equal(before.tips, patch_.mesh.tips, same_place)) {  // more elements, or smaller ones
        memory_.opening.follow(before, patch_.mesh);
        return;
    }
    const Eigen::VectorXd now = committed_force(*bulk_, *contact_);
    if (forgets())
        memory_.opening.hold_changes(before, force, patch_.mesh, now - force_of_joining(*bulk_, before),
                                     bulk_->elements().changed_unknowns());
    else
        memory_.opening.open(before, patch_.mesh, -now);
}

void ZoneSystem::put_aside() { memory_.increments.put_aside(way_to_trial()); }

void ZoneSystem::predict(const Predictor& predictor) {
    if (!predictor.goes_on) trial_ = memory_.committed;
    if (const ZoneUnknowns* earlier = memory_.increments.find(predictor)) {
        trial_.displacement += predictor.factor * earlier->displacement;
        // A pressure may come out negative: its face opens. Cut off at zero it would leave the status to rounding.
        trial_.traction += predictor.factor * earlier->traction;
    }
    largest_move_ = std::numeric_limits<double>::infinity();
    steps_ = 0;
    contact_->begin_increment(predictor.apart);
}

void ZoneSystem::move(const Eigen::VectorXd& displacement, const Eigen::VectorXd& traction) {
    ++steps_;
    trial_.displacement += displacement;
    trial_.traction += traction;
    largest_move_ = displacement.size() > 0 ? displacement.cwiseAbs().maxCoeff() : 0.0;
}

void ZoneSystem::linearise() {
    if (steps_ == 1) memory_.opening.begin(trial_.displacement - memory_.committed.displacement);
    const Eigen::VectorXd faces = force_of_faces(), load = load_beside(faces);
    {
        const Stopwatch watch(constitutive_s_);
        bulk_->evaluate(trial_.displacement, loading_.elastic, input_.slight_flow(steps_));
        soft_jumps_.settle(*bulk_, trial_.displacement, load, held_by(faces));
    }
    const Stopwatch watch(contact_s_);
    jumps_ = contact_->jumps_that_matter(trial_.displacement, trial_.traction, contact_work_);
    // Growth has moved nothing. What overlaps yet is how dual multipliers see a frozen function: new faces shall open.
    if (steps_ > 0 || !memory_.opening.any()) contact_->choose_statuses(trial_.traction, jumps_);
    load_ = load - bulk_->internal_force();
    at_rest_.forget_response();
}

// On all unknowns, N/mm: faces push each other apart and brake each other.
Eigen::VectorXd ZoneSystem::force_of_faces() const {
    Eigen::VectorXd force = Eigen::VectorXd::Zero(patch_.mesh.unknowns);
    contact_->operators().add_force(contact_->awake(trial_.traction), force);
    return force;
}

// Of the outside, the faces, and what holds new ones back.
Eigen::VectorXd ZoneSystem::load_beside(const Eigen::VectorXd& faces) const {
    Eigen::VectorXd load = loading_.load_factor * patch_.unit_load;
    // Factors beyond the end of those given are zero, as where an initial stress comes to equilibrium.
    if (patch_.case_loads.cols() > 0) load += patch_.case_loads.leftCols(loading_.cases.size()) * loading_.cases;
    memory_.opening.hold(loading_.held, load);
    return load - faces;
}

// Once faces have found what they do, the gap of one that bears holds its jump. To give way to the tractions as they
// are would open and close it by turns.
UnknownSet ZoneSystem::held_by(const Eigen::VectorXd& faces) const {
    constexpr int states = 5;
    UnknownSet held(faces.size());
    for (Eigen::Index i = 0; steps_ >= states && i < faces.size(); ++i)
        if (faces[i] != 0.0) held.insert(i);
    return held;
}

void ZoneSystem::add_response(const Eigen::VectorXd& load) {
    load_ += load.head(load_.size());
    at_rest_.respond(load);
}

Eigen::VectorXd ZoneSystem::contact_right_hand_side() const {
    Eigen::VectorXd right = contact_->right_hand_side(trial_.traction, jumps_);
    if (at_rest_.response().size() > 0) right += at_rest_.response().tail(right.size());
    return right;
}

void ZoneSystem::rest(Resting resting, UnknownSet inside) {
    bulk_->rest(resting.elements, memory_.committed.displacement);
    contact_->resting().rest(std::move(resting.multipliers), memory_.committed.traction);
    at_rest_ = ZoneAtRest(*bulk_, *contact_, std::move(inside));
}

Restless ZoneSystem::follow(const Eigen::VectorXd& moved) {
    const Stopwatch watch(constitutive_s_);
    const Eigen::VectorXd &u = bulk_->resting().displacement(), &traction = contact_->resting().traction();
    for (Eigen::Index i = 0; i < u.size(); ++i)
        if (at_rest_.inside().contains(i)) trial_.displacement[i] = u[i] + moved[i];
    for (Eigen::Index k = 0; k < traction.size(); ++k)
        if (at_rest_.inside().contains(u.size() + k)) trial_.traction[k] = traction[k] + moved[u.size() + k];
    return {bulk_->would_yield(trial_.displacement),
            contact_->would_change(trial_.displacement, trial_.traction, jumps_)};
}

void ZoneSystem::wake_all_but(Resting still, UnknownSet inside) {
    const ElementSet rested = bulk_->resting().elements();
    bulk_->wake_all_but(still.elements);
    for (const int e : rested.members())
        if (!still.elements.contains(e)) summary_->follow(*bulk_, e);
    contact_->resting().wake_all_but(std::move(still.multipliers));
    at_rest_ = ZoneAtRest(*bulk_, *contact_, std::move(inside));
}

Eigen::VectorXd ZoneSystem::moved_since_rest() const {
    Eigen::VectorXd moved(patch_.mesh.unknowns + contact_->tractions());
    moved << trial_.displacement - bulk_->resting().displacement(), trial_.traction - contact_->resting().traction();
    return moved;
}

coupling::StepReport ZoneSystem::commit(const coupling::Commit& what) {
    // Where a face is open the solver has left the rounding of a pressure: it would count as contact.
    contact_->clean(trial_.traction);
    const ZoneUnknowns move = way_to_trial();
    const double dissipated = summary_->dissipation();
    coupling::StepReport report;
    report.energy = spent_at_faces(what.releases);
    take_over_trial(what);
    add_energies(move, report.energy);
    memory_.increments.push(move);
    report_on({.patch = patch_,
               .bulk = *bulk_,
               .summary = *summary_,
               .contact = *contact_,
               .frozen = memory_.frozen,
               .displacement = memory_.committed.displacement,
               .traction = memory_.committed.traction,
               .rounding = 1e-12 * input_.materials.largest_plane_modulus()},
              rings_, input_.cracks.size(), what, report);
    report.dissipation = summary_->dissipation() - dissipated;
    put_counts(report);
    return report;
}

// On the way to the trial state. A release holds the loads, which do their work by no trapezoid.
coupling::EnergyReport ZoneSystem::spent_at_faces(bool releases) const {
    const ZoneUnknowns& before = memory_.committed;
    coupling::EnergyReport energy;
    energy.friction = contact_->dissipated(before.traction, trial_.traction, jumps_);
    if (!releases) energy.contact = contact_->operators().work_by_trapezoid(before.at_faces(), trial_.at_faces());
    return energy;
}

void ZoneSystem::take_over_trial(const coupling::Commit& what) {
    const bool begins = bulk_->history().half_cycle_ended();
    memory_.committed = trial_;
    bulk_->commit(what.reversal, !what.releases);
    contact_->commit(memory_.committed.displacement, what.next_over_this);
    if (what.bends || what.releases) contact_->forget_approach();
    if (what.reversal && !what.releases) contact_->note_half_cycle();
    summary_->update(*bulk_, begins);
}

void ZoneSystem::add_energies(const ZoneUnknowns& move, coupling::EnergyReport& energy) {
    energy.stored = summary_->stored_energy() + at_rest_.energy(moved_since_rest());
    energy.released = memory_.opening.release(move.displacement, loading_.held);
    energy.load_path = patch_.unit_load.dot(move.displacement);
    if (patch_.case_loads.cols() > 0) energy.case_paths = patch_.case_loads.transpose() * move.displacement;
}

void ZoneSystem::put_counts(coupling::StepReport& report) const {
    report.points = bulk_->history().points();
    report.unknowns = patch_.mesh.unknowns + contact_->tractions();
    report.multipliers = contact_->tractions();
    report.work = work();
    report.work.history_values = bulk_->history().values_beyond_stress();
    report.work.interface_elements = contact_->operators().interface_elements();
    report.constitutive_s = constitutive_s_;
    report.contact_s = contact_s_;
}

coupling::ZoneState ZoneSystem::state() const {
    coupling::ZoneState state = state_of(*bulk_);
    state.frozen_tips = memory_.frozen.tips();
    return state;
}

coupling::ZoneSnapshot ZoneSystem::snapshot() const {
    coupling::ZoneSnapshot out;
    bulk_->remember(out);
    out.flow.assign(out.element.size(), 0.0);
    write(memory_, *contact_, out);
    return out;
}

void ZoneSystem::restore(const coupling::Patch& patch, const coupling::ZoneSnapshot& snapshot) {
    memory_.frozen = FrozenTips(snapshot.frozen_tips);
    contact_ = make_contact(patch, memory_.frozen);
    take_up(memory_, *contact_, patch.mesh, snapshot);
    const coupling::WorkCounts so_far = bulk_ ? bulk_->counts() : coupling::WorkCounts();
    bulk_ = std::make_unique<Bulk>(patch.mesh, input_.materials, make_laws(), input_.rule(), snapshot);
    bulk_->count_on_from(so_far);
    rings_.clear();
    begin_with(patch);
    contact_->hold_slips(settled_slips_in(snapshot));
}

}  // namespace stria::fine
