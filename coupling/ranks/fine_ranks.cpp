#include "coupling/ranks/fine_ranks.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <numeric>
#include <ranges>
#include <utility>

#include "common/error.hpp"
#include "common/integration/element_operator.hpp"
#include "common/integration/parts_of_elements.hpp"
#include "coupling/ranks/merged_reports.hpp"
#include "coupling/ranks/zone_partition.hpp"

namespace stria::coupling {
namespace {

std::map<int, int> by_id(const EnrichedMesh& zone, const std::vector<int>& rank_of) {
    std::map<int, int> owners;
    for (std::size_t e = 0; e < rank_of.size(); ++e) owners[zone.element_ids[e]] = rank_of[e];
    return owners;
}

std::map<int, int> owners_in(const ZoneSnapshot& snapshot) {
    std::map<int, int> owners;
    for (std::size_t e = 0; e < snapshot.element.size(); ++e) owners[snapshot.element[e]] = snapshot.rank[e];
    return owners;
}

}  // namespace

FineRanks::FineRanks(std::vector<FineScale*> ranks, std::size_t remembered)
    : scales_(std::move(ranks)), increments_(remembered), reports_(scales_.size()) {}

void FineRanks::set_patch(const Patch& patch) {
    if (given_.empty()) begin_patch(patch);
    const std::vector<Patch> given = std::exchange(given_, {});
    for (std::size_t k = 0; k < given.size(); ++k) scale_of(parts_[k]).set_patch(given[k]);
}

void FineRanks::begin_patch(const Patch& patch) {
    if (owner_.empty()) {
        owner_ = shared_out(patch.mesh);
    } else if (const auto rank_of = share_on(patch.mesh, owner_, patch.part_of)) {
        owner_ = by_id(patch.mesh, *rank_of);
    } else {
        // Who has lost all elements once idles for good: what it knows is no more true.
        owner_ = by_id(patch.mesh, share_out(patch.mesh, static_cast<int>(parts_.size()), patch_.mesh, patch.part_of));
        move_history();
    }
    given_ = take(patch, known_displacement(patch));
    for (std::size_t k = 0; k < given_.size(); ++k) scale_of(parts_[k]).begin_patch(given_[k]);
}

void FineRanks::restore(const Patch& patch, const ZoneSnapshot& snapshot) {
    const bool same_ranks = snapshot.ranks == std::ssize(scales_);
    owner_ = same_ranks ? owners_in(snapshot) : shared_out(patch.mesh);
    restore_parts(take(patch, snapshot.displacement), snapshot);
    for (const Eigen::VectorXd& increment : snapshot.increments | std::views::reverse)
        increments_.push(gather(increment, seams_.kept));
}

std::map<int, int> FineRanks::shared_out(const EnrichedMesh& zone) const {
    return by_id(zone, share_out(zone, static_cast<int>(scales_.size())));
}

// Of the patch that all know. It changes no state, as a checkpoint would not.
void FineRanks::move_history() {
    const ZoneSnapshot all = snapshot();
    restore_parts(take(Patch(patch_), all.displacement), all);
    ++history_moves_;
}

/// Committed displacement of the next patch: what the seams know is theirs.
Eigen::VectorXd FineRanks::known_displacement(const Patch& next) const {
    if (seams_.kept.empty()) return next.displacement;
    Eigen::VectorXd known = patch_.displacement;
    known(seams_.kept) = committed_;
    return carry_over(patch_.mesh, known, next.mesh,
                      on_parts(patch_.mesh, known, next.mesh, next.part_of, next.displacement));
}

/// The patches of the parts.
std::vector<Patch> FineRanks::take(const Patch& patch, const Eigen::VectorXd& displacement) {
    DividedPatch divided = divide(patch, owner_, displacement);
    patch_ = patch;
    parts_ = std::move(divided.parts);
    seams_ = std::move(divided.seams);
    committed_ = trial_ = gather(displacement, seams_.kept);
    increments_.clear();
    for (std::size_t r = 0; r < scales_.size(); ++r)
        if (std::ranges::find(parts_, static_cast<int>(r), &RankPart::rank) == parts_.end()) forget_state(reports_[r]);
    tree_.emplace(patch_.mesh, parts_, seams_);
    return std::move(divided.patches);
}

void FineRanks::restore_parts(const std::vector<Patch>& patches, const ZoneSnapshot& snapshot) {
    for (std::size_t k = 0; k < parts_.size(); ++k)
        scale_of(parts_[k]).restore(patches[k], part_of(snapshot, patches[k].mesh, parts_[k].unknowns));
}

void FineRanks::request(const PatchDisplacement& displacement) {
    if (displacement.iteration == 0) {
        if (displacement.put_aside) increments_.put_aside(trial_ - committed_);
        if (!displacement.predictor.goes_on) trial_ = committed_;
        if (const Eigen::VectorXd* earlier = increments_.find(displacement.predictor))
            trial_ += displacement.predictor.factor * *earlier;
        correction_ = Eigen::VectorXd::Zero(trial_.size());
    } else {
        if (!displacement.further)
            correction_ = tree_->follow(displacement.boundary - gather(trial_, seams_.gamma),
                                        displacement.load_factor - load_factor_);
        trial_ += displacement.step * correction_;
    }
    trial_(seams_.gamma) = displacement.boundary;
    load_factor_ = displacement.load_factor;
    cases_ = displacement.cases;
    for (const RankPart& part : parts_) {
        PatchDisplacement of_part = displacement;
        of_part.boundary = gather(trial_, part.shared);
        scale_of(part).request(of_part);
    }
}

PatchResponse FineRanks::collect() {
    const std::vector<PatchResponse> answers = collect_all();
    PatchResponse response;
    response.digest.yielding_points.assign(patch_.mesh.elements.size(), 0);
    Eigen::VectorXd unit_load = gather(patch_.unit_load, seams_.kept), load = load_factor_ * unit_load;
    if (patch_.case_loads.cols() > 0) load += patch_.case_loads(seams_.kept, Eigen::all) * cases_;
    const double applied = correction_.dot(load);  // the parts know of the forces inside them
    response.along = response.along_before = applied;
    for (std::size_t k = 0; k < parts_.size(); ++k) {
        add(response, answers[k], parts_[k].elements);
        load(parts_[k].shared) -= answers[k].force;
        unit_load(parts_[k].shared) += answers[k].unit_load;
    }
    for (const int seam : seams_.between)
        response.interior_residual = std::max(response.interior_residual, std::abs(load[seam]));
    response.same_tangent = !tree_->factor();
    if (!response.same_tangent) response.tangent = tree_->tangent();
    tree_->reduce(load, unit_load);
    response.force = -tree_->load();
    response.unit_load = tree_->unit_load();
    return response;
}

/// Every answer is read, also where one is a failure: nobody is left in mid-conversation.
std::vector<PatchResponse> FineRanks::collect_all() {
    std::vector<PatchResponse> answers(parts_.size());
    std::exception_ptr failure;
    for (std::size_t k = 0; k < parts_.size(); ++k) {
        try {
            answers[k] = scale_of(parts_[k]).collect();
            if (!answers[k].same_tangent) tree_->set_tangent(k, std::move(answers[k].tangent));
        } catch (const NumericalFailure&) {
            if (!failure) failure = std::current_exception();
        }
    }
    if (failure) std::rethrow_exception(failure);
    return answers;
}

StepReport FineRanks::commit(const Commit& what) {
    const Eigen::VectorXd increment = trial_ - committed_;
    increments_.push(increment);
    committed_ = trial_;
    for (const RankPart& part : parts_) scale_of(part).begin_commit(what);
    for (const RankPart& part : parts_) reports_[at(part.rank)] = scale_of(part).commit(what);
    StepReport report = sum_of(reports_, patch_.rings);
    report.unknowns = patch_.mesh.unknowns + report.multipliers;  // seams once
    report.energy.load_path += gather(patch_.unit_load, seams_.kept).dot(increment);
    if (patch_.case_loads.cols() > 0)
        report.energy.case_paths += patch_.case_loads(seams_.kept, Eigen::all).transpose() * increment;
    return report;
}

void FineRanks::rollback() {
    for (const RankPart& part : parts_) scale_of(part).rollback();
}

ZoneSnapshot FineRanks::snapshot() {
    ZoneSnapshot whole;
    whole.ranks = static_cast<std::int32_t>(scales_.size());
    whole.displacement = whole.rest_displacement = Eigen::VectorXd::Zero(patch_.mesh.unknowns);
    whole.increments.assign(increments_.all().size(), whole.displacement);
    whole.held = whole.displacement;
    for (const RankPart& part : parts_) add(whole, scale_of(part).snapshot(), part.rank, part.unknowns);
    std::ranges::stable_sort(whole.multipliers, {}, &MultiplierSnapshot::crack);
    std::vector<int> all(at(patch_.mesh.unknowns));
    std::iota(all.begin(), all.end(), 0);
    return part_of(whole, patch_.mesh, all);  // in the order of the patch, as one rank would give it
}

ZoneState FineRanks::state() {
    ZoneState whole;
    whole.displacement = Eigen::VectorXd::Zero(patch_.mesh.unknowns);
    for (const RankPart& part : parts_) add(whole, scale_of(part).state(), part.unknowns, part.elements);
    return whole;
}

}  // namespace stria::coupling
