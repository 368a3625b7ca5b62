#include "coarse/load/load_controller.hpp"

#include <algorithm>
#include <cmath>

namespace stria::coarse {

LoadController::LoadController(const LoadSection& load, const SolverSection& solver)
    : control_(load.control == Control::Displacement ? Control::Displacement : Control::Load), legs_(legs(load)),
      steps_(load.steps / 2), grading_(load.grading), remembered_(remembered_increments(load.steps)),
      max_cuts_(solver.max_cuts) {}

double LoadController::end_of_leg() const { return scale_ * legs_[position_.leg].to; }

double LoadController::extreme() const { return std::max(std::abs(position_.leg_start), std::abs(end_of_leg())); }

double LoadController::stop(int increment) const {
    if (increment == 0) return position_.leg_start;
    if (increment == steps_) return end_of_leg();  // exact: later legs start from the same number
    const double way = std::pow(static_cast<double>(increment) / steps_, grading_);
    return position_.leg_start + (end_of_leg() - position_.leg_start) * way;
}

int LoadController::stop_nearest_to_zero() const {
    int nearest = 1;
    for (int k = 2; k <= steps_; ++k)
        if (std::abs(stop(k)) < std::abs(stop(nearest))) nearest = k;
    return nearest;
}

std::optional<LoadStep> LoadController::next() const {
    if (position_.leg >= legs_.size()) return std::nullopt;
    const Leg& leg = legs_[position_.leg];
    const int increment = position_.increments + 1;
    const double whole = stop(increment) - stop(increment - 1);
    const bool arrives =
        std::abs(stop(increment) - position_.reached) <= position_.fraction * std::abs(whole) * (1.0 + 1e-9);
    LoadStep step;
    step.cycle = leg.cycle;
    step.target = {control_, arrives ? stop(increment) : position_.reached + position_.fraction * whole};
    step.predictor = predictor(leg.cycle, step.target.value);
    if (arrives && increment == steps_) {
        step.reversal = leg.reversal;
        step.at_maximum = leg.at_maximum;
        step.at_minimum = leg.at_minimum;
        step.ends_cycle = leg.ends_cycle;
    }
    step.at_zero = arrives && leg.from * leg.to < 0.0 && increment == stop_nearest_to_zero();
    return step;
}

Predictor LoadController::predictor(int cycle, double to) const {
    const double reached = position_.reached, increment = to - reached, same = 1e-9 * std::abs(increment);
    const std::vector<LoadPosition::Taken>& before = position_.taken;
    // The ramp is no cycle: virgin material flows where it will later unload and reload without.
    const auto twin = std::ranges::find_if(before, [&](const LoadPosition::Taken& taken) {
        return taken.cycle > 0 && taken.cycle < cycle && std::abs(taken.from - reached) <= same &&
               std::abs(taken.to - to) <= same;
    });
    if (twin != before.end()) return {1.0, static_cast<int>(twin - before.begin()) + 1};
    if (before.empty()) return {};
    const double last = before.front().to - before.front().from;
    return last * increment > 0.0 ? Predictor(increment / last) : Predictor();
}

void LoadController::remember(const LoadPosition::Taken& last) {
    std::vector<LoadPosition::Taken>& taken = position_.taken;
    taken.insert(taken.begin(), last);
    if (taken.size() > remembered_) taken.pop_back();
}

void LoadController::committed_besides(int cycle) { remember({cycle, position_.reached, position_.reached}); }

void LoadController::accepted() {
    const LoadStep step = *next();
    remember({step.cycle, position_.reached, step.target.value});
    position_.reached = step.target.value;
    if (position_.reached == stop(position_.increments + 1)) ++position_.increments;
    if (position_.increments == steps_) {
        ++position_.leg;
        position_.increments = 0;
        position_.leg_start = position_.reached;
    }
    if (position_.consecutive_cuts > 0) {
        position_.fraction = std::min(1.0, 2.0 * position_.fraction);
        --position_.consecutive_cuts;
    }
}

bool LoadController::cut() {
    if (position_.consecutive_cuts >= max_cuts_) return false;
    ++position_.consecutive_cuts;
    ++position_.cuts;
    position_.fraction /= 2.0;
    return true;
}

}  // namespace stria::coarse
