#include "coarse/load_controller.hpp"

#include <algorithm>
#include <cmath>

namespace stria::coarse {

LoadController::LoadController(const LoadSection& load, const SolverSection& solver)
    : control_(load.control), remembered_(remembered_increments(load.steps)), max_cuts_(solver.max_cuts) {
    double reached = 0.0;
    int cycle = 0;
    for (const LoadBlock& block : load.blocks) {
        // The first ramp belongs to no cycle, a leg from one block's maximum to the next one's to the cycle it leads
        // to.
        if (block.max != reached) append_leg(cycle == 0 ? 0 : cycle + 1, reached, block.max, load);
        for (int k = 0; k < block.cycles; ++k) {
            ++cycle;
            append_leg(cycle, block.max, block.min, load);
            stops_.back().at_minimum = true;
            append_leg(cycle, block.min, block.max, load);
            stops_.back().at_maximum = stops_.back().ends_cycle = true;
        }
        reached = block.max;
    }
    mark_reversals();
}

// A half cycle ends where the load turns, not where a block does.
void LoadController::mark_reversals() {
    double before = 0.0;
    for (std::size_t k = 0; k < stops_.size(); ++k) {
        const bool last = k + 1 == stops_.size();
        stops_[k].reversal = last || (stops_[k].value - before) * (stops_[k + 1].value - stops_[k].value) < 0.0;
        before = stops_[k].value;
    }
}

void LoadController::append_leg(int cycle, double from, double to, const LoadSection& load) {
    const auto first = std::ssize(stops_);
    const int steps = load.steps / 2;
    for (int k = 1; k <= steps; ++k) {
        const double way = std::pow(static_cast<double>(k) / steps, load.grading);
        // The last is exact: later legs start from the same number.
        const double value = k == steps ? to : from + (to - from) * way;
        stops_.push_back({cycle, value, false, k == steps && to > from, false, false, false});
    }
    const auto nearest = std::min_element(stops_.begin() + first, stops_.end(), [](const Stop& a, const Stop& b) {
        return std::abs(a.value) < std::abs(b.value);
    });
    if (from * to < 0.0) nearest->at_zero = true;
}

std::optional<LoadStep> LoadController::next() const {
    if (stop_ >= stops_.size()) return std::nullopt;
    const Stop& stop = stops_[stop_];
    const double whole = stop_ == 0 ? stop.value : stop.value - stops_[stop_ - 1].value;
    double value = reached_ + fraction_ * whole;
    const bool arrives = std::abs(stop.value - reached_) <= fraction_ * std::abs(whole) * (1.0 + 1e-9);
    if (arrives) value = stop.value;
    LoadStep step;
    step.cycle = stop.cycle;
    step.target = {control_, value};
    step.predictor = predictor(stop.cycle, value);
    if (arrives) {
        step.reversal = stop.reversal;
        step.at_maximum = stop.at_maximum;
        step.at_minimum = stop.at_minimum;
        step.at_zero = stop.at_zero;
        step.ends_cycle = stop.ends_cycle;
    }
    return step;
}

Predictor LoadController::predictor(int cycle, double to) const {
    const double increment = to - reached_, same = 1e-9 * std::abs(increment);
    // The ramp is no cycle: virgin material flows where it will later unload and reload without.
    const auto twin = std::ranges::find_if(taken_, [&](const Taken& taken) {
        return taken.cycle > 0 && taken.cycle < cycle && std::abs(taken.from - reached_) <= same &&
               std::abs(taken.to - to) <= same;
    });
    if (twin != taken_.end()) return {1.0, static_cast<int>(twin - taken_.begin()) + 1};
    if (taken_.empty()) return {};
    const double last = taken_.front().to - taken_.front().from;
    return last * increment > 0.0 ? Predictor(increment / last) : Predictor();
}

void LoadController::accepted() {
    const LoadStep step = *next();
    taken_.push_front({step.cycle, reached_, step.target.value});
    if (taken_.size() > remembered_) taken_.pop_back();
    reached_ = step.target.value;
    if (reached_ == stops_[stop_].value) ++stop_;
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

}  // namespace stria::coarse
