#include "coarse/closure.hpp"

#include <algorithm>
#include <cmath>

#include "coarse/zone_selection.hpp"

namespace stria::coarse {
namespace {

constexpr double relative_precision = 0.002, share_of_radius = 0.1;

}  // namespace

ClosureMeter::ClosureMeter(const Case& input, const std::vector<double>& largest_K_I) {
    for (const double K_I : largest_K_I) {
        const double yield_stress = input.material.yield_stress.value_or(INFINITY);
        distance_.push_back(
            input.closure.distance.value_or(share_of_radius * subdivision_radius(1.0, K_I, yield_stress)));
    }
    for (const LoadBlock& block : input.load.blocks)
        precision_ = std::max(precision_, relative_precision * std::max(std::abs(block.max), std::abs(block.min)));
}

std::vector<char> ClosureMeter::closed(const NewtonReport& report) const {
    const std::vector<double>& reach = report.iterations.back().residual.contact_reach;
    std::vector<char> closed(distance_.size(), 0);
    for (std::size_t t = 0; t < std::min(closed.size(), reach.size()); ++t) closed[t] = reach[t] >= distance_[t];
    return closed;
}

std::vector<ContactChange> ClosureMeter::locate(const std::vector<char>& before, const std::vector<char>& after,
                                                double from, double to,
                                                const std::function<Trial(double)>& solve) const {
    std::vector<ContactChange> changes;
    for (std::size_t t = 0; t < before.size(); ++t) {
        if (before[t] == after[t]) continue;
        double unchanged = from, changed = to, load_factor = NAN;
        while (std::abs(changed - unchanged) > precision_ || std::isnan(load_factor)) {
            const double middle = (unchanged + changed) / 2.0;
            const Trial trial = solve(middle);
            if (!trial.report.converged) break;
            load_factor = trial.load_factor;
            (closed(trial.report)[t] == before[t] ? unchanged : changed) = middle;
        }
        if (!std::isnan(load_factor)) changes.push_back({static_cast<int>(t), after[t] != 0, load_factor});
    }
    return changes;
}

}  // namespace stria::coarse
