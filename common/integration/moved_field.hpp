// A field that goes along with the tips of growing cracks: what is known about the old tips as a guess of what will be
// about the new ones.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "common/enrichment/enriched_mesh.hpp"

namespace stria {

/// How far fields go along with each tip, mm: as far as it has moved, to whole elements, so that the mesh about it
/// comes to lie on itself. Between nodes a field as steep as that about a tip would be no guess.
struct TipMoves {
    /// Of the same tips in the same order. Nothing where the mesh about one of them has no such move, or where there
    /// are tip functions.
    static std::optional<TipMoves> between(const EnrichedMesh& from, const EnrichedMesh& to);

    /// No tip has moved by an element.
    [[nodiscard]] bool are_none() const;

    /// That of the tip nearest to a place.
    [[nodiscard]] Vec2 of_nearest_tip(const Vec2& x) const;

    std::vector<Vec2> tips, moves;  // one per tip: where it is now
};

class MovedField {
public:
    /// At each node of `to` the field is that of `from` as far behind as it goes along with the nearest tip; where
    /// `from` has no element there, that of its nearest node. `moves`: between them.
    MovedField(const EnrichedMesh& from, const EnrichedMesh& to, const TipMoves& moves);

    /// On all unknowns of `to`, from those of `from`, a column for each of several such fields.
    [[nodiscard]] Eigen::MatrixXd of(const Eigen::MatrixXd& values) const;

    /// What an unknown of `to` has of one of `from`: those of the component x, the next ones have the same.
    struct Part {
        int unknown, before;
        double weight;
    };

private:
    int unknowns_;
    std::vector<Part> parts_;
};

}  // namespace stria
