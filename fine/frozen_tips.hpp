// Tip functions that a tip has left behind: their displacement stays as it was, their unknowns are gone (DESIGN section
// 4).
#pragma once

#include <vector>

#include "common/fem/enriched_mesh.hpp"

namespace stria::fine {

class FrozenTips {
public:
    /// Keeps what a tip's functions are at `displacement` (all unknowns of the mesh).
    void freeze(const EnrichedMesh& mesh, int tip, const Eigen::VectorXd& displacement);

    /// Jump of all frozen displacements at an arc length of a crack, plus side minus minus side, mm.
    [[nodiscard]] Vec2 jump(int crack, double s) const;

    [[nodiscard]] bool empty() const { return tips_.empty(); }

private:
    struct Frozen {
        EnrichedMesh mesh;             // the elements that see the functions
        Eigen::VectorXd displacement;  // zero but for them
        int crack;
        double first_s, last_s;
    };
    std::vector<Frozen> tips_;
};

}  // namespace stria::fine
