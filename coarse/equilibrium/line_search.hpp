// A correction of Newton's method that led too far is given back in part.
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "coarse/equilibrium/equilibrium.hpp"

namespace stria::coarse {

/// Watches the states of one increment. The potential of a hardening body is convex in its displacements, so what is
/// out of balance does less and less work along a correction, and where that work is negative the best part of it lies
/// behind. Full steps are best while they lead anywhere (docs/method.md, section 6). Where they do not, the root of the
/// work is looked for by regula falsi in its Illinois form (Dowell and Jarratt, BIT 11 (1971) 168).
class LineSearch {
public:
    /// `state`: just evaluated. What is still to be taken of the last correction, below zero: to be given back; zero:
    /// the next correction is due.
    double further(const Residual& state) {
        if (tries_ == 0) begin(state);
        const double left = start_ > 0.0 ? state.along / start_ : 0.0;
        const bool found = std::abs(left) <= little || (left > 0.0 && !beyond_);
        if (found || !is_stuck() || tries_++ == most) {
            tries_ = 0;
            return 0.0;
        }
        narrow(left);
        const double from = part_;
        part_ = before_.part + (beyond_->part - before_.part) * before_.left / (before_.left - beyond_->left);
        return part_ - from;
    }

private:
    struct Point {
        double part;  // of the correction
        double left;  // of the work that it began with
    };

    void begin(const Residual& state) {
        residuals_.push_back(state.interior);
        start_ = state.along_before;
        part_ = 1.0;
        before_ = {0.0, 1.0};
        beyond_.reset();
        last_side_ = 0;
    }

    // The root stays between the two ends; one that stays twice counts half.
    void narrow(double left) {
        const int side = left > 0.0 ? 1 : -1;
        if (side > 0) {
            before_ = {part_, left};
            if (last_side_ == side) beyond_->left *= 0.5;
        } else {
            beyond_ = {part_, left};
            if (last_side_ == side) before_.left *= 0.5;
        }
        last_side_ = side;
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
    int tries_ = 0, last_side_ = 0;
    double start_ = 0.0, part_ = 1.0;
    Point before_{0.0, 1.0};
    std::optional<Point> beyond_;
};

}  // namespace stria::coarse
