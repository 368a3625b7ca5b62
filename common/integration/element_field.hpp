// The displacement in an element as a combination of its unknowns, each side of the crack continued over the whole of
// it.
#pragma once

#include <optional>
#include <vector>

#include "common/enrichment/element_basis.hpp"
#include "common/integration/cut_element.hpp"

namespace stria {

class ElementField {
public:
    /// `cut`: the piece of a crack inside the element, or null. The mesh must outlive it.
    ElementField(const EnrichedMesh& mesh, int element, const CrackPiece* cut);

    /// What an unknown counts; `unknown` is that of the component x, the next one that of y.
    struct Share {
        int unknown;
        double weight;
    };

    [[nodiscard]] bool is_cut() const { return sides_.has_value(); }
    [[nodiscard]] std::vector<Share> at_place(const Vec2& x) const;
    /// Half of the jump, continued to `x`: the amplitude of a Heaviside term. Of a cut element.
    [[nodiscard]] std::vector<Share> half_jump(const Vec2& x) const;

private:
    void add(const Vec2& x, int side, double factor, std::vector<Share>& shares) const;

    ElementBasis basis_;
    std::optional<CutElement> sides_;
};

/// mm, of displacements in mm.
Vec2 sum_of(const std::vector<ElementField::Share>& shares, const Eigen::VectorXd& values);

}  // namespace stria
