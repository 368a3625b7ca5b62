#include "fine/fine_model.hpp"

#include <algorithm>
#include <ranges>

#include "common/error.hpp"
#include "common/stopwatch.hpp"

namespace stria::fine {

FineModel::FineModel(const Case& input) : system_(input) {}

void FineModel::set_patch(const coupling::Patch& patch) {
    system_.set_patch(patch);
    at_root_.assign(static_cast<std::size_t>(system_.contact().multipliers()), 0);
    committed_at_root_ = at_root_;
    plant_tree();
}

void FineModel::plant_tree() {
    const coupling::Patch& patch = system_.patch();
    const auto& jumps = system_.contact().jump_unknowns();
    const Eigen::MatrixXd& B = system_.contact().operator_B();
    root_jumps_.clear();
    kept_.clear();
    kept_column_.assign(jumps.size(), -1);
    for (std::size_t j = 0; j < jumps.size(); ++j) {
        if (std::ranges::binary_search(patch.boundary, jumps[j])) continue;
        const auto pushes = [&](std::size_t k) {
            return at_root_[k] != 0 && B(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(j)) != 0.0;
        };
        if (std::ranges::none_of(std::views::iota(std::size_t{0}, at_root_.size()), pushes)) continue;
        kept_column_[j] = static_cast<int>(kept_.size());
        root_jumps_.push_back(static_cast<int>(j));
        kept_.push_back(jumps[j]);
    }
    for (std::size_t j = 0; j < jumps.size(); ++j) {
        const auto place = std::ranges::lower_bound(patch.boundary, jumps[j]);
        if (place != patch.boundary.end() && *place == jumps[j])
            kept_column_[j] = static_cast<int>(std::ssize(kept_) + (place - patch.boundary.begin()));
    }
    kept_.insert(kept_.end(), patch.boundary.begin(), patch.boundary.end());

    FrontTree::Layout layout;
    layout.unknowns = patch.mesh.unknowns;
    layout.boundary = kept_;
    for (const ElementOperator& op : system_.zone().operators()) {
        layout.element_unknowns.push_back(op.unknowns);
        Vec2 centre = Vec2::Zero();
        for (const int node : patch.mesh.elements[static_cast<std::size_t>(op.element)])
            centre += patch.mesh.nodes[static_cast<std::size_t>(node)] / 4.0;
        layout.centres.push_back(centre);
    }
    tree_ = std::make_unique<FrontTree>(std::move(layout));
    all_changed_ = true;
    changed_.assign(patch.mesh.elements.size(), 1);
}

// With some neighbours more, so that a contact zone that grows does not ask again at once.
void FineModel::keep_touching_to_root() {
    constexpr int neighbours = 3;
    const auto& statuses = system_.contact().statuses();
    const int last = system_.contact().multipliers() - 1;
    bool missing = false;
    for (int k = 0; k <= last; ++k)
        missing = missing || (statuses[static_cast<std::size_t>(k)] != 0 && at_root_[static_cast<std::size_t>(k)] == 0);
    if (!missing) return;
    for (int k = 0; k <= last; ++k) {
        if (statuses[static_cast<std::size_t>(k)] == 0) continue;
        for (int i = std::max(0, k - neighbours); i <= std::min(last, k + neighbours); ++i)
            at_root_[static_cast<std::size_t>(i)] = 1;
    }
    plant_tree();
}

void FineModel::request(const coupling::PatchDisplacement& displacement) { asked_ = displacement; }

coupling::PatchResponse FineModel::collect() {
    if (asked_.iteration == 0)
        system_.predict(asked_.predictor);
    else
        advance_interior();
    system_.set_load_factor(asked_.load_factor);
    system_.set_boundary(asked_.boundary);
    system_.linearise();
    keep_touching_to_root();
    coupling::PatchResponse response = system_.measure();
    condense(response);
    return response;
}

// Near equilibrium the forces on Gamma do not depend on the factor, and one more correction needs no new one.
bool FineModel::last_factor_serves(const coupling::PatchResponse& response) const {
    return !all_changed_ && asked_.settled_below > 0.0 && response.digest.status_changes == 0 &&
           std::max(response.interior_residual, response.contact_residual) <= asked_.settled_below;
}

void FineModel::factor() {
    if (all_changed_) std::ranges::fill(changed_, static_cast<char>(1));
    const long before = tree_->refactored();
    tree_->factor(system_.zone().tangents(), changed_);
    const long refactored = tree_->refactored() - before;
    work_.fronts_refactored += refactored;
    work_.fronts_kept += tree_->fronts() - refactored;
    std::ranges::fill(changed_, static_cast<char>(0));
    all_changed_ = false;
}

void FineModel::condense(coupling::PatchResponse& response) {
    const Stopwatch watch(factor_s_);
    const std::span<const char> changed = system_.zone().changed();
    for (std::size_t e = 0; e < changed.size(); ++e) changed_[e] = static_cast<char>(changed_[e] | changed[e]);
    response.same_tangent = last_factor_serves(response);
    if (response.same_tangent)
        ++work_.factors_reused;
    else
        factor();

    work_.multipliers_bulk += std::ranges::count(at_root_, static_cast<char>(0));

    // An open multiplier loses its pressure whatever else moves: only closed ones are unknowns.
    const ContactInterface& contact = system_.contact();
    const ContactInterface::Rows rows = system_.contact_rows();
    Eigen::VectorXd load = system_.load(), open = system_.pressure();
    touching_.clear();
    for (int k = 0; k < contact.multipliers(); ++k) {
        if (contact.statuses()[static_cast<std::size_t>(k)] == 0) continue;
        touching_.push_back(k);
        open[k] = 0.0;
    }
    contact.add_force(open, load);
    reduced_ = tree_->reduce(load);
    const Eigen::VectorXd& own = system_.patch().unit_load;
    reduced_unit_ = {Eigen::VectorXd::Zero(reduced_.interior.size()), Eigen::VectorXd::Zero(reduced_.boundary.size())};
    if (!own.isZero(0.0)) reduced_unit_ = tree_->reduce(own);

    Eigen::MatrixXd loads(std::ssize(kept_), 2);
    loads << reduced_.boundary, reduced_unit_.boundary;
    Eigen::MatrixXd B = Eigen::MatrixXd::Zero(std::ssize(touching_), std::ssize(kept_));
    for (std::size_t j = 0; j < kept_column_.size(); ++j) {
        if (kept_column_[j] >= 0)
            B.col(kept_column_[j]) = contact.operator_B()(touching_, static_cast<Eigen::Index>(j));
    }
    ContactBlock::Condensed condensed = block_.eliminate({.stiffness = tree_->tangent(),
                                                          .jumps = std::ssize(root_jumps_),
                                                          .B = std::move(B),
                                                          .h = rows.right_hand_side(touching_),
                                                          .loads = std::move(loads)});
    if (!response.same_tangent) response.tangent = std::move(condensed.stiffness);
    response.force = -condensed.loads.col(0);
    response.unit_load = condensed.loads.col(1);
}

void FineModel::advance_interior() {
    const Eigen::VectorXd step = asked_.boundary - gather(system_.displacement(), system_.patch().boundary);
    const double load_step = asked_.load_factor - system_.load_factor();
    const ContactBlock::Recovered inner = block_.recover(step, load_step);
    Eigen::VectorXd kept(std::ssize(kept_)), pressure = -system_.pressure();
    kept << inner.jumps, step;
    pressure(touching_) = inner.multipliers;
    const ReducedLoad moving{reduced_.interior + load_step * reduced_unit_.interior, reduced_.boundary};
    system_.move(system_.step() * tree_->expand(moving, kept), system_.step() * pressure);
}

coupling::StepReport FineModel::commit(bool reversal) {
    coupling::StepReport report = system_.commit(reversal);
    report.factor_s = factor_s_;
    report.work += work_;
    committed_at_root_ = at_root_;
    return report;
}

// The next increment starts from what is committed. So does the tree, lest a failed attempt show in the last bits.
void FineModel::rollback() {
    if (at_root_ == committed_at_root_) return;
    at_root_ = committed_at_root_;
    plant_tree();
}

coupling::ZoneState FineModel::state() { return system_.state(); }

coupling::ZoneSnapshot FineModel::snapshot() {
    coupling::ZoneSnapshot snapshot = system_.snapshot();
    for (std::size_t k = 0; k < committed_at_root_.size(); ++k)
        snapshot.multipliers[k].at_root = committed_at_root_[k] != 0;
    return snapshot;
}

// The tree's shape shows in the last bits, and what stands at its root has come about step by step.
void FineModel::restore(const coupling::Patch& patch, const coupling::ZoneSnapshot& snapshot) {
    system_.restore(patch, snapshot);
    at_root_.clear();
    for (const coupling::MultiplierSnapshot& multiplier : snapshot.multipliers)
        at_root_.push_back(multiplier.at_root ? 1 : 0);
    committed_at_root_ = at_root_;
    plant_tree();
}

}  // namespace stria::fine
