#include "common/substructure/front_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "common/error.hpp"
#include "common/index.hpp"
#include "common/substructure/front_tree_parts.hpp"

namespace stria {

namespace {

/// A sum tells, which is three times as fast as to look at each number.
bool is_finite(const Eigen::MatrixXd& matrix, Symmetry symmetry) {
    if (symmetry == Symmetry::General) return std::isfinite(matrix.sum());
    double sum = 0.0;
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) sum += matrix.col(j).tail(matrix.rows() - j).sum();
    return std::isfinite(sum);
}

}  // namespace

FrontTree::Tree::Tree(const Layout& layout)
    : elements(layout.element_unknowns.size()), plan(layout), dirty(plan.nodes.size()),
      rest(plan.nodes.size(), Rest::Awake), resting(elements), inside(plan.rank.size()), carried_by(plan.nodes.size()),
      carried(Eigen::VectorXd::Zero(std::ssize(plan.rank))), due(carried), carried_inside(carried) {
    fronts.reserve(plan.nodes.size());
    for (const AssemblyTree::Node& node : plan.nodes) {
        first_below.push_back(node.leaf() ? first_below.size() : first_below[at(node.children[0])]);
        const int kept = static_cast<int>(node.kept.size());
        fronts.emplace_back(node.eliminated, node.multipliers, kept);
        widest = std::max(widest, kept);
    }
}

Symmetry FrontTree::Tree::symmetry_below(const AssemblyTree::Node& node, const MatrixOfElement& matrix_of) const {
    const auto is_general = [&](int element) { return matrix_of(element).symmetry == Symmetry::General; };
    const auto child_is_general = [&](int child) {
        return child >= 0 && fronts[at(child)].symmetry() == Symmetry::General;
    };
    const bool general =
        std::ranges::any_of(node.elements, is_general) || std::ranges::any_of(node.children, child_is_general);
    return general ? Symmetry::General : Symmetry::Symmetric;
}

void FrontTree::Tree::refactor(std::size_t index, const MatrixOfElement& matrix_of) {
    const AssemblyTree::Node& node = plan.nodes[index];
    Front& front = fronts[index];
    front.clear(symmetry_below(node, matrix_of));
    for (std::size_t i = 0; i < node.elements.size(); ++i) {
        const auto& [matrix, symmetry] = matrix_of(node.elements[i]);
        const int order = node.from_elements[i].order;
        require(matrix.rows() == order && matrix.cols() == order, "front tree: element matrix of the wrong order");
        // Where a number is not finite no pivot need tell: it may stand between boundary unknowns.
        if (!is_finite(matrix, symmetry)) {
            throw NumericalFailure("the tangent of an element of the zone is not finite: element " +
                                   std::to_string(node.elements[i]));
        }
        front.add(matrix, node.from_elements[i]);
    }
    if (!node.leaf()) {
        for (std::size_t side = 0; side < 2; ++side) {
            Front& child = fronts[at(node.children[side])];
            if (front.symmetry() == Symmetry::General) child.mirror();
            front.add(child.schur(), node.from_children[side]);
        }
    }
    // What rounding leaves of a pivot that should be zero grows with the number of eliminations (see SparseLeaf).
    const double tolerance = static_cast<double>(plan.rank.size()) * std::numeric_limits<double>::epsilon();
    carried_by[index].known = false;
    if (const int place = front.eliminate(tolerance); place >= 0) fail(node, place);
    ++refactored;
    if (front.symmetry() == Symmetry::General) ++refactored_general;
}

void FrontTree::Tree::fail(const AssemblyTree::Node& node, int place) const {
    const auto unknown = std::ranges::find(plan.rank, node.first_rank + place) - plan.rank.begin();
    throw NumericalFailure("the tangent of the zone is singular at its unknown " + std::to_string(unknown));
}

Eigen::VectorXd FrontTree::Tree::by_rank(const Eigen::VectorXd& by_unknown) const {
    Eigen::VectorXd y(by_unknown.size());
    for (std::size_t i = 0; i < plan.rank.size(); ++i) y[plan.rank[i]] = by_unknown[static_cast<Eigen::Index>(i)];
    return y;
}

Eigen::VectorXd FrontTree::Tree::by_unknown(const Eigen::VectorXd& by_rank) const {
    Eigen::VectorXd x(by_rank.size());
    for (std::size_t i = 0; i < plan.rank.size(); ++i) x[static_cast<Eigen::Index>(i)] = by_rank[plan.rank[i]];
    return x;
}

