#include "fine/fine_model.hpp"

#include <algorithm>

#include "common/stopwatch.hpp"

namespace stria::fine {

FineModel::FineModel(const Case& input) : system_(input) {}

void FineModel::set_patch(const coupling::Patch& patch) {
    system_.set_patch(patch);
    plant_tree();
}

void FineModel::plant_tree() {
    const coupling::Patch& patch = system_.patch();
    const ContactInterface& contact = system_.contact();
    FrontTree::Layout layout;
    layout.unknowns = patch.mesh.unknowns + contact.multipliers();
    layout.multipliers = contact.multipliers();
    layout.boundary = patch.boundary;
    for (const ElementOperator& op : system_.zone().operators()) {
        layout.element_unknowns.push_back(op.unknowns);
        Vec2 centre = Vec2::Zero();
        for (const int node : patch.mesh.elements[static_cast<std::size_t>(op.element)])
            centre += patch.mesh.nodes[static_cast<std::size_t>(node)] / 4.0;
        layout.centres.push_back(centre);
    }
    for (int k = 0; k < contact.multipliers(); ++k) {
        std::vector<int>& unknowns = layout.element_unknowns.emplace_back();
        for (SparseRows::InnerIterator it(contact.operator_B(), k); it; ++it)
            unknowns.push_back(static_cast<int>(it.col()));
        unknowns.push_back(patch.mesh.unknowns + k);
        layout.centres.push_back(contact.keys()[static_cast<std::size_t>(k)].x);
    }
    changed_.assign(layout.element_unknowns.size(), 1);
    all_changed_ = true;
    in_tree_.assign(static_cast<std::size_t>(contact.multipliers()), none);
    multiplier_matrices_.resize(in_tree_.size());
    tree_ = std::make_unique<FrontTree>(std::move(layout));
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
    find_changes();
    coupling::PatchResponse response = system_.measure();
    condense(response);
    return response;
}

// What differs from the last factor: tangents of elements, and multipliers whose status has changed.
void FineModel::find_changes() {
    const std::span<const char> changed = system_.zone().changed();
    for (std::size_t e = 0; e < changed.size(); ++e) changed_[e] = static_cast<char>(changed_[e] | changed[e]);
    const std::vector<std::int8_t>& statuses = system_.contact().statuses();
    for (std::size_t k = 0; k < statuses.size(); ++k) {
        if (in_tree_[k] == statuses[k]) continue;
        in_tree_[k] = statuses[k];
        multiplier_matrices_[k] = multiplier_matrix(static_cast<int>(k));
        changed_[changed.size() + k] = 1;
    }
}

// On what it acts on and itself. An open multiplier loses its pressure whatever else moves.
Eigen::MatrixXd FineModel::multiplier_matrix(int k) const {
    const ContactInterface& contact = system_.contact();
    const Eigen::Index jumps = contact.operator_B().row(k).nonZeros();
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(jumps + 1, jumps + 1);
    if (contact.statuses()[static_cast<std::size_t>(k)] == 0) {
        matrix(jumps, jumps) = contact.open_diagonal()[k];
        return matrix;
    }
    Eigen::Index place = 0;
    for (SparseRows::InnerIterator it(contact.operator_B(), k); it; ++it, ++place)
        matrix(place, jumps) = matrix(jumps, place) = -it.value();
    return matrix;
}

// Near equilibrium the forces on Gamma do not depend on the factor, and one more correction needs no new one.
bool FineModel::last_factor_serves(const coupling::PatchResponse& response) const {
    const auto first_multiplier = changed_.end() - std::ssize(in_tree_);
    return !all_changed_ && asked_.settled_below > 0.0 &&
           std::find(first_multiplier, changed_.end(), 1) == changed_.end() &&
           std::max(response.interior_residual, response.contact_residual) <= asked_.settled_below;
}

void FineModel::factor() {
    if (all_changed_) std::ranges::fill(changed_, static_cast<char>(1));
    const std::span<const Eigen::MatrixXd> tangents = system_.zone().tangents();
    const long before = tree_->refactored();
    tree_->factor(
        [&](int element) -> const Eigen::MatrixXd& {
            const auto e = static_cast<std::size_t>(element);
            return e < tangents.size() ? tangents[e] : multiplier_matrices_[e - tangents.size()];
        },
        changed_);
    const long refactored = tree_->refactored() - before;
    work_.fronts_refactored += refactored;
    work_.fronts_kept += tree_->fronts() - refactored;
    std::ranges::fill(changed_, static_cast<char>(0));
    all_changed_ = false;
}

void FineModel::condense(coupling::PatchResponse& response) {
    const Stopwatch watch(factor_s_);
    response.same_tangent = last_factor_serves(response);
    if (response.same_tangent) {
        ++work_.factors_reused;
    } else {
        factor();
        response.tangent = tree_->tangent();
    }
    reduced_ = tree_->reduce(due());
    response.force = -reduced_.boundary;
    response.unit_load = Eigen::VectorXd::Zero(reduced_.boundary.size());
    reduced_unit_ = {Eigen::VectorXd::Zero(reduced_.interior.size()), response.unit_load};
    if (system_.patch().unit_load.isZero(0.0)) return;
    Eigen::VectorXd unit = Eigen::VectorXd::Zero(reduced_.interior.size() + reduced_.boundary.size());
    unit.head(system_.patch().unit_load.size()) = system_.patch().unit_load;
    reduced_unit_ = tree_->reduce(unit);
    response.unit_load = reduced_unit_.boundary;
}

// What Newton has to remove: forces, and gaps or pressures of multipliers. An open one does not push any more.
Eigen::VectorXd FineModel::due() const {
    const ContactInterface& contact = system_.contact();
    Eigen::VectorXd open = system_.pressure(), forces = system_.load();
    for (Eigen::Index k = 0; k < open.size(); ++k)
        if (contact.statuses()[static_cast<std::size_t>(k)] != 0) open[k] = 0.0;
    contact.add_force(open, forces);
    Eigen::VectorXd due(forces.size() + open.size());
    due << forces, system_.contact_right_hand_side();
    return due;
}

void FineModel::advance_interior() {
    const Eigen::VectorXd step = asked_.boundary - gather(system_.displacement(), system_.patch().boundary);
    const double load_step = asked_.load_factor - system_.load_factor();
    const ReducedLoad moving{reduced_.interior + load_step * reduced_unit_.interior, reduced_.boundary};
    const Eigen::VectorXd move = system_.step() * tree_->expand(moving, step);
    system_.move(move.head(system_.displacement().size()), move.tail(system_.pressure().size()));
}

coupling::StepReport FineModel::commit(bool reversal) {
    coupling::StepReport report = system_.commit(reversal);
    report.factor_s = factor_s_;
    report.work += work_;
    return report;
}

coupling::ZoneState FineModel::state() { return system_.state(); }

coupling::ZoneSnapshot FineModel::snapshot() { return system_.snapshot(); }

void FineModel::restore(const coupling::Patch& patch, const coupling::ZoneSnapshot& snapshot) {
    system_.restore(patch, snapshot);
    plant_tree();
}

}  // namespace stria::fine
