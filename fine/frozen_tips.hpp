// Tip functions that a tip has left behind: their displacement stays as it was, their unknowns are gone (DESIGN section
// 4).
#pragma once

#include <vector>

#include "coupling/zone_snapshot.hpp"

namespace stria::fine {

class FrozenTips {
public:
    FrozenTips() = default;
    explicit FrozenTips(std::vector<coupling::FrozenTip> tips) : tips_(std::move(tips)) {}

    /// Keeps what a tip's functions are at `displacement` (all unknowns of the mesh).
    void freeze(const EnrichedMesh& mesh, int tip, const Eigen::VectorXd& displacement);

    /// Jump of all frozen displacements at a place on a crack, plus side minus minus side, mm. By place: arc lengths
    /// change where a crack grows at its first point.
    [[nodiscard]] Vec2 jump(int crack, const Vec2& x) const;

    [[nodiscard]] const std::vector<coupling::FrozenTip>& tips() const { return tips_; }

private:
    std::vector<coupling::FrozenTip> tips_;
};

}  // namespace stria::fine
