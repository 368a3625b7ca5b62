#include "coarse/analysis/closure.hpp"

#include <algorithm>
#include <cmath>

#include "coarse/model/tip_reach.hpp"
#include "coarse/zone/zone_selection.hpp"

namespace stria::coarse {
namespace {

constexpr double share_of_radius = 0.1;

/// Opening at a load on the way down, linear between increments.
double interpolated(std::span<const double> load, std::span<const double> opening, double at) {
    for (std::size_t k = 1; k < load.size(); ++k) {
        if (load[k] > at) continue;
        const double way = (load[k - 1] - at) / (load[k - 1] - load[k]);
        return opening[k - 1] + way * (opening[k] - opening[k - 1]);
    }
    return opening.back();
}

}  // namespace

ClosureMeter::ClosureMeter(const Case& input, const std::vector<double>& largest_K_I)
    : tension_(input.closure.tension || input.closure.definition == OpeningDefinition::Tension) {
    for (const double K_I : largest_K_I) {
        const double yield_stress = input.material.yield_stress.value_or(INFINITY);
        std::vector<double> distances{
            input.closure.distance.value_or(share_of_radius * subdivision_radius(1.0, K_I, yield_stress))};
        distances.insert(distances.end(), input.closure.profile.begin(), input.closure.profile.end());
        distance_.push_back(std::move(distances));
    }
}

std::vector<double> ClosureMeter::ahead(const EnrichedMesh& mesh) const {
    std::vector<double> ahead;
    for (std::size_t t = 0; tension_ && t < distance_.size(); ++t)
        ahead.push_back(std::max(distance_[t].front(), tip_element_size(mesh, mesh.tips[t])));
    return ahead;
}

std::vector<char> ClosureMeter::closed(const NewtonReport& report) const {
    const Residual& last = report.iterations.back().residual;
    std::vector<char> closed;
    for (std::size_t t = 0; t < distance_.size(); ++t) {
        for (const double distance : distance_[t])
            closed.push_back(t < last.contact_reach.size() && last.contact_reach[t] >= distance);
        if (tension_) closed.push_back(t < last.force_ahead.size() && last.force_ahead[t] < 0.0);
    }
    return closed;
}

std::vector<OpeningChange> ClosureMeter::locate(const std::vector<char>& before, const std::vector<char>& after,
                                                double from, double to, double precision, const Solve& solve) const {
    std::vector<OpeningChange> changes;
    bisect({from, before}, {to, after}, NAN, precision, solve, changes);
    return changes;
}

// `load_factor`: that of the last trial, which is one of the two ends; none yet: not a number.
void ClosureMeter::bisect(const End& before, const End& after, double load_factor, double precision, const Solve& solve,
                          std::vector<OpeningChange>& changes) const {
    if (before.closed == after.closed) return;
    if (std::abs(after.target - before.target) > precision || std::isnan(load_factor)) {
        const double middle = (before.target + after.target) / 2.0;
        const Trial trial = solve(middle);
        if (trial.report.converged) {
            const End between{middle, closed(trial.report)};
            bisect(before, between, trial.load_factor, precision, solve, changes);
            bisect(between, after, trial.load_factor, precision, solve, changes);
            return;
        }
        if (std::isnan(load_factor)) return;
    }
    for (std::size_t k = 0; k < before.closed.size(); ++k) {
        if (before.closed[k] == after.closed[k]) continue;
        const int signal = static_cast<int>(k);
        changes.push_back({signal / signals(), signal % signals(), after.closed[k] != 0, load_factor});
    }
}

double compliance_offset_opening(std::span<const double> load_down, std::span<const double> opening_down,
                                 std::span<const double> load_up, std::span<const double> opening_up, double offset) {
    if (load_down.size() < 2 || load_up.size() < 2) return NAN;
    const double range = load_down.front() - load_down.back();
    const double upper = load_down.front() - 0.25 * range;
    const double of_open =
        (opening_down.front() - interpolated(load_down, opening_down, upper)) / (load_down.front() - upper);
    if (!(of_open > 0.0)) return NAN;
    double above = NAN, offset_above = 0.0;  // the middle of the segment above, and its offset
    for (std::size_t k = load_up.size() - 1; k > 0; --k) {
        const double compliance = (opening_up[k] - opening_up[k - 1]) / (load_up[k] - load_up[k - 1]);
        const double middle = 0.5 * (load_up[k] + load_up[k - 1]), here = 1.0 - compliance / of_open;
        if (here >= offset) {
            if (std::isnan(above)) return NAN;  // stiffer than the open crack up to the maximum
            return middle + (above - middle) * (here - offset) / (here - offset_above);
        }
        above = middle;
        offset_above = here;
    }
    return NAN;
}

}  // namespace stria::coarse