void FrontTree::Tree::forward(std::size_t index, Eigen::VectorXd& y, Eigen::VectorXd& buffer) const {
    const AssemblyTree::Node& node = plan.nodes[index];
    auto kept = buffer.head(std::ssize(node.kept));
    gather_at(y, node.kept, kept);
    fronts[index].forward(y.segment(node.first_rank, node.eliminated), kept);
    scatter_at(kept, node.kept, y);
}

void FrontTree::Tree::backward(Eigen::VectorXd& x, bool awake) const {
    Eigen::VectorXd buffer(widest);
    for (std::size_t index = fronts.size(); index-- > 0;) {
        if ((rest[index] == Rest::Awake) != awake) continue;
        const AssemblyTree::Node& node = plan.nodes[index];
        auto kept = buffer.head(std::ssize(node.kept));
        gather_at(x, node.kept, kept);
        fronts[index].backward(x.segment(node.first_rank, node.eliminated), kept);
    }
}

FrontTree::FrontTree(Layout layout) : tree_(std::make_unique<Tree>(layout)) {}
FrontTree::~FrontTree() = default;

void FrontTree::factor(std::span<const Eigen::MatrixXd> matrices, std::span<const char> changed, Symmetry symmetry) {
    require(matrices.size() == tree_->elements, "front tree: one matrix an element");
    factor([&](int element) { return ElementMatrix{matrices[at(element)], symmetry}; }, changed);
}

void FrontTree::factor(const MatrixOfElement& matrix_of, std::span<const char> changed) {
    Tree& tree = *tree_;
    require(changed.size() == tree.elements, "front tree: one flag an element");
    // Until this call ends well nothing in the tree can be trusted: a throw leaves everything to be refactored.
    const bool everything = !std::exchange(tree.factored, false);
    for (std::size_t index = 0; index < tree.fronts.size(); ++index) {
        const AssemblyTree::Node& node = tree.plan.nodes[index];
        const auto is_changed = [&](int element) { return changed[at(element)] != 0; };
        const auto is_dirty = [&](int child) { return child >= 0 && tree.dirty[at(child)] != 0; };
        const bool dirty = everything || std::ranges::any_of(node.elements, is_changed) ||
                           std::ranges::any_of(node.children, is_dirty);
        tree.dirty[index] = dirty ? 1 : 0;
        if (dirty) tree.refactor(index, matrix_of);
    }
    if (tree.dirty.back() != 0) tree.mirrored = false;
    tree.factored = true;
}

const Eigen::MatrixXd& FrontTree::tangent() const {
    const Eigen::MatrixXd& tangent = lower_tangent();
    if (!std::exchange(tree_->mirrored, true)) tree_->fronts.back().mirror();
    return tangent;
}

const Eigen::MatrixXd& FrontTree::lower_tangent() const {
    require(tree_->factored, "front tree: factor() before tangent()");
    return tree_->fronts.back().schur();
}

Symmetry FrontTree::symmetry() const { return tree_->fronts.back().symmetry(); }

ReducedLoad FrontTree::reduce(const Eigen::VectorXd& load) const {
    const Tree& tree = *tree_;
    require(tree.factored, "front tree: factor() before reduce()");
    require(load.size() == std::ssize(tree.plan.rank), "front tree: a load on all unknowns");
    Eigen::VectorXd y = tree.by_rank(load), buffer(tree.widest);
    for (std::size_t index = 0; index < tree.fronts.size(); ++index)
        if (tree.rest[index] == Tree::Rest::Awake) tree.forward(index, y, buffer);
    return {.interior = y.head(tree.plan.interior), .boundary = y.tail(y.size() - tree.plan.interior)};
}

Eigen::VectorXd FrontTree::expand(const ReducedLoad& load, const Eigen::VectorXd& boundary) const {
    const Tree& tree = *tree_;
    require(tree.factored, "front tree: factor() before expand()");
    require(load.interior.size() == tree.plan.interior && boundary.size() == load.boundary.size(),
            "front tree: expand() wants what reduce() gave");
    Eigen::VectorXd x(std::ssize(tree.plan.rank));
    x << load.interior, boundary;
    tree.backward(x, true);
    return tree.by_unknown(x);
}

int FrontTree::fronts() const { return static_cast<int>(tree_->fronts.size()); }
long FrontTree::refactored() const { return tree_->refactored; }
long FrontTree::refactored_general() const { return tree_->refactored_general; }
long FrontTree::carried() const { return tree_->carried_through; }

}  // namespace stria
