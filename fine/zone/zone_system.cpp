#include "fine/zone/zone_system.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "common/index.hpp"
#include "common/stopwatch.hpp"
#include "fine/bulk/bulk_report.hpp"
#include "fine/zone/zone_report.hpp"

namespace stria::fine {

ZoneSystem::ZoneSystem(const ZoneSections& input)
    : input_(input), memory_{.increments =
                                 IncrementMemory<ZoneUnknowns>(remembered_increments(input.steps_per_cycle))} {}

void ZoneSystem::set_patch(const coupling::Patch& patch) {
    if (bulk_) wake_all();
    const std::unique_ptr<Bulk> old = std::move(bulk_);
    const std::unique_ptr<ContactInterface> old_contact = std::move(contact_);
    if (old && patch.part_of.empty()) keep_displacement(memory_, patch_.mesh, patch);
    make_contact(patch);
    carry_unknowns(memory_, patch_.mesh, old_contact.get(), patch, *contact_);
    if (memory_.committed.displacement.isZero(0.0)) contact_->begin_touching();
    bulk_ = std::make_unique<Bulk>(patch.mesh, input_.materials, make_laws(), rule(), old.get(),
                                   memory_.committed.displacement);
    const EnrichedMesh before = std::move(patch_.mesh);
    begin_with(patch);
    if (old) open_new_faces(before);
}

MaterialLaws ZoneSystem::make_laws() const { return make_material_laws(input_.materials, input_.fine.substeps); }

IntegrationRule ZoneSystem::rule() const {
    // Of elastic elements around a tip that slides: points without a history, so that there may be many.
    const bool dense = !input_.materials.may_yield() && has_friction(input_.cracks);
    return {.subcells = subcells_at_crack(input_.fine),
            .far_subcells = subcells_elsewhere(input_.fine),
            .singular_gauss = dense ? 6 : 2,
            .tip_points = dense ? 10 : 4};
}

void ZoneSystem::make_contact(const coupling::Patch& patch) {
    std::vector<int> boundary = patch.boundary;
    std::ranges::sort(boundary);
    contact_ = std::make_unique<ContactInterface>(patch.mesh, boundary, input_.cracks, subcells_at_crack(input_.fine),
                                                  input_.materials.largest_plane_modulus(), memory_.frozen);
}

void ZoneSystem::begin_with(const coupling::Patch& patch) {
    patch_ = patch;
    trial_ = memory_.committed;
    dissipated_ = fine::dissipation(*bulk_);  // new weights are no flow
    at_rest_.inside = UnknownSet(patch_.mesh.unknowns);
    contact_->settle(memory_.committed.displacement);
    rings_ = rings_of(patch_, input_.materials, input_.cracks, subcells_at_crack(input_.fine));
}

// No stress has changed: what is out of balance on a new jump is what the metal transmitted there.
void ZoneSystem::open_new_faces(const EnrichedMesh& before) {
    if (std::ranges::equal(before.tips, patch_.mesh.tips, same_place)) {  // more elements, or smaller ones
        memory_.opening.follow(before, patch_.mesh);
        return;
    }
    bulk_->evaluate(memory_.committed.displacement);
    Eigen::VectorXd force = bulk_->internal_force();
    contact_->operators().add_force(memory_.committed.traction, force);
    memory_.opening.open(before, patch_.mesh, -force);
}

void ZoneSystem::put_aside() {
    memory_.increments.put_aside(
        {trial_.displacement - memory_.committed.displacement, trial_.traction - memory_.committed.traction});
}

void ZoneSystem::predict(const Predictor& predictor) {
    if (!predictor.goes_on) trial_ = memory_.committed;
    if (const ZoneUnknowns* earlier = memory_.increments.find(predictor)) {
        trial_.displacement += predictor.factor * earlier->displacement;
        // A pressure may come out negative: its face opens. Cut off at zero it would leave the status to rounding.
        trial_.traction += predictor.factor * earlier->traction;
    }
    largest_move_ = std::numeric_limits<double>::infinity();
    steps_ = 0;
    contact_->begin_increment();
}

void ZoneSystem::move(const Eigen::VectorXd& displacement, const Eigen::VectorXd& traction) {
    ++steps_;
    trial_.displacement += displacement;
    trial_.traction += traction;
    largest_move_ = displacement.size() > 0 ? displacement.cwiseAbs().maxCoeff() : 0.0;
}

void ZoneSystem::set_boundary(const Eigen::VectorXd& displacement) {
    for (std::size_t k = 0; k < patch_.boundary.size(); ++k)
        trial_.displacement[patch_.boundary[k]] = displacement[static_cast<Eigen::Index>(k)];
}

void ZoneSystem::linearise() {
    if (steps_ == 1) memory_.opening.begin(trial_.displacement - memory_.committed.displacement);
    {
        const Stopwatch watch(constitutive_s_);
        bulk_->evaluate(trial_.displacement);
    }
    const Stopwatch watch(contact_s_);
    jumps_ = contact_->jumps_that_matter(trial_.displacement, trial_.traction, contact_work_);
    contact_->choose_statuses(trial_.traction, jumps_);
    Eigen::VectorXd force = bulk_->internal_force();
    contact_->operators().add_force(trial_.traction, force);
    load_ = load_factor_ * patch_.unit_load - force;
    if (patch_.case_loads.cols() > 0) load_ += patch_.case_loads * cases_;
    memory_.opening.hold(held_, load_);
    at_rest_.response.resize(0);
}

void ZoneSystem::add_response(const Eigen::VectorXd& load) {
    load_ += load;
    at_rest_.response = load;
}

ElementSet ZoneSystem::may_rest() const {
    ElementSet may = bulk_->may_rest();
    const Eigen::VectorXd held = memory_.opening.held(patch_.mesh.unknowns);
    const auto bears_load = [&](int unknown) {
        return patch_.unit_load[unknown] != 0.0 || held[unknown] != 0.0 ||
               (patch_.case_loads.cols() > 0 && !patch_.case_loads.row(unknown).isZero(0.0));
    };
    for (int e = 0; e < may.size(); ++e) {
        if (std::ranges::any_of(bulk_->elements().op(e).unknowns, bears_load)) may.erase(e);
        for (std::size_t t = 0; t < patch_.ahead.size(); ++t)
            if (bulk_->elements().is_near(e, patch_.mesh.tips[t].position, patch_.ahead[t])) may.erase(e);
    }
    return may;
}

void ZoneSystem::rest(const ElementSet& elements, const UnknownSet& inside) {
    bulk_->rest(elements, memory_.committed.displacement);
    set_inside(inside);
}

std::vector<int> ZoneSystem::would_yield(const Eigen::VectorXd& displacement) {
    const Stopwatch watch(constitutive_s_);
    for (Eigen::Index i = 0; i < trial_.displacement.size(); ++i)
        if (at_rest_.inside.contains(i)) trial_.displacement[i] = displacement[i];
    return bulk_->would_yield(trial_.displacement);
}

void ZoneSystem::wake_all_but(const ElementSet& still, const UnknownSet& inside) {
    bulk_->wake_all_but(still);
    set_inside(inside);
}

void ZoneSystem::wake_all() { wake_all_but(ElementSet(bulk_->elements().count()), UnknownSet(patch_.mesh.unknowns)); }

void ZoneSystem::set_inside(const UnknownSet& inside) {
    at_rest_.inside = inside;
    at_rest_.force_scale = bulk_->rest_load().lpNorm<Eigen::Infinity>();
}

coupling::PatchResponse ZoneSystem::measure() {
    coupling::PatchResponse response;
    UnknownSet followed = at_rest_.inside;  // by the structure, or by the others
    for (const int unknown : patch_.boundary) followed.insert(unknown);
    response.interior_force = at_rest_.force_scale;
    const Eigen::VectorXd scale =
        at_rest_.response.size() > 0 ? bulk_->force_scale() + at_rest_.response.cwiseAbs() : bulk_->force_scale();
    for (int i = 0; i < patch_.mesh.unknowns; ++i) {
        response.interior_force = std::max(response.interior_force, scale[i]);
        if (!followed.contains(i))
            response.interior_residual = std::max(response.interior_residual, std::abs(load_[i]));
    }
    response.contact_residual = contact_->residual(trial_.traction, jumps_);
    response.interior_correction = largest_move_;
    response.interior_displacement = trial_.displacement.cwiseAbs().maxCoeff();
    response.digest.yielding_points = bulk_->history().yielding_points();
    response.digest.largest_plastic_increment = bulk_->history().largest_plastic_increment();
    for (const FaceStatus status : contact_->statuses())
        response.digest.status.push_back(static_cast<std::int8_t>(status));
    response.digest.multiplier.assign(trial_.traction.begin(), trial_.traction.begin() + contact_->multipliers());
    response.digest.status_changes = contact_->status_changes();
    for (std::size_t t = 0; t < patch_.contact_at.size(); ++t) {
        std::vector<double>& contact = response.digest.contact.emplace_back();
        for (const double distance : patch_.contact_at[t])
            contact.push_back(
                contact_->contact_behind(patch_.mesh.tips[t], distance, trial_.traction, jumps_, trial_.displacement));
    }
    for (std::size_t t = 0; t < patch_.opening_at.size(); ++t)
        response.digest.opening.push_back(opening_behind(patch_, memory_.frozen, trial_.displacement, t));
    for (std::size_t t = 0; t < patch_.ahead.size(); ++t)
        response.digest.force_ahead.push_back(force_ahead(*bulk_, patch_.mesh.tips[t], patch_.ahead[t]));
    response.digest.slides = find_sliding();
    return response;
}

std::vector<std::vector<std::int8_t>> ZoneSystem::find_sliding() const {
    constexpr double rounding = 1e-8;  // of a displacement
    const double smallest = rounding * std::max(trial_.displacement.lpNorm<Eigen::Infinity>(),
                                                memory_.committed.displacement.lpNorm<Eigen::Infinity>());
    std::vector<std::vector<std::int8_t>> sliding(patch_.slip_at.size());
    for (std::size_t t = 0; t < sliding.size(); ++t)
        for (const double distance : patch_.slip_at[t])
            sliding[t].push_back(contact_->slides_behind(patch_.mesh.tips[t], distance, jumps_, smallest) ? 1 : 0);
    return sliding;
}

coupling::StepReport ZoneSystem::commit(const coupling::Commit& what) {
    // Where a face is open the solver has left the rounding of a pressure: it would count as contact.
    contact_->clean(trial_.traction);
    const ZoneUnknowns move{trial_.displacement - memory_.committed.displacement,
                            trial_.traction - memory_.committed.traction};
    const double friction = contact_->dissipated(memory_.committed.traction, trial_.traction, jumps_);
    memory_.committed = trial_;
    bulk_->commit(what.reversal, !memory_.opening.any());
    contact_->commit(memory_.committed.displacement);
    coupling::StepReport report;
    report.energy = {.stored = what.brief ? 0.0 : fine::stored_energy(*bulk_),
                     .released = memory_.opening.release(move.displacement, held_),
                     .friction = friction,
                     .load_path = patch_.unit_load.dot(move.displacement)};
    if (patch_.case_loads.cols() > 0) report.energy.case_paths = patch_.case_loads.transpose() * move.displacement;
    memory_.increments.push(move);
    report_on(report, what.brief);
    const double before = std::exchange(dissipated_, fine::dissipation(*bulk_));
    report.dissipation = dissipated_ - before;
    report.points = bulk_->history().points();
    report.unknowns = patch_.mesh.unknowns + contact_->tractions();
    report.multipliers = contact_->tractions();
    report.work = bulk_->counts();
    report.work += contact_work_;
    report.work.history_values = bulk_->history().values_beyond_stress();
    report.work.interface_elements = contact_->operators().interface_elements();
    report.constitutive_s = constitutive_s_;
    report.contact_s = contact_s_;
    return report;
}

void ZoneSystem::report_on(coupling::StepReport& report, bool brief) {
    const CommittedZone zone{.patch = patch_,
                             .bulk = *bulk_,
                             .contact = *contact_,
                             .frozen = memory_.frozen,
                             .displacement = memory_.committed.displacement,
                             .traction = memory_.committed.traction};
    report.tips = report_tips(zone);
    report.contact_length = contact_lengths(zone, input_.cracks.size());
    report.mouth_opening = mouth_openings(zone, input_.cracks.size());
    if (brief) return;
    report.rings = report_rings(zone, rings_);
    report.faces = report_faces(zone);
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
    make_contact(patch);
    take_up(memory_, *contact_, snapshot);
    contact_->restore(statuses_of(snapshot));
    const coupling::WorkCounts so_far = bulk_ ? bulk_->counts() : coupling::WorkCounts();
    bulk_ = std::make_unique<Bulk>(patch.mesh, input_.materials, make_laws(), rule(), snapshot);
    bulk_->count_on_from(so_far);
    begin_with(patch);
}

}  // namespace stria::fine
