#include "fine/fine_model.hpp"

#include <algorithm>

#include "common/error.hpp"
#include "common/stopwatch.hpp"

namespace stria::fine {

FineModel::FineModel(const Case& input) : system_(input) {}

void FineModel::set_patch(const coupling::Patch& patch) {
    system_.set_patch(patch);
    interior_jumps_.clear();
    kept_.clear();
    const auto& jumps = system_.contact().jump_unknowns();
    for (std::size_t j = 0; j < jumps.size(); ++j) {
        if (std::ranges::binary_search(patch.boundary, jumps[j])) continue;
        interior_jumps_.push_back(static_cast<int>(j));
        kept_.push_back(jumps[j]);
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
    coupling::PatchResponse response = system_.measure();
    condense(response);
    return response;
}

void FineModel::condense(coupling::PatchResponse& response) {
    const Stopwatch watch(factor_s_);
    std::vector<char> changed(system_.zone().changed().begin(), system_.zone().changed().end());
    if (all_changed_) std::ranges::fill(changed, static_cast<char>(1));
    all_changed_ = false;
    tree_->factor(system_.zone().tangents(), changed);
    reduced_ = tree_->reduce(system_.load());
    const Eigen::VectorXd& own = system_.patch().unit_load;
    reduced_unit_ = {Eigen::VectorXd::Zero(reduced_.interior.size()), Eigen::VectorXd::Zero(reduced_.boundary.size())};
    if (!own.isZero(0.0)) reduced_unit_ = tree_->reduce(own);

    const Eigen::MatrixXd& S = tree_->tangent();
    const auto j = std::ssize(interior_jumps_), g = std::ssize(system_.patch().boundary);
    const auto m = static_cast<Eigen::Index>(system_.contact().multipliers());
    Eigen::MatrixXd loads(j + g, 2);
    loads << reduced_.boundary, reduced_unit_.boundary;
    if (j + m == 0) {
        response.tangent = S;
        response.force = -loads.col(0);
        response.unit_load = loads.col(1);
        return;
    }
    // Unknowns c = (jumps, multipliers), boundary b. Jumps may lie on the boundary too: B couples multipliers with
    // both.
    const ContactInterface::Rows rows = system_.contact_rows();
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(j + m, j + m), A_cb = Eigen::MatrixXd::Zero(j + m, g),
                    A_bc = Eigen::MatrixXd::Zero(g, j + m);
    A.topLeftCorner(j, j) = S.topLeftCorner(j, j);
    A_cb.topRows(j) = S.topRightCorner(j, g);
    A_bc.leftCols(j) = S.bottomLeftCorner(g, j);
    A.bottomRightCorner(m, m) = rows.diagonal.asDiagonal();
    const Eigen::MatrixXd& B = system_.contact().operator_B();
    std::vector<char> interior(system_.contact().jump_unknowns().size(), 0);
    for (Eigen::Index i = 0; i < j; ++i) {
        const int column = interior_jumps_[static_cast<std::size_t>(i)];
        interior[static_cast<std::size_t>(column)] = 1;
        A.block(0, j, j, m).row(i) = -B.col(column).transpose();
        A.block(j, 0, m, j).col(i) = rows.jump.col(column);
    }
    for (std::size_t column = 0; column < interior.size(); ++column) {
        if (interior[column] != 0) continue;
        const auto& boundary = system_.patch().boundary;
        const auto place =
            std::ranges::lower_bound(boundary, system_.contact().jump_unknowns()[column]) - boundary.begin();
        A_bc.block(0, j, g, m).row(place) = -B.col(static_cast<Eigen::Index>(column)).transpose();
        A_cb.bottomRows(m).col(place) = rows.jump.col(static_cast<Eigen::Index>(column));
    }
    Eigen::MatrixXd b = Eigen::MatrixXd::Zero(j + m, 2);
    b.topRows(j) = loads.topRows(j);
    b.col(0).tail(m) = rows.right_hand_side;
    block_.factor.compute(A);
    block_.inverse_times_boundary = block_.factor.solve(A_cb);
    block_.inverse_times_loads = block_.factor.solve(b);
    if (!block_.inverse_times_loads.allFinite()) throw NumericalFailure("contact block of the zone is singular");
    // Symmetric without friction; to the last bit, so that half of it crosses the wire.
    const Eigen::MatrixXd tangent = S.bottomRightCorner(g, g) - A_bc * block_.inverse_times_boundary;
    response.tangent = 0.5 * (tangent + tangent.transpose());
    loads.bottomRows(g) -= A_bc * block_.inverse_times_loads;
    response.force = -loads.col(0).tail(g);
    response.unit_load = loads.col(1).tail(g);
}

void FineModel::advance_interior() {
    const auto j = std::ssize(interior_jumps_);
    const auto m = static_cast<Eigen::Index>(system_.contact().multipliers());
    const Eigen::VectorXd step = asked_.boundary - gather(system_.displacement(), system_.patch().boundary);
    const Eigen::Vector2d loads(1.0, asked_.load_factor - system_.load_factor());
    Eigen::VectorXd inner(j + m);
    if (j + m > 0) inner = block_.inverse_times_loads * loads - block_.inverse_times_boundary * step;
    Eigen::VectorXd kept(std::ssize(kept_));
    kept << inner.head(j), step;
    const ReducedLoad moving{reduced_.interior + loads[1] * reduced_unit_.interior, reduced_.boundary};
    system_.move(tree_->expand(moving, kept), inner.tail(m));
}

coupling::StepReport FineModel::commit(bool reversal) {
    coupling::StepReport report = system_.commit(reversal);
    report.factor_s = factor_s_;
    return report;
}

void FineModel::rollback() {}  // the next increment starts from what is committed

coupling::ZoneState FineModel::state() { return system_.state(); }

}  // namespace stria::fine
