#include "coarse/analysis/nominal_body.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "coarse/load/load_scale.hpp"
#include "coarse/structure/structure_chain.hpp"
#include "common/enrichment/same_functions.hpp"
#include "common/stopwatch.hpp"

namespace stria::coarse {

std::unique_ptr<Structure> NominalBody::solve(const Scene& scene, const ElementSet& zone, StructureFactors& shared) {
    own_ = nominal_scene(scene);
    const Scene& body = own_ ? *own_ : scene;
    const bool far_known = shared.far && shared.far->is_of(still_.far, nullptr);
    // The structure takes rings of its own scene alone.
    NominalSolution found =
        solve_whole(body, far_known, own_ ? ElementSet(body.mesh->elements.size(), true) : zone, shared);
    tips_ = std::move(found.tips);
    rings_ = own_ ? std::vector<RingForms>() : std::move(found.rings);
    unit_displacement_ = stria::coarse::unit_displacement(found.fields);
    find_largest_K(scene);
    if (first_length_ == 0.0 && !tips_.empty()) first_length_ = tips_.front().a;
    displacement_ = {};
    if (!far_known)
        displacement_ = own_ ? carry_over(own_->enriched, found.fields.unit, scene.enriched,
                                          Eigen::VectorXd::Zero(scene.enriched.unknowns))
                             : found.fields.unit;
    return own_ ? nullptr : std::move(found.structure);
}

// Beyond the far body, which it shares with the structure, it condenses what is near or in the zone.
NominalSolution NominalBody::solve_whole(const Scene& scene, bool far_known, const ElementSet& for_K,
                                         StructureFactors& shared) {
    note_if_large(scene, "elastic solution of the whole body", note_);
    auto core = std::exchange(shared.core, nullptr);
    shared.behind = std::move(behind_);
    auto body = timed_condense(scene, ElementSet(scene.mesh->elements.size()), still_, shared, effort_);
    behind_ = std::exchange(shared.behind, nullptr);
    shared.core = std::move(core);
    return far_known ? solve_nominal_near(std::move(body), for_K) : solve_nominal(std::move(body));
}

// Supports hold it without moving it: what they impose is a load of the other part.
std::vector<TipResult> NominalBody::K_of_faces(const Scene& scene, const LoadFactors& loads, FaceTractions tractions,
                                               StructureFactors shared) const {
    const std::unique_ptr<const Scene> own = nominal_scene(scene);
    const Scene& body = own ? *own : scene;
    const ElementSet no_zone(scene.mesh->elements.size());
    shared.core = nullptr;
    shared.behind = behind_;
    Eigen::VectorXd u = Eigen::VectorXd::Zero(body.enriched.unknowns);
    timed_condense(body, no_zone, still_, shared, effort_)->expand_near({}, loads, 1.0, u);
    leave_out_wedges(tractions, body.enriched, u);
    Scene pressed = body;
    pressed.unit_force = forces_of(tractions, body);
    pressed.case_forces.clear();
    for (PrescribedUnknown& support : pressed.prescribed) support = {.unknown = support.unknown, .value = 0.0};
    const std::unique_ptr<Structure> bears = timed_condense(pressed, no_zone, still_, shared, effort_);
    u.setZero();
    bears->expand_near({}, 1.0, 0.0, u);
    return nominal_K(StructureRings(bears->elements()), u, &tractions);
}

void NominalBody::find_largest_K(const Scene& scene) {
    largest_K_ = stria::coarse::largest_K(scene.input, response(scene), grown());
}

void NominalBody::go_on_from(const AnalysisState& state, const Scene& scene, bool is_other) {
    if (is_other) {
        displacement_ = {};
        rings_.clear();
    }
    still_ = state.still_of_nominal;
    tips_ = state.nominal;
    unit_displacement_ = state.unit_displacement;
    if (!tips_.empty()) find_largest_K(scene);
}

void NominalBody::write(AnalysisState& state) const {
    state.still_of_nominal = still_;
    state.nominal = tips_;
    state.unit_displacement = unit_displacement_;
}

std::vector<RingForms> NominalBody::take_rings(const ElementSet& in_zone) {
    std::vector<RingForms> rings = std::exchange(rings_, {});
    const bool serve =
        std::ranges::all_of(rings, [&](const RingForms& of_tip) { return of_tip.serve_beside(in_zone); });
    return serve ? std::move(rings) : std::vector<RingForms>();
}

void NominalBody::stand_on(const StillElements& still, bool apart) {
    if (!apart || !stands_on(still)) still_ = still;
}

void NominalBody::keep_behind(const Scene& from, const Scene& to) {
    if (has_behind() && same_functions(nominal_functions(from), nominal_functions(to), still_.behind)) return;
    still_.behind = {};
    behind_.reset();
}

void NominalBody::turn_to_finer(std::size_t elements) {
    for (ElementSet* set : {&still_.far, &still_.middle, &still_.behind})
        if (set->size() > 0) set->widen(elements);
    rings_.clear();
}

void NominalBody::carry_over_to(const EnrichedMesh& from, const EnrichedMesh& to) {
    if (displacement_.size() > 0)
        displacement_ = carry_over(from, displacement_, to, Eigen::VectorXd::Zero(to.unknowns));
    rings_.clear();
}

std::unique_ptr<Structure> timed_condense(const Scene& scene, const ElementSet& in_zone, const StillElements& still,
                                          StructureFactors& factors, CoarseEffort& effort) {
    const Stopwatch watch(effort.condensing_s);
    return condense(scene, in_zone, still, factors, effort.work);
}

void note_if_large(const Scene& scene, const char* phase, const Note& note) {
    if (scene.mesh->elements.size() > 100'000)
        note(fmt::format("{} ({} elements) ...", phase, scene.mesh->elements.size()));
}

}  // namespace stria::coarse
