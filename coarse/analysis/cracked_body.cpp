#include "coarse/analysis/cracked_body.hpp"

#include <algorithm>
#include <utility>

#include "coarse/fracture/K_behind_turns.hpp"
#include "coarse/load/load_scale.hpp"
#include "coarse/zone/zone_selection.hpp"
#include "common/case/case_questions.hpp"
#include "common/error.hpp"
#include "common/integration/parts_of_elements.hpp"
#include "common/stopwatch.hpp"

namespace stria::coarse {
namespace {

AnalysisState::Polyline polyline_of(const CrackSection& crack) {
    AnalysisState::Polyline line;
    for (const Vec2& point : crack.points) {
        line.x.push_back(point.x());
        line.y.push_back(point.y());
    }
    line.grown_at_start = crack.grown_at_start;
    return line;
}

void lay_along(const AnalysisState::Polyline& line, CrackSection& crack) {
    crack.points.clear();
    for (std::size_t k = 0; k < line.x.size(); ++k) crack.points.emplace_back(line.x[k], line.y.at(k));
    crack.grown_at_start = line.grown_at_start;
}

}  // namespace

CrackedBody::CrackedBody(const Scene& scene, CoarseEffort& effort, const Note& note, const AnalysisState* from)
    : scene_(&scene), effort_(effort), note_(note), nominal_(effort, note) {
    const Stopwatch watch(effort_.setup_s);
    if (!scene.free_motions.text.empty()) note_(scene.free_motions.text);
    if (!scene.enriched.tips.empty() || scene.input.load.control != Control::Load) {
        still_.far = far_elements(scene, ElementSet(scene.mesh->elements.size()));
        nominal_.stand_on(still_, false);
        structure_ = nominal_.solve(scene, {}, factors_);
    }
    nominal_at_start_ = nominal_.response(scene);
    if (from != nullptr) go_on_from(*from);
    in_zone_ = from != nullptr ? from->in_zone : select_zone(scene, nominal_.largest_K());
    if (from == nullptr) settled_ = ElementSet(in_zone_.size());
    if (structure_ && !serves(in_zone_)) structure_.reset();  // two factors at once would take twice the memory
    condense_onto(in_zone_, from != nullptr ? &from->still : nullptr);
}

void CrackedBody::go_on_from(const AnalysisState& state) {
    Case input = scene_->input;
    for (std::size_t k = 0; k < input.cracks.size(); ++k) lay_along(state.cracks.at(k), input.cracks[k]);
    splits_ = state.splits;
    settled_ = state.settled;
    const bool is_other = input != scene_->input || !splits_.empty();
    if (is_other) {
        if (input.growth && input.growth->retain == Retain::All)
            throw CaseError(
                "--resume: growth.retain = \"all\" keeps functions of old tips that a checkpoint does not hold");
        grown_ = std::make_unique<Scene>(make_scene(input, BodyMesh(split_again(scene_->mesh, splits_))));
        scene_ = grown_.get();
    }
    require(std::ssize(state.displacement) == scene_->enriched.unknowns &&
                state.in_zone.size() == std::ssize(scene_->mesh->elements),
            "a state is of the mesh of its scene");
    nominal_.go_on_from(state, *scene_, is_other);
}

void CrackedBody::write(AnalysisState& state) const {
    for (const CrackSection& crack : scene_->input.cracks) state.cracks.push_back(polyline_of(crack));
    state.splits = splits_;
    state.settled = settled_;
    state.in_zone = in_zone_;
    state.still = still_;
    nominal_.write(state);
}

bool CrackedBody::has_zone() const { return !in_zone_.none(); }

std::vector<double> CrackedBody::K_of_closure() const { return coarse::K_of_closure(scene_->input, nominal_at_start_); }

double CrackedBody::load_scale() const {
    return target_of_unit(scene_->input.load, stress_intensities(nominal()), grown());
}

bool CrackedBody::serves(const ElementSet& in_zone) const {
    return structure_ && &structure_->scene() == scene_ && structure_->in_zone() == in_zone;
}

// Everything that a longer crack changes is in the core: the parts below serve again.
void CrackedBody::condense_onto(const ElementSet& in_zone, const StillElements* still) {
    const std::shared_ptr<const CoreFactor> core = factors_.core;
    in_zone_ = in_zone;
    if (!serves(in_zone)) {  // else the nominal one does
        still_ = still != nullptr ? *still : still_elements(*scene_, in_zone, still_);
        note_if_large(*scene_, "condensing the structure onto the zone's boundary", note_);
        if (!nominal_.stands_on(still_)) nominal_.forget_behind();  // it holds the parts that it lies on
        structure_ = timed_condense(*scene_, in_zone, still_, factors_, effort_);
    }
    coupling::WorkCounts& work = effort_.work;
    ++(core && factors_.core == core ? work.structure_factors_kept : work.structure_factorisations);
}

ElementSet CrackedBody::whole_elements() const {
    ElementSet whole = settled_;
    whole |= elements_with_more_than_jumps(*scene_);
    return whole;
}

std::unique_ptr<FinerScene> CrackedBody::finer_about_ends_of(const std::vector<CrackSection>& longer) const {
    if (scene_->input.fine.refine == 1) return nullptr;
    const ElementSet whole = whole_elements();
    const auto disks = [&](Room room) { return disks_about_tips(*scene_, longer, largest_K(), room); };
    return asks_for_more(scene_->mesh, disks(Room::None), whole) ? finer(disks(Room::ToGrow), whole) : nullptr;
}

std::unique_ptr<FinerScene> CrackedBody::finer_about_flow(const std::vector<int>& outside,
                                                          const ElementSet& inside) const {
    if (scene_->input.fine.refine == 1) return nullptr;
    ElementSet flowed = settled_;
    flowed |= inside;
    const ElementSet whole = whole_elements();
    const std::vector<RefinedDisk> disks = disks_about_flow(*scene_, outside, flowed);
    try {
        return asks_for_more(scene_->mesh, disks, whole) ? finer(disks, whole) : nullptr;
    } catch (const CaseError&) {
        return nullptr;  // smaller elements cannot hold a crack as it runs: they join as they are
    }
}

std::unique_ptr<FinerScene> CrackedBody::finer(const std::vector<RefinedDisk>& disks, const ElementSet& whole) const {
    RefinedMesh refined = refine(scene_->mesh, disks, whole);
    Scene scene = make_scene(scene_->input, BodyMesh(std::move(refined.mesh)));
    if (!scene_->enriched.left_tips.empty()) scene = with_functions_left(std::move(scene), scene_->enriched);
    return std::make_unique<FinerScene>(std::move(scene), std::move(refined.splits), std::move(refined.part_of));
}

// At nodes that structure and zone share it is the structure that knows the displacement.
CrackedBody::Outgrown CrackedBody::take_finer(FinerScene finer, Eigen::VectorXd& displacement) {
    const EnrichedMesh &before = scene_->enriched, &now = finer.scene.enriched;
    std::vector<int> of_zone = finer.part_of, of_structure = finer.part_of;
    for (int e = 0; e < std::ssize(finer.part_of); ++e) {
        const int whole = finer.part_of[at(e)];
        if (whole >= 0) (in_zone_.contains(whole) ? of_structure : of_zone)[at(e)] = -1;
    }
    nominal_.keep_behind(*scene_, finer.scene);
    Eigen::VectorXd inside = on_parts(before, displacement, now, of_zone, Eigen::VectorXd::Zero(now.unknowns));
    displacement =
        carry_over(before, displacement, now, on_parts(before, displacement, now, of_structure, std::move(inside)));
    for (ElementSet* set : {&in_zone_, &settled_}) set->widen(now.elements.size());
    for (ElementSet* set : {&still_.far, &still_.middle, &still_.behind})
        if (set->size() > 0) set->widen(now.elements.size());
    nominal_.turn_to_finer(now.elements.size());
    for (int e = 0; e < std::ssize(finer.part_of); ++e)
        if (finer.part_of[at(e)] >= 0) in_zone_.insert(e);  // still_elements() sees that it moves
    splits_.insert(splits_.end(), finer.splits.begin(), finer.splits.end());
    Outgrown outgrown{std::exchange(grown_, std::make_unique<Scene>(std::move(finer.scene))), std::move(structure_)};
    scene_ = grown_.get();
    return outgrown;
}

void CrackedBody::note_flow(const std::vector<std::int32_t>& yielding_points) {
    if (scene_->input.fine.refine > 1)
        settled_ |= flowing_in(in_zone_, yielding_points);  // else nothing will ever be split
}

// Their state is kept.
ElementSet CrackedBody::zone_with_changes(const Scene& longer) const {
    return has_zone() ? with_changed_functions(in_zone_, scene_->enriched, longer) : in_zone_;
}

ElementSet CrackedBody::zone_expected_about(const Scene& longer, ElementSet at_least) const {
    if (has_zone()) at_least |= select_zone(longer, expected_K(largest_K()));
    return at_least;
}

// What was expected holds the disk of any smaller K.
ElementSet CrackedBody::zone_about(const Scene& longer, ElementSet expected) {
    const std::vector<double> at_most = expected_K(largest_K());
    still_ = still_elements(longer, expected, still_);
    choose_behind(longer);
    std::unique_ptr<Structure> body = nominal_.solve(longer, expected, factors_);
    if (!has_zone()) structure_ = std::move(body);
    if (!has_zone() || !std::ranges::equal(largest_K(), at_most, std::ranges::less_equal()))
        expected |= select_zone(longer, largest_K());
    return expected;
}

// Without a zone the nominal body is the structure, which has none.
void CrackedBody::choose_behind(const Scene& longer) {
    nominal_.keep_behind(*scene_, longer);
    nominal_.stand_on(still_, has_zone());
    // To look for what of so few elements may serve for longer costs as much as to factor them.
    const int few = longer.input.fine.refine > 1 ? 700 : 300;
    const auto others = std::ssize(longer.mesh->elements) - still_.far.count() - still_.middle.count();
    if (!has_zone() || nominal_.has_behind() || others < few) return;
    const ElementSet soon = elements_to_split_soon(longer, largest_K(), whole_elements());
    nominal_.put_behind(elements_behind(longer, still_, soon));
}

std::unique_ptr<Scene> CrackedBody::keeping_functions(const Scene& longer) const {
    if (longer.input.growth->retain != Retain::All || !scene_->materials.may_yield()) return nullptr;
    return std::make_unique<Scene>(with_functions_left(longer, scene_->enriched));
}

Eigen::VectorXd CrackedBody::carried_to(const Scene& longer, const Eigen::VectorXd& displacement) const {
    return carry_over(scene_->enriched, displacement, longer.enriched, Eigen::VectorXd::Zero(longer.enriched.unknowns));
}

void CrackedBody::take(std::unique_ptr<Scene> longer, std::unique_ptr<Scene> keeping) {
    if (keeping) {
        nominal_.carry_over_to(longer->enriched, keeping->enriched);
        longer = std::move(keeping);
    }
    if (scene_->input.fine.refine > 1) settled_ |= elements_with_more_than_jumps(*scene_);
    grown_ = std::move(longer);
    scene_ = grown_.get();
}

}  // namespace stria::coarse
