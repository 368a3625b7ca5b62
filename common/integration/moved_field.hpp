// A field that goes along with the tips of growing cracks: what is known about the old tips as a guess of what will be
// about the new ones.
#pragma once

#include "common/enrichment/enriched_mesh.hpp"
#include "common/linear/sparse.hpp"

namespace stria {

class MovedField {
public:
    /// Both meshes have the same tips in the same order, and no tip functions (can_move()). At each node of `to` the
    /// field is that of `from` as far behind as the nearest tip has moved since; where `from` has no element there,
    /// that of its nearest node.
    MovedField(const EnrichedMesh& from, const EnrichedMesh& to);

    /// The mesh about each tip comes to lie on itself, or nearly: cracks grow by whole elements along rows of them.
    static bool can_move(const EnrichedMesh& from, const EnrichedMesh& to);

    /// On all unknowns of `to`, from those of `from`.
    [[nodiscard]] Eigen::VectorXd of(const Eigen::VectorXd& values) const { return weights_ * values; }

private:
    SparseRows weights_;
};

/// How far the tip nearest to a place has moved, mm.
Vec2 move_of_nearest_tip(const EnrichedMesh& from, const EnrichedMesh& to, const Vec2& x);

}  // namespace stria
