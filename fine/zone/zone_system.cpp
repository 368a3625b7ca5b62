#include "fine/zone/zone_system.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "common/index.hpp"
#include "common/stopwatch.hpp"
#include "fine/bulk/bulk_report.hpp"

namespace stria::fine {

ZoneSystem::ZoneSystem(const Case& input)
    : input_(input), elastic_(elasticity_of(input.material, input.model.plane)),
      increments_(remembered_increments(input.load.steps)) {}

void ZoneSystem::set_patch(const coupling::Patch& patch) {
    if (bulk_) wake_all();
    const std::unique_ptr<Bulk> old = std::move(bulk_);
    const std::unique_ptr<ContactInterface> old_contact = std::move(contact_);
    if (old) keep_displacement(patch);
    make_contact(patch);
    carry_unknowns(patch, old_contact.get());
    bulk_ = std::make_unique<Bulk>(patch.mesh, make_law(), elastic_, rule(), old.get(), committed_.displacement);
    const EnrichedMesh before = std::move(patch_.mesh);
    begin_with(patch);
    if (old) open_new_faces(before);
}

std::unique_ptr<MaterialLaw> ZoneSystem::make_law() const {
    return make_material_law(input_.material, input_.model.plane, input_.fine.substeps);
}

IntegrationRule ZoneSystem::rule() const {
    // Of elastic elements around a tip that slides: points without a history, so that there may be many.
    const bool dense = !input_.material.yield_stress && has_friction(input_);
    return {.subcells = input_.fine.subcells,
            .gauss = dense ? 6 : 2,
            .tip_points = dense ? 10 : 4,
            .mean_dilatation = mean_dilatation(input_.material, elastic_)};
}

void ZoneSystem::make_contact(const coupling::Patch& patch) {
    contact_ = std::make_unique<ContactInterface>(patch.mesh, patch.boundary, input_.cracks, input_.fine.subcells,
                                                  elastic_.plane_modulus(), frozen_);
}

void ZoneSystem::begin_with(const coupling::Patch& patch) {
    patch_ = patch;
    trial_ = committed_;
    inside_ = UnknownSet(patch_.mesh.unknowns);
    contact_->settle(committed_.displacement);
    find_tip_stations();
}

// No stress has changed: what is out of balance on a new jump is what the metal transmitted there.
void ZoneSystem::open_new_faces(const EnrichedMesh& before) {
    bulk_->evaluate(committed_.displacement);
    Eigen::VectorXd force = bulk_->internal_force();
    contact_->operators().add_force(committed_.traction, force);
    opening_.open(before, patch_.mesh, -force);
}

void ZoneSystem::keep_displacement(const coupling::Patch& next) {
    for (int t = 0; t < std::ssize(patch_.mesh.tips); ++t) {
        const Tip& tip = patch_.mesh.tips[at(t)];
        const auto same = [&](const Tip& other) { return same_place(tip, other); };
        if (std::ranges::none_of(next.mesh.tips, same) && std::ranges::none_of(next.mesh.left_tips, same))
            frozen_.freeze(patch_.mesh, t, committed_.displacement);
    }
    frozen_.keep_closed(patch_.mesh, next.mesh,
                        carry_over(patch_.mesh, committed_.displacement, next.mesh, next.displacement));
}

void ZoneSystem::find_tip_stations() {
    tip_stations_.assign(patch_.mesh.tips.size(), {});
    for (std::size_t t = 0; t < tip_stations_.size(); ++t) {
        const Tip& tip = patch_.mesh.tips[t];
        const CrackSection& crack = input_.cracks[at(tip.crack)];
        if (!crack.contact) continue;
        tip_stations_[t] = face_stations_about(patch_.mesh, tip, input_.fine.subcells, 4);
        std::erase_if(tip_stations_[t], [&](const FaceStation& station) { return station.s < crack.notch; });
    }
}

void ZoneSystem::carry_unknowns(const coupling::Patch& patch, const ContactInterface* old_contact) {
    Unknowns next{patch.displacement, Eigen::VectorXd::Zero(contact_->tractions())};
    if (old_contact != nullptr) {
        next.displacement = carry_over(patch_.mesh, committed_.displacement, patch.mesh, next.displacement);
        for (int k = 0; k < contact_->multipliers(); ++k) {
            const auto same = [&](const FaceOperators::Key& key) {
                const auto& own = contact_->operators().keys()[at(k)];
                return key.is_at(own.crack, own.x);
            };
            const auto found = std::ranges::find_if(old_contact->operators().keys(), same);
            if (found == old_contact->operators().keys().end()) continue;
            const int old = static_cast<int>(found - old_contact->operators().keys().begin());
            next.traction[k] = committed_.traction[old];
            if (contact_->shear_of(k) >= 0)
                next.traction[contact_->shear_of(k)] = committed_.traction[old_contact->shear_of(old)];
        }
    }
    committed_ = std::move(next);
    increments_.clear();
}

void ZoneSystem::predict(const Predictor& predictor) {
    trial_ = committed_;
    if (const Unknowns* earlier = increments_.find(predictor)) {
        trial_.displacement += predictor.factor * earlier->displacement;
        // A pressure may come out negative: its face opens. Cut off at zero it would leave the status to rounding.
        trial_.traction += predictor.factor * earlier->traction;
    }
    largest_move_ = std::numeric_limits<double>::infinity();
    contact_->begin_increment();
}

void ZoneSystem::move(const Eigen::VectorXd& displacement, const Eigen::VectorXd& traction) {
    trial_.displacement += displacement;
    trial_.traction += traction;
    largest_move_ = displacement.size() > 0 ? displacement.cwiseAbs().maxCoeff() : 0.0;
}

void ZoneSystem::set_boundary(const Eigen::VectorXd& displacement) {
    for (std::size_t k = 0; k < patch_.boundary.size(); ++k)
        trial_.displacement[patch_.boundary[k]] = displacement[static_cast<Eigen::Index>(k)];
}

void ZoneSystem::linearise() {
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
    opening_.hold(held_, load_);
    response_.resize(0);
}

void ZoneSystem::add_response(const Eigen::VectorXd& load) {
    load_ += load;
    response_ = load;
}

ElementSet ZoneSystem::may_rest() const {
    ElementSet may = bulk_->may_rest();
    const auto bears_load = [&](int unknown) { return patch_.unit_load[unknown] != 0.0; };
    for (int e = 0; e < may.size(); ++e) {
        if (std::ranges::any_of(bulk_->elements().op(e).unknowns, bears_load)) may.erase(e);
        for (std::size_t t = 0; t < patch_.ahead.size(); ++t)
            if (bulk_->elements().is_near(e, patch_.mesh.tips[t].position, patch_.ahead[t])) may.erase(e);
    }
    return may;
}

void ZoneSystem::rest(const ElementSet& elements, const UnknownSet& inside) {
    bulk_->rest(elements, committed_.displacement);
    set_inside(inside);
}

std::vector<int> ZoneSystem::would_yield(const Eigen::VectorXd& displacement) {
    const Stopwatch watch(constitutive_s_);
    for (Eigen::Index i = 0; i < trial_.displacement.size(); ++i)
        if (inside_.contains(i)) trial_.displacement[i] = displacement[i];
    return bulk_->would_yield(trial_.displacement);
}

void ZoneSystem::wake_all_but(const ElementSet& still, const UnknownSet& inside) {
    bulk_->wake_all_but(still);
    set_inside(inside);
}

void ZoneSystem::wake_all() { wake_all_but(ElementSet(bulk_->elements().count()), UnknownSet(patch_.mesh.unknowns)); }

void ZoneSystem::set_inside(const UnknownSet& inside) {
    inside_ = inside;
    force_scale_at_rest_ = bulk_->rest_load().lpNorm<Eigen::Infinity>();
}

coupling::PatchResponse ZoneSystem::measure() {
    coupling::PatchResponse response;
    UnknownSet followed = inside_;  // by the structure, or by the others
    for (const int unknown : patch_.boundary) followed.insert(unknown);
    response.interior_force = force_scale_at_rest_;
    const Eigen::VectorXd scale =
        response_.size() > 0 ? bulk_->force_scale() + response_.cwiseAbs() : bulk_->force_scale();
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
    for (const Tip& tip : patch_.mesh.tips) response.digest.contact_reach.push_back(contact_->reach_behind(tip));
    for (std::size_t t = 0; t < patch_.ahead.size(); ++t)
        response.digest.force_ahead.push_back(force_ahead(*bulk_, patch_.mesh.tips[t], patch_.ahead[t]));
    return response;
}

coupling::StepReport ZoneSystem::commit(bool reversal) {
    // Where a face is open the solver has left the rounding of a pressure: it would count as contact.
    contact_->clean(trial_.traction);
    const Unknowns move{trial_.displacement - committed_.displacement, trial_.traction - committed_.traction};
    const double friction = contact_->dissipated(committed_.traction, trial_.traction, jumps_);
    committed_ = trial_;
    bulk_->commit(reversal);
    contact_->commit(committed_.displacement);
    coupling::StepReport report;
    report.energy = {.stored = fine::stored_energy(*bulk_),
                     .released = opening_.release(move.displacement, held_),
                     .friction = friction,
                     .load_path = patch_.unit_load.dot(move.displacement)};
    increments_.push(move);
    report_tips(report);
    report_rings(report);
    report_faces(report);
    report.dissipation = fine::dissipation(*bulk_);
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

// Of a station that is not one of the contact's own, which hold what is fixed themselves.
Vec2 ZoneSystem::jump(const FaceStation& station) const {
    return station.jump(committed_.displacement) + frozen_.jump(station.crack, station.x);
}

void ZoneSystem::report_tips(coupling::StepReport& report) const {
    const auto tips = patch_.mesh.tips.size();
    report.tips.resize(tips);
    const std::vector<PlasticExtent> extents = plastic_extents(*bulk_);
    for (std::size_t t = 0; t < tips; ++t) {
        const Tip& tip = patch_.mesh.tips[t];
        report.tips[t].CTOD = opening_at_intercept(
            patch_.mesh, tip, [&](const FaceStation& station) { return jump(station).dot(station.normal); });
        report.tips[t].plastic_zone = extents[t].zone;
        report.tips[t].plastic_zone_axis = extents[t].axis;
        report.tips[t].plastic_reach = extents[t].ever;
    }
}

void ZoneSystem::report_rings(coupling::StepReport& report) const {
    for (int t = 0; t < std::ssize(patch_.mesh.tips); ++t) {
        const Tip& tip = patch_.mesh.tips[at(t)];
        std::vector<Annulus> rings;
        std::vector<int> numbers;
        for (const coupling::Ring& ring : patch_.rings) {
            if (ring.tip != t) continue;
            rings.push_back({ring.inner_radius, ring.outer_radius});
            numbers.push_back(ring.number);
        }
        if (rings.empty()) continue;
        RingSums sums(patch_.mesh, tip, elastic_, rings);
        add_to(sums, *bulk_);
        for (const FaceStation& station : tip_stations_[at(t)]) {
            const auto [pressure, shear, slides] = contact_->traction_at(station, committed_.traction);
            if (pressure <= 0.0) continue;
            const Eigen::VectorXd& u = committed_.displacement;
            sums.add_faces(station, {pressure, shear, station.opening_slope(u), station.slip_slope(u)});
        }
        for (std::size_t k = 0; k < rings.size(); ++k) {
            const DomainIntegral& sum = sums.values()[k];
            report.rings.push_back({t, numbers[k], sum.J, sum.interaction_I, sum.interaction_II, sum.interaction_T});
        }
    }
}

void ZoneSystem::report_faces(coupling::StepReport& report) const {
    const auto cracks = input_.cracks.size();
    report.contact_length.assign(cracks, 0.0);
    report.mouth_opening.assign(cracks, std::numeric_limits<double>::quiet_NaN());
    for (const FaceStation& station : contact_->operators().stations()) {
        coupling::FaceSample sample;
        sample.crack = station.crack;
        sample.s = station.s;
        sample.x = station.x.x();
        sample.y = station.x.y();
        sample.opening = station.opening(committed_.displacement);
        sample.slip = station.slip(committed_.displacement);
        const auto [pressure, shear, slides] = contact_->traction_at(station, committed_.traction);
        sample.pressure = pressure;
        sample.shear = shear;
        sample.status = pressure > 0.0 ? (slides ? 2 : 1) : 0;
        if (sample.status != 0) report.contact_length[at(station.crack)] += station.weight;
        report.faces.push_back(sample);
    }
    for (std::size_t crack = 0; crack < cracks; ++crack) {
        for (const CrackPiece& piece : patch_.mesh.pieces) {
            if (piece.crack != static_cast<int>(crack)) continue;
            const FaceStation mouth = face_station_at(patch_.mesh, piece.crack, piece.s.front());
            if (piece.entry >= 0.0) report.mouth_opening[crack] = jump(mouth).dot(mouth.normal);
            break;
        }
    }
}

coupling::ZoneState ZoneSystem::state() const { return state_of(*bulk_); }

}  // namespace stria::fine
