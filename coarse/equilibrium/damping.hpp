// Newton's method that goes to and fro between two states takes parts of a step.
#pragma once

#include <array>
#include <vector>

namespace stria::coarse {

/// Watches the residuals of one increment. Full steps are best while they lead anywhere (docs/method.md, section 6);
/// where after some of them the residual is no smaller than half of what it was two iterations ago, the two last states
/// face each other across a kink of the piecewise linear problem, and the middle between them is nearer. Where halves
/// go to and fro as well, quarters lead out of it.
class Damping {
public:
    /// What of the next correction is to be taken; `residual`: of the state just evaluated.
    double factor(double residual) {
        residuals_.push_back(residual);
        const std::size_t n = residuals_.size();
        if (n <= full_steps || residuals_[n - 1] <= 0.5 * residuals_[n - 3]) return 1.0;
        constexpr std::array parts{0.5, 0.5, 0.25, 0.75};
        return parts[(n - full_steps - 1) % parts.size()];
    }

private:
    static constexpr std::size_t full_steps = 6;
    std::vector<double> residuals_;
};

}  // namespace stria::coarse
