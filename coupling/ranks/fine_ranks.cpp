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
#include "coupling/ranks/zone_partition.hpp"

namespace stria::coupling {
namespace {

std::map<int, int> by_id(const EnrichedMesh& zone, const std::vector<int>& rank_of) {
    std::map<int, int> owners;
    for (std::size_t e = 0; e < rank_of.size(); ++e)
        owners.emplace_hint(owners.end(), zone.element_ids[e], rank_of[e]);  // ascending ids
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
    if (given_.empty()) begin_set_patch(patch);
    const std::vector<Patch> given = std::exchange(given_, {});
    for_each_answer(asked(), [&](std::size_t k) { scale_of(parts_[k]).set_patch(given[k]); });
}

void FineRanks::begin_set_patch(const Patch& patch) {
    std::vector<double> flow = flow_in(patch);
    choose_owners(patch, flow);
    given_ = take(patch, known_displacement(patch), moved_to(patch.mesh));
    flow_ = std::move(flow);
    for (std::size_t k = 0; k < given_.size(); ++k) scale_of(parts_[k]).begin_set_patch(given_[k]);
    tree_.emplace(patch_.mesh, parts_, seams_);
}

// Elements keep their rank unless a crack ties together those of several, or another sharing is much better. That is
// looked at where the cost is another one than when it was looked at last. While elements are split their history stays
// where it is.
void FineRanks::choose_owners(const Patch& patch, const std::vector<double>& flow) {
    constexpr double much_better = 0.85, another = 0.05;
    // Who has lost all elements gets none by a new sharing; where one that is new comes to it, it begins anew (divide).
    const int ranks = static_cast<int>(owner_.empty() ? scales_.size() : parts_.size());
    const std::optional<std::vector<int>> on =
        owner_.empty() ? std::nullopt : share_on(patch.mesh, owner_, patch.part_of);
    const auto cost = [&](const std::vector<int>& rank_of) { return cost_of_sharing(patch.mesh, rank_of, flow); };
    const double cost_on = on ? cost(*on) : 0.0;
    if (on && (ranks == 1 || !patch.part_of.empty() || std::abs(cost_on - weighed_cost_) < another * weighed_cost_)) {
        owner_ = by_id(patch.mesh, *on);
        return;
    }
    const std::vector<int> anew = share_out(patch.mesh, ranks, patch_.mesh, patch.part_of, flow);
    const bool stays = on && cost(anew) > much_better * cost_on;
    weighed_cost_ = stays ? cost_on : cost(anew);
    const bool knew = !std::exchange(owner_, by_id(patch.mesh, stays ? *on : anew)).empty();
    if (knew && !stays) move_history();
}

/// By id; parts have that of their whole.
std::vector<double> FineRanks::flow_in(const Patch& next) const {
    std::map<int, double> known;
    for (std::size_t e = 0; e < flow_.size(); ++e)
        known.emplace_hint(known.end(), patch_.mesh.element_ids[e], flow_[e]);
    std::vector<double> flow;
    for (std::size_t e = 0; e < next.mesh.elements.size(); ++e) {
        const bool is_part = !next.part_of.empty() && next.part_of[e] >= 0;
        const auto found = known.find(is_part ? next.part_of[e] : next.mesh.element_ids[e]);
        flow.push_back(found != known.end() ? found->second : 0.0);
    }
    return flow;
}

void FineRanks::note_flow(const Digest& digest) {
    constexpr double newest = 1.0 / 64.0;  // of a mean that forgets: about a cycle
    for (std::size_t e = 0; e < flow_.size(); ++e)
        flow_[e] += newest * ((digest.yielding_points[e] > 0 ? 1.0 : 0.0) - flow_[e]);
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
    const bool same_ranks = snapshot.ranks == std::ssize(scales_);
    const int ranks = static_cast<int>(scales_.size());
    owner_ = same_ranks ? owners_in(snapshot) : by_id(patch.mesh, share_out(patch.mesh, ranks, {}, {}, snapshot.flow));
    go_on_from(patch, snapshot);
    flow_ = snapshot.flow;
    weighed_cost_ = same_ranks ? snapshot.weighed_cost : 0.0;
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
    DividedPatch divided = divide(patch, owner_, displacement, parts_);
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
    note_flow(response.digest);
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
    return together({patch_.mesh, parts_, flow_, weighed_cost_}, &FineScale::snapshot);
}

void FineRanks::keep() {
    for (const RankPart& part : parts_) scale_of(part).keep();
    kept_ = {patch_.mesh, parts_, flow_, weighed_cost_};
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
