#include "common/substructure/front_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "common/error.hpp"
#include "common/index.hpp"
#include "common/substructure/assembly_tree.hpp"
#include "common/substructure/front.hpp"
#include "common/substructure/front_passes.hpp"
#include "common/substructure/subtrees_at_rest.hpp"

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

struct FrontTree::Tree {
    /// `old`: null, or what fronts are taken over from.
    explicit Tree(const Layout& layout, Tree* old = nullptr, std::span<const int> same = {});

    [[nodiscard]] Symmetry symmetry_below(const AssemblyTree::Node& node, const MatrixOfElement& matrix_of) const;
    void refactor(std::size_t index, const MatrixOfElement& matrix_of);
    [[noreturn]] void fail(const AssemblyTree::Node& node, int place) const;

    std::size_t elements;
    AssemblyTree plan;
    std::vector<Front> fronts;
    SubtreesAtRest at_rest;
    std::vector<char> dirty;
    std::vector<char> known;  // per front: it has been factored
    bool factored = false, mirrored = false;
    bool complete = false;  // each front has been factored; those below which nothing changes serve what rests
    long refactored = 0, refactored_general = 0;
};

FrontTree::Tree::Tree(const Layout& layout, Tree* old, std::span<const int> same)
    : elements(layout.element_unknowns.size()), plan(layout), at_rest(plan, elements), dirty(plan.nodes.size()),
      known(plan.nodes.size()) {
    require(old == nullptr || same.size() == elements, "front tree: a counterpart, or none, for each element");
    const bool takes_over = old != nullptr && old->factored;
    const std::vector<int> counterparts =
        takes_over ? plan.counterparts(old->plan, same) : std::vector<int>(plan.nodes.size(), -1);
    fronts.reserve(plan.nodes.size());
    for (std::size_t index = 0; index < plan.nodes.size(); ++index) {
        const AssemblyTree::Node& node = plan.nodes[index];
        known[index] = counterparts[index] >= 0 ? 1 : 0;
        if (counterparts[index] >= 0)
            fronts.push_back(std::move(old->fronts[at(counterparts[index])]));
        else
            fronts.emplace_back(node.eliminated, node.multipliers, static_cast<int>(node.kept.size()));
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
    at_rest.forget(index);
    if (const int place = front.eliminate(tolerance); place >= 0) fail(node, place);
    ++refactored;
    if (front.symmetry() == Symmetry::General) ++refactored_general;
}

void FrontTree::Tree::fail(const AssemblyTree::Node& node, int place) const {
    const auto unknown = std::ranges::find(plan.rank, node.first_rank + place) - plan.rank.begin();
    throw NumericalFailure("the tangent of the zone is singular at its unknown " + std::to_string(unknown));
}

FrontTree::FrontTree(Layout layout) : tree_(std::make_unique<Tree>(layout)) {}
FrontTree::FrontTree(Layout layout, FrontTree& old, std::span<const int> same)
    : tree_(std::make_unique<Tree>(layout, old.tree_.get(), same)) {}
FrontTree::~FrontTree() = default;

void FrontTree::factor(std::span<const Eigen::MatrixXd> matrices, std::span<const char> changed, Symmetry symmetry) {
    require(matrices.size() == tree_->elements, "front tree: one matrix an element");
    factor([&](int element) { return ElementMatrix{matrices[at(element)], symmetry}; }, changed);
}

void FrontTree::factor(const MatrixOfElement& matrix_of, std::span<const char> changed) {
    Tree& tree = *tree_;
    require(changed.size() == tree.elements, "front tree: one flag an element");
    // Until this call ends well nothing in the tree can be trusted: a throw leaves everything to be refactored.
    tree.factored = false;
    const std::vector<char> known = std::exchange(tree.known, std::vector<char>(tree.fronts.size(), 0));
    for (std::size_t index = 0; index < tree.fronts.size(); ++index) {
        const AssemblyTree::Node& node = tree.plan.nodes[index];
        const auto is_changed = [&](int element) { return changed[at(element)] != 0; };
        const auto is_dirty = [&](int child) { return child >= 0 && tree.dirty[at(child)] != 0; };
        const bool dirty = known[index] == 0 || std::ranges::any_of(node.elements, is_changed) ||
                           std::ranges::any_of(node.children, is_dirty);
        tree.dirty[index] = dirty ? 1 : 0;
        if (dirty) tree.refactor(index, matrix_of);
    }
    if (tree.dirty.back() != 0) tree.mirrored = false;
    std::ranges::fill(tree.known, char{1});
    tree.factored = tree.complete = true;
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
    Eigen::VectorXd y = tree.plan.by_rank(load), buffer(tree.plan.widest);
    for (std::size_t index = 0; index < tree.fronts.size(); ++index)
        if (tree.at_rest.is_awake(index)) forward(tree.plan.nodes[index], tree.fronts[index], y, buffer);
    return {.interior = y.head(tree.plan.interior), .boundary = y.tail(y.size() - tree.plan.interior)};
}

Eigen::VectorXd FrontTree::expand(const ReducedLoad& load, const Eigen::VectorXd& boundary) const {
    const Tree& tree = *tree_;
    require(tree.factored, "front tree: factor() before expand()");
    require(load.interior.size() == tree.plan.interior && boundary.size() == load.boundary.size(),
            "front tree: expand() wants what reduce() gave");
    Eigen::VectorXd x(std::ssize(tree.plan.rank)), buffer(tree.plan.widest);
    x << load.interior, boundary;
    for (std::size_t index = tree.fronts.size(); index-- > 0;)
        if (tree.at_rest.is_awake(index)) backward(tree.plan.nodes[index], tree.fronts[index], x, buffer);
    return tree.plan.by_unknown(x);
}

void FrontTree::rest(const ElementSet& may_rest) {
    require(tree_->complete && at(may_rest.size()) == tree_->elements,
            "front tree: factor() before rest(), a set of its elements");
    tree_->at_rest.rest(may_rest);
}

const ElementSet& FrontTree::resting() const { return tree_->at_rest.elements(); }
const UnknownSet& FrontTree::inside() const { return tree_->at_rest.inside(); }

void FrontTree::carry(const Eigen::VectorXd& load) { tree_->at_rest.carry(tree_->plan.by_rank(load), tree_->fronts); }

Eigen::VectorXd FrontTree::response(const Eigen::VectorXd& move) const {
    const AssemblyTree& plan = tree_->plan;
    return plan.by_unknown(tree_->at_rest.response(plan.by_rank(move), tree_->fronts));
}

Eigen::VectorXd FrontTree::follow(const Eigen::VectorXd& move) const {
    const AssemblyTree& plan = tree_->plan;
    return plan.by_unknown(tree_->at_rest.follow(plan.by_rank(move), tree_->fronts));
}

int FrontTree::fronts() const { return static_cast<int>(tree_->fronts.size()); }
long FrontTree::refactored() const { return tree_->refactored; }
long FrontTree::refactored_general() const { return tree_->refactored_general; }
long FrontTree::carried() const { return tree_->at_rest.carried(); }

}  // namespace stria
