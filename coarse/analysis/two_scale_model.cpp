#include "coarse/analysis/two_scale_model.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "coarse/advice/limit_load_hint.hpp"
#include "coarse/equilibrium/carried_increments.hpp"
#include "coarse/fracture/K_behind_turns.hpp"
#include "coarse/load/case_histories.hpp"
#include "coarse/load/load_scale.hpp"
#include "coarse/structure/gamma.hpp"
#include "coarse/structure/proportion.hpp"
#include "coarse/zone/zone_selection.hpp"
#include "common/case/case_questions.hpp"
#include "common/integration/moved_field.hpp"
#include "common/stopwatch.hpp"

namespace stria::coarse {

TwoScaleModel::TwoScaleModel(CrackedBody& body, const SolverSection& solver, const ClosureMeter& closure,
                             EquilibriumFactory& factory, CoarseEffort& effort, const Note& note,
                             const AnalysisState* from)
    : body_(body), solver_(solver), closure_(closure), factory_(factory), effort_(effort), note_(note),
      gives_way_at_(gives_way_at(body.scene())), peaks_between_(CaseHistories(body.scene().input).peak_between_ends()),
      guard_(body.scene().materials),
      displacement_(from != nullptr ? from->displacement
                                    : Eigen::VectorXd(Eigen::VectorXd::Zero(body.scene().enriched.unknowns)),
                    effort.work.structure_solves_full) {
    const Stopwatch watch(effort_.setup_s);
    if (from != nullptr) {
        factors_ = {from->load_factor, from->equilibrium.cases};
        largest_force_ = from->largest_force;
    }
    std::optional<coupling::Patch> patch;
    if (body_.has_zone()) patch = patch_of(body_.scene(), body_.in_zone(), displacement_.beside_far());
    couple(patch, from);
    if (from == nullptr) {
        (void)mesh_judge_.look_at(body_.scene(), demands(0));  // it has been said (case_warnings())
        return;
    }
    mesh_judge_ = MeshJudge(from->said_of_mesh);
    equilibrium_->restore(from->equilibrium);
    work_ = from->work;
}

void TwoScaleModel::write(AnalysisState& state) const {
    state.displacement = displacement_.write_beside_far(*equilibrium_);
    state.load_factor = factors_.main;
    state.largest_force = largest_force_;
    state.work = work_;
    state.said_of_mesh = mesh_judge_.said();
    state.equilibrium = equilibrium_->state();
}

void TwoScaleModel::write_dear(AnalysisState& state) const {
    if (body_.has_zone()) state.zone = factory_.zone_snapshot();
    displacement_.write_far(mesh(), state.displacement);
}

void TwoScaleModel::write_kept(AnalysisState& state) const {
    if (is_kept_) state.zone = factory_.kept_zone();
    displacement_.write_kept_far(state.displacement);
}

CoarseEffort TwoScaleModel::effort() const {
    CoarseEffort effort = equilibrium_->effort();
    effort.work += guard_.work();
    return effort;
}

// The zone turns to its patch while the structure is condensed. `begun`: it has begun to turn to this one.
void TwoScaleModel::turn_to(const ElementSet& in_zone, std::optional<coupling::Patch> begun) {
    if (!begun && !in_zone.none())
        factory_.begin_zone(begun.emplace(patch_of(body_.scene(), in_zone, displacement_.beside_far())));
    body_.condense_onto(in_zone);
    couple(begun);
}

// An equilibrium of the present structure and zone, at the committed state. `patch`: of the zone, if there is one.
void TwoScaleModel::couple(const std::optional<coupling::Patch>& patch, const AnalysisState* from) {
    const Structure& structure = body_.structure();
    guard_.turn_to(structure, body_.nominal_displacement());
    rings_.emplace(body_.take_rings());
    const coupling::Patch* zone_patch = patch ? &*patch : nullptr;
    if (equilibrium_) effort_ += equilibrium_->effort();
    equilibrium_ = from != nullptr ? factory_.resume(structure, zone_patch, displacement_.beside_far(), from->zone)
                                   : factory_.make(structure, zone_patch, displacement_.beside_far(), factors_);
    if (patch) restart(work_, structure, displacement_.beside_far());
    note_(fmt::format("{} elements, {} of them in the zone; {} unknowns of the structure, {} on the interface",
                      structure.in_zone().size(), structure.in_zone().count(), structure.unknowns(),
                      structure.gamma().size()));
}

coupling::Patch TwoScaleModel::patch_of(const Scene& scene, const ElementSet& in_zone,
                                        const Eigen::VectorXd& displacement) const {
    coupling::Patch patch = make_patch(scene, in_zone, gamma_of(scene, in_zone), displacement);
    patch.opening_at = closure_.opening_at();
    patch.contact_at = closure_.contact_at();
    patch.ahead = closure_.ahead(scene.enriched);
    patch.slip_at = closure_.slip_at();
    return patch;
}

// The rings are there already: to look for their room once more would cost a pass over the mesh.
MeshDemands TwoScaleModel::demands(int passed) const {
    MeshDemands demands{.K_I =
                            common_K_behind_turns(body_.scene().input, body_.nominal_response(), body_.grown(), passed),
                        .distance = closure_.opening_at()};
    for (int tip = 0; tip < std::ssize(mesh().tips); ++tip)
        demands.radius.push_back(std::ranges::max(rings_->about(tip).rings(), {}, &Annulus::outer).outer);
    return demands;
}

NewtonReport TwoScaleModel::solve(const LoadStep& step, const Waits& waits) {
    NewtonReport report =
        find_equilibrium(*equilibrium_, step.target, step.predictor, {solver_, largest_force_, waits});
    effort_.counts.newton_iterations += report.count();
    if (report.converged && std::abs(loaded_displacement()) > gives_way_at_) {
        report.converged = false;
        report.failure = "the body gives way";
    }
    return report;
}

// Growth and cycles look at extremes only: those of the load, but where other loads have theirs elsewhere. Faces
// without contact are looked at for overlap.
coupling::Commit TwoScaleModel::commit_of(const LoadStep& step) const {
    const Case& input = body_.scene().input;
    const OutputSection& output = input.output;
    const bool at_extreme = step.reversal || step.at_extreme() || step.settles || peaks_between_;
    const bool draws_faces = at_extreme || output.faces == Written::All || output.fields == Written::All;
    const bool reads_rings = draws_faces || output.history == Written::All;
    const bool reads_faces = draws_faces || (reads_rings && !std::ranges::all_of(input.cracks, may_touch));
    return {.reversal = step.reversal,
            .bends = step.bends,
            .next_over_this = step.next_over_this,
            .brief = !reads_rings,
            .no_faces = !reads_faces,
            .releases = step.releases};
}

Increment TwoScaleModel::commit(const LoadStep& step, const NewtonReport& report) {
    const Structure& structure = body_.structure();
    Increment increment;
    increment.step = step;
    increment.newton = report;
    increment.cases_before = factors_.cases;
    factors_ = equilibrium_->factors();
    increment.load_factor = factors_.main;
    largest_force_ = std::max(largest_force_, report.iterations.back().residual.scale);
    increment.machine = equilibrium_->machine_reading();
    const coupling::Commit what = commit_of(step);
    equilibrium_->begin_commit(what);  // the zone commits while the structure looks at its rings
    const RingIntegrals own = what.brief ? rings_->unknown() : structure_integrals();
    increment.zone = equilibrium_->commit(what);
    displacement_.fall_behind();
    increment.equilibrium = equilibrium_.get();
    body_.note_flow(equilibrium_->yielding_points());
    increment.tips =
        fracture_parameters(*rings_, equilibrium_->near_displacement(), own, increment.zone, closure_.opening_at());
    const double error_so_far = work_.error();
    add_increment(work_, structure, equilibrium_->near_displacement(), factors_, increment.machine, increment.zone);
    // Of an elastic body: all that is neither stored nor rubbed off, whatever functions came and went.
    if (step.releases && !body_.scene().materials.may_yield()) work_.released += work_.error() - error_so_far;
    if (step.settles) begin_here(work_);
    increment.work = work_;
    return increment;
}

RingIntegrals TwoScaleModel::structure_integrals() {
    if (answers_in_proportion(body_.structure()))
        return rings_->integrals_in_proportion(body_.structure(), factors_.main, effort_.work.structure_solves_near);
    return rings_->integrals(equilibrium_->near_displacement());
}

void TwoScaleModel::keep_zone() {
    is_kept_ = body_.has_zone();
    if (is_kept_) factory_.keep_zone();
}

// All of the displacement is found: nothing far is left to keep.
ElementSet TwoScaleModel::prepare_extension() {
    ElementSet inside = flowing_in(body_.in_zone(), equilibrium_->yielding_points());
    rollback();
    keep_zone();
    displacement_.catch_up(*equilibrium_, mesh());
    return inside;
}

void TwoScaleModel::extend_zone(const std::vector<int>& yielding, const ElementSet& inside) {
    ++effort_.counts.zone_extensions;
    std::vector<int> joining = yielding;
    if (std::unique_ptr<FinerScene> finer = body_.finer_about_flow(yielding, inside)) {
        for (int e = 0; e < std::ssize(finer->part_of); ++e)
            if (std::ranges::binary_search(yielding, finer->part_of[at(e)])) joining.push_back(e);
        split_elements(std::move(*finer));
    }
    turn_to(with_ring(body_.scene(), body_.in_zone(), joining));
}

// The zone keeps what it remembers while the structure finds its displacement. Beside a zone cracks seldom change what
// is far.
void TwoScaleModel::prepare_growth() {
    const Stopwatch watch(effort_.growth_s);
    keep_zone();
    displacement_.catch_up_beside_far(*equilibrium_, mesh());
    displacement_.keep_far();
}

// What becomes fine because of its functions is so before they change. What else eq. (3) is expected to want joins with
// the longer cracks. The nominal solution, which tells what it does want, is found while the zone turns to them: it
// takes the elements beyond that afterwards.
bool TwoScaleModel::lengthen_cracks(GrownScene grown, int cycle) {
    const Stopwatch watch(effort_.growth_s);
    const EnrichedMesh& after = grown.longer->enriched;
    const bool kept = factory_.keeps_increments() && TipMoves::between(body_.scene().enriched, after).has_value();
    const EquilibriumState known = kept ? equilibrium_->state() : EquilibriumState();
    CrackedBody::Outgrown outgrown;
    if (grown.finer) outgrown = split_elements(std::move(*grown.finer));
    const ElementSet changed = body_.zone_with_changes(*grown.longer);
    const ElementSet expected = body_.zone_expected_about(*grown.longer, changed);
    displacement_.find_far(mesh(), expected);
    if (changed != body_.in_zone()) factory_.extend_zone(patch_of(body_.scene(), changed, displacement_.beside_far()));
    std::unique_ptr<Scene> keeping = body_.keeping_functions(*grown.longer);
    const Scene& next = keeping ? *keeping : *grown.longer;
    Eigen::VectorXd carried = body_.carried_to(next, displacement_.beside_far());
    std::optional<coupling::Patch> patch;
    if (body_.has_zone()) factory_.begin_zone(patch.emplace(patch_of(next, expected, carried)));
    const ElementSet in_zone = body_.zone_about(*grown.longer, expected);
    const Structure& before = outgrown.structure ? *outgrown.structure : body_.structure();
    std::optional<CarriedIncrements> increments;
    if (kept) increments.emplace(before, known, after, gamma_about(in_zone, before));
    outgrown = {};
    displacement_.on_next_mesh() = std::move(carried);
    body_.take(std::move(grown.longer), std::move(keeping));
    displacement_.find_far(mesh(), in_zone);
    if (patch && in_zone != expected) factory_.extend_zone(*std::exchange(patch, std::nullopt));
    turn_to(in_zone, std::move(patch));
    for (const std::string& warning : mesh_judge_.look_at(body_.scene(), demands(cycle))) note_("warning: " + warning);
    displacement_.forget_kept_far();
    if (displacement_.lacks_far_other_than(body_.structure().factors().far.get()))
        displacement_.find_far(mesh());  // lest two far parts stay
    if (increments) equilibrium_->restore(increments->added_to(equilibrium_->state(), body_.structure()));
    return kept;
}

// Each field goes on as it is; what the smaller elements do to equilibrium shows with the release of the new faces.
CrackedBody::Outgrown TwoScaleModel::split_elements(FinerScene finer) {
    const std::vector<int> part_of = finer.part_of;
    ElementSet split(body_.scene().mesh->elements.size());
    for (const int whole : part_of)
        if (whole >= 0) split.insert(whole);
    displacement_.find_far(mesh(), split);
    CrackedBody::Outgrown outgrown = body_.take_finer(std::move(finer), displacement_.on_next_mesh());
    coupling::Patch patch = patch_of(body_.scene(), body_.in_zone(), displacement_.beside_far());
    for (const int e : patch.mesh.element_ids) patch.part_of.push_back(part_of[at(e)]);
    factory_.extend_zone(patch);
    ++effort_.counts.mesh_splits;
    return outgrown;
}

}  // namespace stria::coarse
