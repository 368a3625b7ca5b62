#include "coarse/cycle/closure_meter.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "coarse/model/tip_reach.hpp"
#include "coarse/zone/zone_selection.hpp"

namespace stria::coarse {
namespace {

constexpr double share_of_radius = 0.1;

bool is_closed(double signal) { return signal > 0.0; }

std::vector<std::size_t> changed_signals(const ClosureStation& before, const ClosureStation& after) {
    std::vector<std::size_t> changed;
    for (std::size_t k = 0; k < before.signal.size(); ++k)
        if (is_closed(before.signal[k]) != is_closed(after.signal[k])) changed.push_back(k);
    return changed;
}

/// Where between two stations a signal passes zero, as a share of the way, and whether that is known.
struct Crossing {
    double share;
    bool known;
};

/// The share of the way from `inner` to the station `across` at which a signal that was seen at `outer` and `inner`, on
/// one side of zero, comes to zero if it goes straight on; beyond 1, or not a number: it does not.
double straight_on(const ClosureStation& outer, const ClosureStation& inner, const ClosureStation& across,
                   std::size_t k) {
    if (is_closed(outer.signal[k]) != is_closed(inner.signal[k])) return NAN;
    const double slope = (inner.signal[k] - outer.signal[k]) / (inner.target - outer.target);
    return -inner.signal[k] / slope / (across.target - inner.target);
}

/// Where to try what was expected of a signal, as a share of the way between two stations: there, then from there
/// towards the station that says otherwise, as far as the answer may be off. These two tell, or lead on: stations far
/// away do not, since signals bend. Not a number: all that has been tried.
double as_expected(const std::vector<ClosureStation>& way, std::size_t i, double precision, double expected) {
    const double start = way[i].target, end = way[i + 1].target, width = std::abs(end - start);
    const double share = (expected - start) / (end - start), rounding = 1e-9, beside = 0.9 * precision / width;
    const auto is_far = [&](std::size_t other, double from) {
        return std::abs(way[other].target - from) > 2.0 * precision;
    };
    if (std::abs(share) <= rounding && (i == 0 || is_far(i - 1, start))) return beside;
    if (std::abs(1.0 - share) <= rounding && (i + 2 == way.size() || is_far(i + 2, end))) return 1.0 - beside;
    return share > rounding && share < 1.0 - rounding ? share : NAN;
}

/// Signals are nearly straight on either side of zero, and bend there: faces press with another stiffness than they
/// open. So two stations on one side tell where it is, and where they are near it they know. What leads to the station
/// across, whose signal says otherwise, leads nowhere; of two the one farther from both stations tells more.
Crossing crossing(const std::vector<ClosureStation>& way, std::size_t i, std::size_t k, double precision,
                  double expected) {
    const ClosureStation &before = way[i], &after = way[i + 1];
    const double width = std::abs(after.target - before.target), near = 0.5 * precision / width;
    const double from_before = i > 0 ? straight_on(way[i - 1], before, after, k) : NAN;
    const double from_after = i + 2 < way.size() ? 1.0 - straight_on(way[i + 2], after, before, k) : NAN;
    if (from_before >= 0.0 && from_before <= near) return {from_before, true};
    if (from_after <= 1.0 && from_after >= 1.0 - near) return {from_after, true};
    if (width <= precision) return {0.5, true};
    const auto room = [](double share) { return std::min(share, 1.0 - share); };
    const bool before_leads = room(from_before) > near, after_leads = room(from_after) > near;
    if (before_leads && after_leads && std::abs(from_after - from_before) <= near)
        return {0.5 * (from_before + from_after), true};
    constexpr std::size_t enough = 8;  // stations for each signal: whatever leads on has had its chance
    if (way.size() > enough * before.signal.size()) return {0.5, false};
    if (const double share = as_expected(way, i, precision, expected); std::isfinite(share)) return {share, false};
    if (before_leads && !(after_leads && room(from_after) > room(from_before))) return {from_before, false};
    if (after_leads) return {from_after, false};
    const double a = std::abs(before.signal[k]), b = std::abs(after.signal[k]);
    return {std::isfinite(a + b) && a + b > 0.0 ? std::clamp(a / (a + b), 0.1, 0.9) : 0.5, false};
}

}  // namespace

ClosureMeter::ClosureMeter(const ClosureSection& closure, const std::vector<double>& yield_stress,
                           const std::vector<CrackSection>& cracks, const std::vector<double>& largest_K_I)
    : tension_(closure.tension || closure.definition == OpeningDefinition::Tension),
      slip_(!closure.profile.empty() && has_friction(cracks)) {
    for (std::size_t t = 0; t < largest_K_I.size(); ++t) {
        std::vector<double> distances{
            closure.distance.value_or(share_of_radius * subdivision_radius(1.0, largest_K_I[t], yield_stress[t]))};
        distances.insert(distances.end(), closure.profile.begin(), closure.profile.end());
        distance_.push_back(std::move(distances));
    }
}

std::vector<double> ClosureMeter::opening_at() const {
    std::vector<double> places;
    for (const std::vector<double>& distances : distance_) places.push_back(distances.front());
    return places;
}

ClosureMeter::Signals ClosureMeter::signals() const {
    if (distance_.empty()) return {};
    const std::size_t distances = distance_.front().size();
    return {.contact = distances, .tension = tension_ ? 1U : 0U, .slip = slip_ ? distances : 0U};
}

const char* ClosureMeter::what_a_tip_does(const OpeningChange& change) const {
    if (at(change.signal) >= signals().first_slip()) return "slides";
    return change.closes ? "closes" : "opens";
}

std::vector<double> ClosureMeter::ahead(const EnrichedMesh& mesh) const {
    std::vector<double> ahead;
    for (std::size_t t = 0; tension_ && t < distance_.size(); ++t)
        ahead.push_back(std::max(distance_[t].front(), tip_element_size(mesh, mesh.tips[t])));
    return ahead;
}

std::vector<std::vector<double>> ClosureMeter::slip_at() const {
    return slip_ ? distance_ : std::vector<std::vector<double>>();
}

std::vector<double> ClosureMeter::signal(const NewtonReport& report, const std::vector<double>& before) const {
    const Residual& last = report.iterations.back().residual;
    std::vector<double> signal;
    for (std::size_t t = 0; t < distance_.size(); ++t) {
        for (std::size_t k = 0; k < distance_[t].size(); ++k)
            signal.push_back(t < last.faces.size() ? last.faces[t][k] : -INFINITY);
        if (tension_) signal.push_back(t < last.force_ahead.size() ? -last.force_ahead[t] : -INFINITY);
        for (std::size_t k = 0; slip_ && k < distance_[t].size(); ++k) {
            const bool has_slid = !before.empty() && before[signal.size()] > 0.0;
            const bool slides = t < last.slides.size() && last.slides[t][k] != 0;
            signal.push_back(has_slid || slides ? 1.0 : -1.0);
        }
    }
    return signal;
}

void ClosureMeter::forget_slip(std::vector<double>& signal) const {
    const Signals count = signals();
    for (std::size_t k = 0; k < signal.size(); ++k)
        if (k % count.all() >= count.first_slip()) signal[k] = -1.0;
}

std::vector<OpeningChange> ClosureMeter::locate(ClosureStation before, ClosureStation after, double precision,
                                                const Solve& solve, const std::vector<double>& expected) const {
    std::vector<OpeningChange> changes;
    std::vector<ClosureStation> way{std::move(before), std::move(after)};
    const auto crossing_of = [&](std::size_t i, std::size_t k) {
        return crossing(way, i, k, precision, k < expected.size() ? expected[k] : NAN);
    };
    for (std::size_t i = 0; i + 1 < way.size();) {
        const std::vector<std::size_t> changed = changed_signals(way[i], way[i + 1]);
        const auto unknown = std::ranges::find_if(changed, [&](std::size_t k) { return !crossing_of(i, k).known; });
        const bool found = unknown == changed.end();
        if (!found) {
            if (auto between = try_between(way[i], way[i + 1], crossing_of(i, *unknown).share, solve)) {
                way.insert(way.begin() + static_cast<std::ptrdiff_t>(i) + 1, std::move(*between));
                continue;
            }
        }
        for (const std::size_t k : changed) {
            const auto [share, known] = crossing_of(i, k);
            const double load_factor = known ? std::lerp(way[i].load_factor, way[i + 1].load_factor, share) : NAN;
            const double target = std::lerp(way[i].target, way[i + 1].target, share);
            changes.push_back({static_cast<int>(k / signals().all()), static_cast<int>(k % signals().all()),
                               is_closed(way[i + 1].signal[k]), load_factor,
                               (target - way.front().target) / (way.back().target - way.front().target), target});
        }
        ++i;
    }
    return changes;
}

std::optional<ClosureStation> ClosureMeter::try_between(const ClosureStation& before, const ClosureStation& after,
                                                        double share, const Solve& solve) const {
    for (const double way : {share, 0.5, 0.375, 0.625, 0.25, 0.75}) {
        const double target = std::lerp(before.target, after.target, way);
        const Trial trial = solve(target);
        if (trial.report.converged)
            return ClosureStation{target, trial.load_factor, signal(trial.report, before.signal)};
    }
    return std::nullopt;
}

}  // namespace stria::coarse
