#include "coupling/ranks/fine_ranks.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <ranges>
#include <utility>

#include "common/error.hpp"
#include "common/integration/element_operator.hpp"
#include "common/integration/parts_of_elements.hpp"
#include "coupling/moved_increments.hpp"
#include "coupling/ranks/answers.hpp"
#include "coupling/ranks/merged_reports.hpp"

namespace stria::coupling {
FineRanks::FineRanks(std::vector<FineScale*> ranks, std::size_t remembered)
    : scales_(std::move(ranks)), sharing_(static_cast<int>(scales_.size())), increments_(remembered),
      reports_(scales_.size()) {}

void FineRanks::set_patch(const Patch& patch) {
    if (given_.empty()) begin_set_patch(patch);
    const std::vector<Patch> given = std::exchange(given_, {});
    for_each_answer(asked(), [&](std::size_t k) { scale_of(parts_[k]).set_patch(given[k]); });
}

void FineRanks::begin_set_patch(const Patch& patch) {
    if (sharing_.turn_to(patch, patch_.mesh, static_cast<int>(parts_.size()))) move_history();
    given_ = take(patch, known_displacement(patch), moved_to(patch.mesh));
    sharing_.arrive();
    for (std::size_t k = 0; k < given_.size(); ++k) scale_of(parts_[k]).begin_set_patch(given_[k]);
    tree_.emplace(patch_.mesh, parts_, seams_);
}

// As many as all know: a rank that has been idle knows none.
Eigen::MatrixXd FineRanks::increments() {
    Eigen::Index count = std::ssize(increments_.all());
    std::vector<Eigen::MatrixXd> own;
    for (const RankPart& part : parts_) {
        own.push_back(scale_of(part).increments());
        count = std::min(count, own.back().cols());
    }
    Eigen::MatrixXd known(patch_.mesh.unknowns, count);
    for (std::size_t k = 0; k < parts_.size(); ++k) known(parts_[k].unknowns, Eigen::all) = own[k].leftCols(count);
    return known;
}

MovedIncrements FineRanks::moved_to(const EnrichedMesh& next) {
    if (increments_.all().empty()) return {};
    return moved_increments(patch_.mesh, next, [this] { return increments(); });
}

void FineRanks::restore(const Patch& patch, const ZoneSnapshot& snapshot) {
    sharing_.resume(patch, snapshot);
    go_on_from(patch, snapshot);
}

// Of the patch that all know. It changes no state, as a checkpoint would not.
void FineRanks::move_history() {
    const ZoneSnapshot all = snapshot();
    go_on_from(Patch(patch_), all);
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
std::vector<Patch> FineRanks::take(const Patch& patch, const Eigen::VectorXd& displacement,
                                   const MovedIncrements& moved) {
    DividedPatch divided = divide(patch, sharing_.owner(), displacement, parts_);
    patch_ = patch;
    parts_ = std::move(divided.parts);
    seams_ = std::move(divided.seams);
    committed_ = trial_ = gather(displacement, seams_.kept);
    increments_.clear();
    for (Eigen::Index k = moved.displacement.cols(); k-- > 0;)
        increments_.push(gather(moved.displacement.col(k), seams_.kept));
    for (std::size_t r = 0; r < scales_.size(); ++r)
        if (std::ranges::find(parts_, static_cast<int>(r), &RankPart::rank) == parts_.end()) forget_state(reports_[r]);
    if (moved.displacement.cols() > 0)
        for (std::size_t k = 0; k < parts_.size(); ++k)
            divided.patches[k].moved = {moved.moves, moved.displacement(parts_[k].unknowns, Eigen::all)};
    return std::move(divided.patches);
}

void FineRanks::go_on_from(const Patch& patch, const ZoneSnapshot& snapshot) {
    const std::vector<Patch> patches = take(patch, snapshot.displacement);
    for (const Eigen::VectorXd& increment : snapshot.increments | std::views::reverse)
        increments_.push(gather(increment, seams_.kept));
    std::vector<ZoneSnapshot> parts;
    for (std::size_t k = 0; k < parts_.size(); ++k) {
        parts.push_back(part_of(snapshot, patches[k].mesh, parts_[k].unknowns));
        scale_of(parts_[k]).begin_restore(patches[k], parts[k]);
    }
    tree_.emplace(patch_.mesh, parts_, seams_);
    for_each_answer(asked(), [&](std::size_t k) { scale_of(parts_[k]).restore(patches[k], parts[k]); });
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
                                        displacement.load_factor - question_.load_factor);
        trial_ += displacement.step * correction_;
    }
    trial_(seams_.gamma) = displacement.boundary;
    question_ = displacement;
    question_.opens_faces = opens_faces_;
    for (const RankPart& part : parts_) {
        PatchDisplacement of_part = question_;
        if (question_.settled_below > 0.0) of_part.wanted = Wanted::Residuals;
        of_part.boundary = gather(trial_, part.shared);
        scale_of(part).request(of_part);
    }
}

