// The zone as a binary tree of dense fronts (docs/method.md, section 1): geometric bisection down to groups of about
// a dozen elements; a front is recomputed only when an element below it changed.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "common/index_set.hpp"
#include "common/substructure/front_layout.hpp"
#include "common/substructure/substructure.hpp"

namespace stria {

/// Multipliers enter by element matrices [0, -b; -b^T, 0] on (what they act on, themselves), or with a negative
/// diagonal where they are idle. Each is eliminated in the front in which the last of the interior unknowns that it
/// acts on is, after it: there its pivot, -b^T K^-1 b, is negative, and no search for pivots is needed. A front is
/// symmetric where all that lies below it is, and general (LU with pivoting inside the eliminated block) elsewhere.
class FrontTree : public Substructure {
public:
    struct ElementMatrix {
        /// Of a symmetric one both triangles, or the lower one if its unknowns are eliminated, and kept, in its order.
        const Eigen::MatrixXd& values;
        Symmetry symmetry = Symmetry::Symmetric;
    };
    using MatrixOfElement = std::function<ElementMatrix(int element)>;

    using Layout = FrontLayout;

    explicit FrontTree(Layout layout);
    /// With the fronts of another tree where they would be the same. `same`: per element, the one of `old` with the
    /// matrix of its last factoring, -1: none. `old` is of no more use afterwards.
    FrontTree(Layout layout, FrontTree& old, std::span<const int> same);
    ~FrontTree() override;

    /// Refactors the paths from changed elements to the root, and what has not been factored yet. `matrix_of(e)`:
    /// element matrix; `changed[e]`: its matrix differs from that of the last call. Throws NumericalFailure on a
    /// singular pivot block. Same inputs give the same bits, whatever was factored before.
    void factor(const MatrixOfElement& matrix_of, std::span<const char> changed);
    void factor(std::span<const Eigen::MatrixXd> matrices, std::span<const char> changed,
                Symmetry symmetry = Symmetry::Symmetric);

    [[nodiscard]] const Eigen::MatrixXd& tangent() const override;
    /// The same, of a symmetric one the lower triangle only.
    [[nodiscard]] const Eigen::MatrixXd& lower_tangent() const;
    /// Of the tangent.
    [[nodiscard]] Symmetry symmetry() const;
    [[nodiscard]] ReducedLoad reduce(const Eigen::VectorXd& load) const override;
    [[nodiscard]] Eigen::VectorXd expand(const ReducedLoad& load, const Eigen::VectorXd& boundary) const override;

    /// Subtrees whose elements may all rest serve as leaves from now on: factor(), reduce() and expand() leave alone
    /// what is inside them, and their elements do not change. Loads and displacements of what rests are in the
    /// functions below. These elements have not changed since the last factor() that has ended well.
    void rest(const ElementSet& may_rest);
    [[nodiscard]] const ElementSet& resting() const;
    [[nodiscard]] const UnknownSet& inside() const;  // of a subtree that rests

    /// Carries the load that is due on the elements that rest, on all unknowns, onto what is awake. Kept. Subtrees that
    /// have carried the same load before do nothing.
    void carry(const Eigen::VectorXd& load);
    /// What those subtrees do to the unknowns awake once all have moved by `move` since: the carried load - S move.
    [[nodiscard]] Eigen::VectorXd response(const Eigen::VectorXd& move) const;
    /// `move` with the unknowns inside them following the others.
    [[nodiscard]] Eigen::VectorXd follow(const Eigen::VectorXd& move) const;

    /// Fronts in the tree, fronts refactored so far, and those of them that were general (docs/method.md, section 12).
    [[nodiscard]] int fronts() const;
    [[nodiscard]] long refactored() const;
    [[nodiscard]] long refactored_general() const;
    /// Fronts at rest through which a load was carried so far.
    [[nodiscard]] long carried() const;

private:
    struct Tree;
    std::unique_ptr<Tree> tree_;
};

}  // namespace stria
