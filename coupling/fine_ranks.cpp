#include "coupling/fine_ranks.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <numeric>
#include <ranges>

#include "common/enrichment/part_of_mesh.hpp"
#include "common/error.hpp"
#include "common/index.hpp"
#include "common/integration/element_operator.hpp"
#include "coupling/merged_reports.hpp"
#include "coupling/zone_partition.hpp"

namespace stria::coupling {
namespace {

int place_of(const std::vector<int>& ascending, int unknown) {
    return static_cast<int>(std::ranges::lower_bound(ascending, unknown) - ascending.begin());
}

std::map<int, int> by_id(const EnrichedMesh& zone, const std::vector<int>& rank_of) {
    std::map<int, int> owners;
    for (std::size_t e = 0; e < rank_of.size(); ++e) owners[zone.element_ids[e]] = rank_of[e];
    return owners;
}

}  // namespace

/// One of those with elements.
struct FineRanks::Rank {
    FineScale* scale;
    std::size_t number;
    std::vector<int> elements;  // of the patch's mesh
    std::vector<int> unknowns;  // of the patch's mesh, of each unknown of its own
    std::vector<int> shared;    // of its boundary: places in kept_
};

FineRanks::FineRanks(std::vector<FineScale*> ranks, std::size_t remembered)
    : scales_(std::move(ranks)), increments_(remembered), reports_(scales_.size()) {}

FineRanks::~FineRanks() = default;

void FineRanks::set_patch(const Patch& patch) {
    if (owner_.empty()) {
        owner_ = by_id(patch.mesh, share_out(patch.mesh, static_cast<int>(scales_.size())));
    } else if (const auto kept = share_on(patch.mesh, owner_)) {
        owner_ = by_id(patch.mesh, *kept);
    } else {
        // Who has lost all elements once idles for good: what it knows is no more true.
        owner_ = by_id(patch.mesh, share_out(patch.mesh, static_cast<int>(ranks_.size()), patch_.mesh));
        move_history();
    }
    take(patch, known_displacement(patch), nullptr);
}

// Of the patch that all know. It changes no state, as a checkpoint would not.
void FineRanks::move_history() {
    const ZoneSnapshot all = snapshot();
    take(Patch(patch_), all.displacement, &all);
    ++history_moves_;
}

void FineRanks::restore(const Patch& patch, const ZoneSnapshot& snapshot) {
    owner_.clear();
    if (snapshot.ranks == std::ssize(scales_))
        for (std::size_t e = 0; e < snapshot.element.size(); ++e) owner_[snapshot.element[e]] = snapshot.rank[e];
    else
        owner_ = by_id(patch.mesh, share_out(patch.mesh, static_cast<int>(scales_.size())));
    take(patch, snapshot.displacement, &snapshot);
    for (const Eigen::VectorXd& increment : snapshot.increments | std::views::reverse)
        increments_.push(gather(increment, kept_));
}

/// `snapshot`: null where the ranks know themselves what has been.
void FineRanks::take(const Patch& patch, const Eigen::VectorXd& displacement, const ZoneSnapshot* snapshot) {
    std::vector<EnrichedMesh> parts = divide(patch.mesh);
    patch_ = patch;
    find_seams();
    committed_ = trial_ = gather(displacement, kept_);
    increments_.clear();
    send(std::move(parts), displacement, snapshot);
    plant_tree();
}

/// Committed displacement of the next patch: what the seams know is theirs.
Eigen::VectorXd FineRanks::known_displacement(const Patch& next) const {
    if (kept_.empty()) return next.displacement;
    Eigen::VectorXd known = patch_.displacement;
    known(kept_) = committed_;
    return carry_over(patch_.mesh, known, next.mesh, next.displacement);
}

std::vector<EnrichedMesh> FineRanks::divide(const EnrichedMesh& zone) {
    ranks_.clear();
    std::vector<EnrichedMesh> parts;
    for (std::size_t r = 0; r < scales_.size(); ++r) {
        std::vector<int> elements;
        for (int e = 0; e < std::ssize(zone.elements); ++e)
            if (owner_.at(zone.element_ids[at(e)]) == static_cast<int>(r)) elements.push_back(e);
        if (elements.empty()) {
            forget_state(reports_[r]);
            continue;
        }
        parts.push_back(extract(zone, elements));
        ranks_.push_back({scales_[r], r, std::move(elements), whole_unknowns(zone, parts.back()), {}});
    }
    return parts;
}

void FineRanks::find_seams() {
    std::vector<int> seen(at(patch_.mesh.unknowns), 0);
    for (const Rank& rank : ranks_)
        for (const int unknown : rank.unknowns) ++seen[at(unknown)];
    for (const int unknown : patch_.boundary) seen[at(unknown)] = 2;
    kept_.clear();
    for (int i = 0; i < patch_.mesh.unknowns; ++i)
        if (seen[at(i)] > 1) kept_.push_back(i);
    gamma_.clear();
    seams_.clear();
    for (int place = 0; place < std::ssize(kept_); ++place) {
        const bool on_gamma = std::ranges::binary_search(patch_.boundary, kept_[at(place)]);
        (on_gamma ? gamma_ : seams_).push_back(place);
    }
    own_load_ = gather(patch_.unit_load, kept_);
}

// All rings for everybody: pressure on faces counts also where q is one, inside of them.
void FineRanks::send(std::vector<EnrichedMesh> parts, const Eigen::VectorXd& displacement,
                     const ZoneSnapshot* snapshot) {
    for (std::size_t k = 0; k < ranks_.size(); ++k) {
        Rank& rank = ranks_[k];
        Patch part;
        part.mesh = std::move(parts[k]);
        part.displacement = gather(displacement, rank.unknowns);
        part.unit_load = gather(patch_.unit_load, rank.unknowns);
        part.rings = patch_.rings;
        part.ahead = patch_.ahead;
        for (int i = 0; i < part.mesh.unknowns; ++i) {
            const int unknown = rank.unknowns[at(i)];
            if (!std::ranges::binary_search(kept_, unknown)) continue;
            part.boundary.push_back(i);
            part.unit_load[i] = 0.0;
            rank.shared.push_back(place_of(kept_, unknown));
        }
        if (snapshot == nullptr)
            rank.scale->set_patch(part);
        else
            rank.scale->restore(part, part_of(*snapshot, part.mesh, rank.unknowns));
    }
}

void FineRanks::plant_tree() {
    FrontTree::Layout layout;
    layout.unknowns = static_cast<int>(kept_.size());
    layout.boundary = gamma_;
    layout.leaf_elements = 1;
    for (const Rank& rank : ranks_) {
        layout.element_unknowns.push_back(rank.shared);
        Vec2 centre = Vec2::Zero();
        for (const int element : rank.elements)
            for (const int node : patch_.mesh.elements[at(element)]) centre += patch_.mesh.nodes[at(node)] / 4.0;
        layout.centres.push_back(centre / static_cast<double>(rank.elements.size()));
    }
    tree_ = std::make_unique<FrontTree>(std::move(layout));
    tangents_.assign(ranks_.size(), {});
    changed_.assign(ranks_.size(), 1);
}

void FineRanks::request(const PatchDisplacement& displacement) {
    if (displacement.iteration == 0) {
        trial_ = committed_;
        if (const Eigen::VectorXd* earlier = increments_.find(displacement.predictor))
            trial_ += displacement.predictor.factor * *earlier;
    } else {
        advance_seams(displacement);
    }
    trial_(gamma_) = displacement.boundary;
    load_factor_ = displacement.load_factor;
    for (const Rank& rank : ranks_) {
        PatchDisplacement part = displacement;
        part.boundary = gather(trial_, rank.shared);
        rank.scale->request(part);
    }
}

void FineRanks::advance_seams(const PatchDisplacement& displacement) {
    const Eigen::VectorXd step = displacement.boundary - gather(trial_, gamma_);
    const double load_step = displacement.load_factor - load_factor_;
    trial_ += tree_->expand({reduced_.interior + load_step * reduced_unit_.interior, reduced_.boundary}, step);
}

/// Every answer is read, also where one is a failure: nobody is left in mid-conversation.
std::vector<PatchResponse> FineRanks::collect_all() {
    std::vector<PatchResponse> answers(ranks_.size());
    std::exception_ptr failure;
    for (std::size_t k = 0; k < ranks_.size(); ++k) {
        try {
            answers[k] = ranks_[k].scale->collect();
        } catch (const NumericalFailure&) {
            if (!failure) failure = std::current_exception();
            continue;
        }
        if (answers[k].same_tangent) continue;
        tangents_[k] = std::move(answers[k].tangent);
        changed_[k] = 1;
    }
    if (failure) std::rethrow_exception(failure);
    return answers;
}

PatchResponse FineRanks::collect() {
    const std::vector<PatchResponse> answers = collect_all();
    PatchResponse response;
    response.digest.yielding_points.assign(patch_.mesh.elements.size(), 0);
    Eigen::VectorXd load = load_factor_ * own_load_, unit_load = own_load_;
    for (std::size_t k = 0; k < ranks_.size(); ++k) {
        add(response, answers[k], ranks_[k].elements);
        load(ranks_[k].shared) -= answers[k].force;
        unit_load(ranks_[k].shared) += answers[k].unit_load;
    }
    for (const int seam : seams_)
        response.interior_residual = std::max(response.interior_residual, std::abs(load[seam]));
    response.same_tangent = std::ranges::none_of(changed_, [](char changed) { return changed != 0; });
    if (!response.same_tangent) {
        tree_->factor(
            [&](int rank) {
                const auto& [matrix, symmetry] = tangents_[at(rank)];
                return FrontTree::ElementMatrix{matrix, symmetry};
            },
            changed_);
        std::ranges::fill(changed_, static_cast<char>(0));
        response.tangent = {tree_->tangent(), tree_->symmetry()};
    }
    reduced_ = tree_->reduce(load);
    reduced_unit_ = tree_->reduce(unit_load);
    response.force = -reduced_.boundary;
    response.unit_load = reduced_unit_.boundary;
    return response;
}

StepReport FineRanks::commit(bool reversal) {
    const Eigen::VectorXd increment = trial_ - committed_;
    increments_.push(increment);
    committed_ = trial_;
    for (const Rank& rank : ranks_) rank.scale->begin_commit(reversal);
    for (const Rank& rank : ranks_) reports_[rank.number] = rank.scale->commit(reversal);
    StepReport report = sum_of(reports_, patch_.rings);
    report.unknowns = patch_.mesh.unknowns + report.multipliers;  // seams once
    report.energy.load_path += own_load_.dot(increment);
    return report;
}

void FineRanks::rollback() {
    for (const Rank& rank : ranks_) rank.scale->rollback();
}

ZoneSnapshot FineRanks::snapshot() {
    ZoneSnapshot whole;
    whole.ranks = static_cast<std::int32_t>(scales_.size());
    whole.displacement = whole.rest_displacement = Eigen::VectorXd::Zero(patch_.mesh.unknowns);
    whole.increments.assign(increments_.all().size(), whole.displacement);
    whole.held = whole.displacement;
    for (const Rank& rank : ranks_)
        add(whole, rank.scale->snapshot(), static_cast<std::int32_t>(rank.number), rank.unknowns);
    std::ranges::stable_sort(whole.multipliers, {}, &MultiplierSnapshot::crack);
    std::vector<int> all(at(patch_.mesh.unknowns));
    std::iota(all.begin(), all.end(), 0);
    return part_of(whole, patch_.mesh, all);  // in the order of the patch, as one rank would give it
}

ZoneState FineRanks::state() {
    ZoneState whole;
    whole.displacement = Eigen::VectorXd::Zero(patch_.mesh.unknowns);
    for (const Rank& rank : ranks_) add(whole, rank.scale->state(), rank.unknowns, rank.elements);
    return whole;
}

}  // namespace stria::coupling