PatchResponse FineRanks::collect() {
    std::vector<PatchResponse> answers = answers_of_ranks();
    PatchResponse response;
    response.digest.yielding_points.assign(patch_.mesh.elements.size(), 0);
    Eigen::VectorXd unit_load = gather(patch_.unit_load, seams_.kept), load = question_.load_factor * unit_load;
    if (patch_.case_loads.cols() > 0) load += patch_.case_loads(seams_.kept, Eigen::all) * question_.cases;
    response.along = response.along_before = correction_.dot(load);  // the parts know of the forces inside them
    Eigen::VectorXd due = load;
    response.may_keep_factor = true;
    for (std::size_t k = 0; k < parts_.size(); ++k) {
        add(response, answers[k], parts_[k].elements);
        due(parts_[k].shared) += answers[k].due;
    }
    sharing_.note(response.digest);
    opens_faces_ = response.opens_faces;
    response.due = gather(due, seams_.gamma);
    for (const int seam : seams_.between)
        response.interior_residual = std::max(response.interior_residual, std::abs(due[seam]));
    if (question_.settled_below > 0.0) {
        const double residual = std::max(response.interior_residual, response.contact_residual);
        response.keeps_factor = response.may_keep_factor && residual <= question_.settled_below;
        for (FineScale* rank : asked())
            rank->request({.wanted = Wanted::Rest, .keeps_factor = response.keeps_factor, .boundary = {}});
        answers = answers_of_ranks();
    }
    for (std::size_t k = 0; k < parts_.size(); ++k) {
        load(parts_[k].shared) -= answers[k].force;
        unit_load(parts_[k].shared) += answers[k].unit_load;
    }
    response.same_tangent = !tree_->factor();
    if (!response.same_tangent) response.tangent = tree_->tangent();
    tree_->reduce(load, unit_load);
    response.force = -tree_->load();
    response.unit_load = tree_->unit_load();
    return response;
}

std::vector<FineScale*> FineRanks::asked() const {
    std::vector<FineScale*> asked;
    for (const RankPart& part : parts_) asked.push_back(&scale_of(part));
    return asked;
}

std::vector<PatchResponse> FineRanks::answers_of_ranks() {
    std::vector<PatchResponse> answers(parts_.size());
    for_each_answer(asked(), [&](std::size_t k) {
        answers[k] = scale_of(parts_[k]).collect();
        if (answers[k].tangent.matrix.size() > 0) tree_->set_tangent(k, std::move(answers[k].tangent));
    });
    return answers;
}

StepReport FineRanks::commit(const Commit& what) {
    const Eigen::VectorXd increment = trial_ - committed_;
    increments_.push(increment);
    committed_ = trial_;
    for (const RankPart& part : parts_) scale_of(part).begin_commit(what);
    for_each_answer(asked(), [&](std::size_t k) { reports_[at(parts_[k].rank)] = scale_of(parts_[k]).commit(what); });
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
    return together({patch_.mesh, parts_, sharing_.flow(), sharing_.weighed_cost()}, &FineScale::snapshot);
}

void FineRanks::keep() {
    for (const RankPart& part : parts_) scale_of(part).keep();
    kept_ = {patch_.mesh, parts_, sharing_.flow(), sharing_.weighed_cost()};
}

ZoneSnapshot FineRanks::kept() { return together(kept_, &FineScale::kept); }

ZoneSnapshot FineRanks::together(const Kept& of, ZoneSnapshot (FineScale::*give)()) const {
    ZoneSnapshot whole;
    whole.ranks = static_cast<std::int32_t>(scales_.size());
    whole.displacement = whole.rest_displacement = whole.held = Eigen::VectorXd::Zero(of.mesh.unknowns);
    for (const RankPart& part : of.parts) {
        const ZoneSnapshot own = (scale_of(part).*give)();
        whole.increments.resize(own.increments.size(), Eigen::VectorXd::Zero(of.mesh.unknowns));
        add(whole, own, part.rank, part.unknowns);
    }
    std::ranges::stable_sort(whole.multipliers, {}, &MultiplierSnapshot::crack);
    std::vector<int> all(at(of.mesh.unknowns));
    std::iota(all.begin(), all.end(), 0);
    whole = part_of(whole, of.mesh, all);  // in the order of the patch, as one rank would give it
    whole.flow = of.flow;
    whole.weighed_cost = of.weighed_cost;
    return whole;
}

ZoneState FineRanks::state() {
    ZoneState whole;
    whole.displacement = Eigen::VectorXd::Zero(patch_.mesh.unknowns);
    for (const RankPart& part : parts_) add(whole, scale_of(part).state(), part.unknowns, part.elements);
    return whole;
}

}  // namespace stria::coupling
