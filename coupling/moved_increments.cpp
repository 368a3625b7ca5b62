#include "coupling/moved_increments.hpp"

#include <optional>

namespace stria::coupling {

MovedIncrements moved_increments(const EnrichedMesh& before, const EnrichedMesh& next,
                                 const std::function<Eigen::MatrixXd()>& increments) {
    const std::optional<TipMoves> moves = TipMoves::between(before, next);
    if (!moves) return {};
    return {*moves, MovedField(before, next, *moves).of(increments())};
}

}  // namespace stria::coupling
