// What keeps the displacement as it was where a growing crack changes its functions (docs/method.md, section 7): tip
// functions that a tip has left behind, and jumps that old unknowns would make in elements newly cut.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "coupling/zone_snapshot.hpp"

namespace stria::fine {

class FrozenTips {
public:
    FrozenTips() = default;
    explicit FrozenTips(std::vector<coupling::FrozenTip> tips);

    /// Keeps what a tip's functions are at `displacement` (all unknowns of the mesh).
    void freeze(const EnrichedMesh& mesh, int tip, const Eigen::VectorXd& displacement);

    /// A crack that turns back cuts elements beside its old nodes: what their Heaviside functions would open there, at
    /// `displacement` (of `next`), is taken off.
    void keep_closed(const EnrichedMesh& before, const EnrichedMesh& next, const Eigen::VectorXd& displacement);

    /// Jump of all frozen displacements at a place on a crack, plus side minus minus side, mm. By place: arc lengths
    /// change where a crack grows at its first point.
    [[nodiscard]] Vec2 jump(int crack, const Vec2& x) const;

    /// Its derivative along the crack's tangent.
    [[nodiscard]] Vec2 slope(int crack, const Vec2& x) const;

    /// The same as what the functions of each node make of it, by its id.
    struct Share {
        int node_id;
        Vec2 jump, slope;  // slope: along the crack's tangent
    };
    [[nodiscard]] std::vector<Share> shares_of_jump(int crack, const Vec2& x) const;

    [[nodiscard]] const std::vector<coupling::FrozenTip>& tips() const { return tips_; }

private:
    void keep(coupling::FrozenTip tip);

    std::vector<coupling::FrozenTip> tips_;
    std::vector<Eigen::AlignedBox2d> boxes_;  // about the elements of each: a long way leaves many behind
    std::vector<std::vector<int>> node_ids_;  // of each unknown of each
};

}  // namespace stria::fine
