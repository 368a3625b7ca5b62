#include "coarse/cycle/closure_meter.hpp"

#include <algorithm>
#include <cmath>

#include "coarse/model/tip_reach.hpp"
#include "coarse/zone/zone_selection.hpp"

namespace stria::coarse {
namespace {

constexpr double share_of_radius = 0.1;

}  // namespace

ClosureMeter::ClosureMeter(const ClosureSection& closure, const MaterialSection& material,
                           const std::vector<CrackSection>& cracks, const std::vector<double>& largest_K_I)
    : tension_(closure.tension || closure.definition == OpeningDefinition::Tension),
      slip_(!closure.profile.empty() && has_friction(cracks)) {
    for (const double K_I : largest_K_I) {
        const double yield_stress = material.yield_stress.value_or(INFINITY);
        std::vector<double> distances{
            closure.distance.value_or(share_of_radius * subdivision_radius(1.0, K_I, yield_stress))};
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

std::vector<char> ClosureMeter::closed(const NewtonReport& report, const std::vector<char>& before, bool rises) const {
    const Residual& last = report.iterations.back().residual;
    std::vector<char> closed;
    for (std::size_t t = 0; t < distance_.size(); ++t) {
        for (const double distance : distance_[t])
            closed.push_back(t < last.contact_reach.size() && last.contact_reach[t] >= distance);
        if (tension_) closed.push_back(t < last.force_ahead.size() && last.force_ahead[t] < 0.0);
        for (std::size_t k = 0; slip_ && k < distance_[t].size(); ++k) {
            const bool has_slid = !before.empty() && before[closed.size()] != 0;
            const bool slides = t < last.slides.size() && last.slides[t][k] != 0;
            closed.push_back(rises && (has_slid || slides));
        }
    }
    return closed;
}

void ClosureMeter::forget_slip(std::vector<char>& closed) const {
    const Signals count = signals();
    for (std::size_t k = 0; k < closed.size(); ++k)
        if (k % count.all() >= count.first_slip()) closed[k] = 0;
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
        for (const double way : {0.5, 0.375, 0.625, 0.25, 0.75}) {
            const double between = (1.0 - way) * before.target + way * after.target;
            const Trial trial = solve(between);
            if (!trial.report.converged) continue;
            const End middle{between, closed(trial.report, before.closed, after.target > before.target)};
            bisect(before, middle, trial.load_factor, precision, solve, changes);
            bisect(middle, after, trial.load_factor, precision, solve, changes);
            return;
        }
        load_factor = NAN;
    }
    for (std::size_t k = 0; k < before.closed.size(); ++k) {
        if (before.closed[k] == after.closed[k]) continue;
        const std::size_t per_tip = signals().all();
        changes.push_back(
            {static_cast<int>(k / per_tip), static_cast<int>(k % per_tip), after.closed[k] != 0, load_factor});
    }
}

}  // namespace stria::coarse
