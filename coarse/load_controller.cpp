#include "coarse/load_controller.hpp"

#include <algorithm>
#include <cmath>

namespace stria::coarse {

LoadController::LoadController(const LoadSection& load, const SolverSection& solver) : max_cuts_(solver.max_cuts) {
    double reached = 0.0;
    int cycle = 0;
    const int half = load.steps / 2;
    for (const LoadBlock& block : load.blocks) {
        maxima_.push_back(block.max);
        // The first ramp belongs to no cycle, a leg from one block's maximum to the next one's to the cycle it leads
        // to.
        if (block.max != reached) append_leg(cycle == 0 ? 0 : cycle + 1, reached, block.max, half);
        for (int k = 0; k < block.cycles; ++k) {
            ++cycle;
            append_leg(cycle, block.max, block.min, half);
            targets_.back().at_minimum = true;
            append_leg(cycle, block.min, block.max, half);
            targets_.back().at_maximum = targets_.back().ends_cycle = true;
        }
        reached = block.max;
    }
    mark_reversals();
}

// A half cycle ends where the load turns, not where a block does.
void LoadController::mark_reversals() {
    double before = 0.0;
    for (std::size_t k = 0; k < targets_.size(); ++k) {
        const bool last = k + 1 == targets_.size();
        targets_[k].reversal =
            last || (targets_[k].factor - before) * (targets_[k + 1].factor - targets_[k].factor) < 0.0;
        before = targets_[k].factor;
    }
}

void LoadController::append_leg(int cycle, double from, double to, int steps) {
    const auto first = std::ssize(targets_);
    for (int k = 1; k <= steps; ++k) {
        // The last is exact: later legs start from the same number.
        const double factor = k == steps ? to : from + (to - from) * k / steps;
        targets_.push_back({cycle, factor, false, k == steps && to > from, false, false, false});
    }
    const auto nearest =
        std::min_element(targets_.begin() + first, targets_.end(),
                         [](const Target& a, const Target& b) { return std::abs(a.factor) < std::abs(b.factor); });
    if (from * to < 0.0) nearest->at_zero = true;
}

std::optional<LoadStep> LoadController::next() const {
    if (target_ >= targets_.size()) return std::nullopt;
    const Target& target = targets_[target_];
    const double whole = target_ == 0 ? target.factor : target.factor - targets_[target_ - 1].factor;
    double factor = factor_ + fraction_ * whole;
    const bool arrives = std::abs(target.factor - factor_) <= fraction_ * std::abs(whole) * (1.0 + 1e-9);
    if (arrives) factor = target.factor;
    LoadStep step;
    step.cycle = target.cycle;
    step.factor = factor;
    if (last_increment_ * (factor - factor_) > 0.0) step.predictor = (factor - factor_) / last_increment_;
    if (arrives) {
        step.reversal = target.reversal;
        step.at_maximum = target.at_maximum;
        step.at_minimum = target.at_minimum;
        step.at_zero = target.at_zero;
        step.ends_cycle = target.ends_cycle;
    }
    return step;
}

void LoadController::accepted() {
    const LoadStep step = *next();
    last_increment_ = step.factor - factor_;
    factor_ = step.factor;
    if (factor_ == targets_[target_].factor) ++target_;
    if (consecutive_cuts_ > 0) {
        fraction_ = std::min(1.0, 2.0 * fraction_);
        --consecutive_cuts_;
    }
}

bool LoadController::cut() {
    if (consecutive_cuts_ >= max_cuts_) return false;
    ++consecutive_cuts_;
    ++cuts_;
    fraction_ /= 2.0;
    return true;
}

double LoadController::largest_maximum() const { return maxima_.empty() ? 0.0 : std::ranges::max(maxima_); }

}  // namespace stria::coarse
