// The displacement that one mesh has at a node of another, as a combination of its unknowns, on either side of a crack.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "common/enrichment/element_basis.hpp"
#include "common/integration/cut_element.hpp"

namespace stria {

/// What an unknown counts; `unknown` is that of the component x, the next one that of y.
struct Share {
    int unknown;
    double weight;
};
using Shares = std::vector<Share>;

/// mm, of displacements in mm.
Vec2 sum_of(const Shares& shares, const Eigen::VectorXd& values);

/// The displacement in an element, each side of a crack inside it continued over the whole of it.
class ElementField {
public:
    /// `cut`: the piece of a crack inside the element, or null. The mesh must outlive it.
    ElementField(const EnrichedMesh& mesh, int element, const CrackPiece* cut);

    [[nodiscard]] bool is_cut() const { return sides_.has_value(); }
    /// Of an element that a crack runs along: +1, -1; else 0.
    [[nodiscard]] int own_side() const { return own_side_; }
    /// Side of a place in a cut element, or on its boundary.
    [[nodiscard]] int side_of(const Vec2& x) const;
    [[nodiscard]] Shares on_side(const Vec2& x, int side) const;

private:
    ElementBasis basis_;
    int own_side_;
    std::optional<CutElement> sides_;
};

/// What the unknowns of a node are, as the elements tell that hold its place. One whose place is on a crack that runs
/// along element edges has its displacement from one side, and its jump from both.
class FieldAtNode {
public:
    /// `terms`: of the node.
    FieldAtNode(const Vec2& x, const std::vector<Term>& terms);

    void add(const ElementField& element);

    /// On the node's own side where elements tell that apart. Nothing where none tells.
    [[nodiscard]] const std::optional<Shares>& standard() const;
    /// Half of the jump: the amplitude of a Heaviside term. Nothing where only one side is known.
    [[nodiscard]] std::optional<Shares> half_jump() const;

private:
    Vec2 x_;
    int own_side_ = 0;  // of a node that jumps
    std::optional<Shares> without_jump_;
    std::array<std::optional<Shares>, 2> sides_;  // minus, plus
};

}  // namespace stria
