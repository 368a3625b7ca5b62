// A correction of Newton's method that led too far is given back in part.
#pragma once

#include <cmath>
#include <vector>

#include "coarse/equilibrium/equilibrium.hpp"
#include "common/regula_falsi.hpp"

namespace stria::coarse {

/// Watches the states of one increment. The potential of a hardening body is convex in its displacements, so what is
/// out of balance does less and less work along a correction, and where that work is negative the best part of it lies
/// behind. Full steps are best while they lead anywhere (docs/method.md, section 6). Where they do not, the root of the
/// work is looked for by regula falsi.
class LineSearch {
public:
    /// `state`: just evaluated. What is still to be taken of the last correction, below zero: to be given back; zero:
    /// the next correction is due.
    double further(const Residual& state) {
        if (tries_ == 0) begin(state);
        const double left = start_ > 0.0 ? state.along / start_ : 0.0;
        const bool found = std::abs(left) <= little || (left > 0.0 && !root_.has_passed());
        if (found || !is_stuck() || tries_++ == most) {
            tries_ = 0;
            return 0.0;
        }
        const double from = root_.guess();
        root_.narrow(left);
        return root_.guess() - from;
    }

private:
    void begin(const Residual& state) {
        residuals_.push_back(state.interior);
        start_ = state.along_before;
        root_ = RegulaFalsi();
    }

    // After the corrections so far the residual is no smaller than half of what it was two of them ago.
    [[nodiscard]] bool is_stuck() const {
        const std::size_t n = residuals_.size();
        return n > full_steps && residuals_[n - 1] > 0.5 * residuals_[n - 3];
    }

    static constexpr std::size_t full_steps = 6;
    static constexpr int most = 5;  // parts of one correction
    static constexpr double little = 0.5;
    std::vector<double> residuals_;  // of the states that corrections began or ended at
    int tries_ = 0;
    double start_ = 0.0;  // the work that the correction began with
    RegulaFalsi root_;    // of what is left of it, in parts of the correction
};

}  // namespace stria::coarse
