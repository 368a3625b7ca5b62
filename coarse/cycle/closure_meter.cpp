#include "coarse/cycle/closure_meter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "coarse/cycle/hidden_slip.hpp"
#include "coarse/enrichment/tip_reach.hpp"
#include "coarse/fracture/plastic_zone.hpp"
#include "common/case/case_questions.hpp"

namespace stria::coarse {
namespace {

std::vector<std::size_t> changed_signals(const ClosureStation& before, const ClosureStation& after) {
    std::vector<std::size_t> changed;
    for (std::size_t k = 0; k < before.signal.size(); ++k)
        if (is_closed(before.signal[k]) != is_closed(after.signal[k])) changed.push_back(k);
    return changed;
}

/// A signal that is nothing but for rounding says what it said before, with its own size.
double undecided_as_before(double signal, double before, double largest) {
    constexpr double rounding = 1e-8;  // of the largest
    if (!std::isfinite(before) || std::abs(signal) > rounding * largest) return signal;
    return is_closed(before) ? std::max(std::abs(signal), std::numeric_limits<double>::min()) : -std::abs(signal);
}

/// Of the profile, each once: the closure distance stands in front of them anyway.
std::vector<double> further_distances(const ClosureSection& closure) {
    std::vector<double> further;
    for (const double distance : closure.profile)
        if (closure.distance != distance && std::ranges::count(further, distance) == 0) further.push_back(distance);
    return further;
}

}  // namespace

ClosureMeter::ClosureMeter(const ClosureSection& closure, const std::vector<double>& yield_stress,
                           const std::vector<CrackSection>& cracks, const std::vector<double>& K)
    : tension_(measures_tension(closure)), slip_(!closure.profile.empty() && has_friction(cracks)) {
    const std::vector<double> further = further_distances(closure);
    for (const double distance : closure_distances(closure, K, yield_stress)) {
        std::vector<double> distances{distance};
        distances.insert(distances.end(), further.begin(), further.end());
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
    if (signals().is_slip(at(change.signal))) return "slides";
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

std::vector<double> ClosureMeter::signal(const NewtonReport& report, const std::vector<double>& before,
                                         const std::vector<double>& largest) const {
    const Residual& last = report.iterations.back().residual;
    std::vector<double> signal;
    const auto put = [&](double value) {
        const std::size_t k = signal.size();
        const bool is_known = k < before.size() && k < largest.size();
        signal.push_back(is_known ? undecided_as_before(value, before[k], largest[k]) : value);
    };
    for (std::size_t t = 0; t < distance_.size(); ++t) {
        for (std::size_t k = 0; k < distance_[t].size(); ++k) put(t < last.faces.size() ? last.faces[t][k] : -INFINITY);
        if (tension_) put(t < last.force_ahead.size() ? -last.force_ahead[t] : -INFINITY);
        for (std::size_t k = 0; slip_ && k < distance_[t].size(); ++k) {
            const bool has_slid = !before.empty() && before[signal.size()] > 0.0;
            const bool slides = t < last.nearest.size() && last.nearest[t][k].slides();
            signal.push_back(has_slid || slides ? 1.0 : -1.0);
        }
    }
    return signal;
}

std::vector<coupling::NearestContact> ClosureMeter::nearest(const NewtonReport& report) const {
    const Residual& last = report.iterations.back().residual;
    std::vector<coupling::NearestContact> nearest;
    for (std::size_t t = 0; slip_ && t < distance_.size(); ++t)
        for (std::size_t k = 0; k < distance_[t].size(); ++k)
            nearest.push_back(t < last.nearest.size() ? last.nearest[t][k] : coupling::NearestContact());
    return nearest;
}

std::vector<std::size_t> ClosureMeter::unslid(const ClosureStation& before, const ClosureStation& after) const {
    const Signals count = signals();
    std::vector<std::size_t> unslid;
    if (before.nearest.empty() || after.nearest.empty()) return unslid;
    for (std::size_t k = 0; k < after.signal.size(); ++k)
        if (count.is_slip(count.kind_of(k)) && before.signal[k] <= 0.0 && after.signal[k] <= 0.0) unslid.push_back(k);
    return unslid;
}

std::size_t ClosureMeter::contact_of(std::size_t signal) const {
    const Signals count = signals();
    return count.tip_of(signal) * count.slip + count.kind_of(signal) - count.first_slip();
}

bool ClosureMeter::may_hide_slip(const ClosureStation& before, const ClosureStation& after) const {
    return std::ranges::any_of(unslid(before, after), [&](std::size_t k) {
        return coarse::may_hide_slip(before.nearest[contact_of(k)], after.nearest[contact_of(k)]);
    });
}

void ClosureMeter::remember_slip(const std::vector<double>& before, std::vector<double>& signal) const {
    const Signals count = signals();
    for (std::size_t k = 0; k < signal.size(); ++k)
        if (count.is_slip(count.kind_of(k))) signal[k] = std::max(signal[k], before[k]);
}

void ClosureMeter::forget_slip(std::vector<double>& signal) const {
    const Signals count = signals();
    for (std::size_t k = 0; k < signal.size(); ++k)
        if (count.is_slip(count.kind_of(k))) signal[k] = -1.0;
}

/// The states between two of them that have been tried, and the changes that they tell.
class ClosureMeter::Search {
public:
    Search(const ClosureMeter& meter, std::vector<ClosureStation> ends, const Trials& trials)
        : meter_(meter), way_(std::move(ends)), trials_(trials) {}

    std::vector<OpeningChange> changes() {
        for (std::size_t i = 0; i + 1 < way_.size();) {
            if (try_for_slip_after(i) || try_for_signal_after(i)) continue;
            add_changes_after(i);
            ++i;
        }
        return std::move(changes_);
    }

private:
    // What slides and parts between two stations shows at neither: where it is found, the second one has slid. Where no
    // trial on a long way tells it may have, at a load that nobody knows, and is not looked for any more.
    bool try_for_slip_after(std::size_t i) {
        for (const std::size_t k : meter_.unslid(way_[i], way_[i + 1])) {
            const std::optional<Crossing> hidden = hidden_slip(way_, i, meter_.contact_of(k), trials_.precision);
            if (!hidden) continue;
            if (!hidden->known && try_after(i, hidden->share)) return true;
            if (!hidden->known && std::abs(way_[i + 1].target - way_[i].target) <= trials_.precision) continue;
            way_[i + 1].signal[k] = 1.0;
            remember_slip_from(i + 2);
            if (hidden->known) continue;
            add_change(i, k, *hidden);
            way_[i].signal[k] = 1.0;
        }
        return false;
    }

    bool try_for_signal_after(std::size_t i) {
        for (const std::size_t k : changed_signals(way_[i], way_[i + 1]))
            if (const Crossing found = crossing_after(i, k); !found.known) return try_after(i, found.share);
        return false;
    }

    void add_changes_after(std::size_t i) {
        for (const std::size_t k : changed_signals(way_[i], way_[i + 1])) {
            const Crossing found = crossing_after(i, k);
            OpeningChange& change = add_change(i, k, found);
            const Signals signals = meter_.signals();
            const bool says_whether = signals.is_slip(signals.kind_of(k));
            if (found.known && !says_whether) change.rate = rates_beside(way_, i, k, trials_.precision, change.target);
        }
    }

    [[nodiscard]] Crossing crossing_after(std::size_t i, std::size_t k) const {
        const ExpectedCrossing expected = k < trials_.expected.size() ? trials_.expected[k] : ExpectedCrossing();
        const Crossing found = crossing(way_, i, k, trials_.precision, expected);
        return found.known ? meter_.seen_closed(found, way_[i], way_[i + 1], k, trials_.precision) : found;
    }

    /// A further state at that share of the way from one to the next; false: none comes to equilibrium.
    bool try_after(std::size_t i, double share) {
        auto between = meter_.try_between(way_[i], way_[i + 1], share, trials_);
        if (!between) return false;
        way_.insert(way_.begin() + static_cast<std::ptrdiff_t>(i) + 1, std::move(*between));
        remember_slip_from(i + 2);
        return true;
    }

    void remember_slip_from(std::size_t i) {
        for (std::size_t j = i; j < way_.size(); ++j) meter_.remember_slip(way_[j - 1].signal, way_[j].signal);
    }

    OpeningChange& add_change(std::size_t i, std::size_t k, const Crossing& found) {
        const ClosureStation &before = way_[i], &after = way_[i + 1];
        const double target = std::lerp(before.target, after.target, found.share);
        return changes_.emplace_back(OpeningChange{
            .tip = static_cast<int>(meter_.signals().tip_of(k)),
            .signal = static_cast<int>(meter_.signals().kind_of(k)),
            .closes = is_closed(after.signal[k]),
            .load_factor = found.known ? std::lerp(before.load_factor, after.load_factor, found.share) : NAN,
            .way = (target - way_.front().target) / (way_.back().target - way_.front().target),
            .target = target});
    }

    const ClosureMeter& meter_;
    std::vector<ClosureStation> way_;
    const Trials& trials_;
    std::vector<OpeningChange> changes_;
};

std::vector<OpeningChange> ClosureMeter::locate(ClosureStation before, ClosureStation after,
                                                const Trials& trials) const {
    return Search(*this, {std::move(before), std::move(after)}, trials).changes();
}

Crossing ClosureMeter::seen_closed(const Crossing& found, const ClosureStation& before, const ClosureStation& after,
                                   std::size_t k, double precision) const {
    const std::size_t kind = signals().kind_of(k), slip = k + signals().first_slip();
    if (!slip_ || kind >= signals().contact || before.signal[slip] > 0.0 || after.signal[slip] > 0.0) return found;
    const double width = std::abs(after.target - before.target), back = 0.5 * precision / width;
    const bool closes = is_closed(after.signal[k]);
    if ((closes ? 1.0 - found.share : found.share) * width <= precision) return found;
    return {closes ? found.share + back : found.share - back, false};
}

std::optional<ClosureStation> ClosureMeter::try_between(const ClosureStation& before, const ClosureStation& after,
                                                        double share, const Trials& trials) const {
    for (const double way : {share, 0.5, 0.375, 0.625, 0.25, 0.75}) {
        const double target = std::lerp(before.target, after.target, way);
        const Trial trial = trials.solve(target);
        if (trial.report.converged)
            return ClosureStation{target, trial.load_factor, signal(trial.report, before.signal, trials.largest),
                                  nearest(trial.report)};
    }
    return std::nullopt;
}

}  // namespace stria::coarse
