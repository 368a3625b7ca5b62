// Newton's method that goes to and fro between two states takes half a step.
#pragma once

#include <vector>

namespace stria {

/// Watches the residuals of one increment. Full steps are best while they lead anywhere (NUMERICS 3); where after some
/// of them the residual is no smaller than half of what it was two iterations ago, the two last states face each other
/// across a kink of the piecewise linear problem, and the middle between them is nearer.
class Damping {
public:
    void begin() { residuals_.clear(); }

    /// What of the next correction is to be taken; `residual`: of the state just evaluated.
    double factor(double residual) {
        residuals_.push_back(residual);
        const std::size_t n = residuals_.size();
        return n > full_steps && residuals_[n - 1] > 0.5 * residuals_[n - 3] ? 0.5 : 1.0;
    }

private:
    static constexpr std::size_t full_steps = 6;
    std::vector<double> residuals_;
};

}  // namespace stria
