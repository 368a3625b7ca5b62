#include "fine/contact/contact_block.hpp"

#include "common/error.hpp"

namespace stria::fine {

ContactBlock::Condensed ContactBlock::eliminate(const System& system) {
    const Eigen::Index j = system.jumps, g = system.stiffness.rows() - j, m = system.B.rows();
    const auto singular = [] { return NumericalFailure("contact block of the zone is singular"); };
    if (!jumps_.factor(system.stiffness.topLeftCorner(j, j))) throw singular();
    jump_boundary_ = jumps_.forward(system.stiffness.topRightCorner(j, g));
    jump_loads_ = jumps_.forward(system.loads.topRows(j));
    jump_multipliers_ = jumps_.forward(system.B.leftCols(j).transpose());

    Eigen::MatrixXd F = Eigen::MatrixXd::Zero(m, m);
    add_square_of_transposed(F, 1.0, jump_multipliers_);
    if (!multipliers_.factor(std::move(F))) throw singular();
    const auto V = jump_multipliers_.transpose();
    multiplier_boundary_ = multipliers_.forward(system.B.rightCols(g) - V * jump_boundary_);
    Eigen::MatrixXd pull = -(V * jump_loads_);
    pull.col(0) -= system.h;
    multiplier_loads_ = multipliers_.forward(std::move(pull));

    Condensed result{.stiffness = system.stiffness.bottomRightCorner(g, g), .loads = system.loads.bottomRows(g)};
    add_square_of_transposed(result.stiffness, -1.0, jump_boundary_);
    add_square_of_transposed(result.stiffness, 1.0, multiplier_boundary_);
    mirror_lower(result.stiffness);
    result.loads += multiplier_boundary_.transpose() * multiplier_loads_ - jump_boundary_.transpose() * jump_loads_;
    if (!result.loads.allFinite()) throw singular();
    return result;
}

ContactBlock::Recovered ContactBlock::recover(const Eigen::VectorXd& boundary, double load_factor) const {
    const Eigen::Vector2d loads(1.0, load_factor);
    Recovered result;
    result.multipliers = multipliers_.backward(multiplier_loads_ * loads - multiplier_boundary_ * boundary);
    result.jumps =
        jumps_.backward(jump_loads_ * loads - jump_boundary_ * boundary + jump_multipliers_ * result.multipliers);
    return result;
}

}  // namespace stria::fine
