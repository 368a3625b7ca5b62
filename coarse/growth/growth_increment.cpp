#include "coarse/growth/growth_increment.hpp"

#include <algorithm>
#include <cmath>

#include "coarse/growth/growth_law.hpp"
#include "common/case/case_questions.hpp"

namespace stria::coarse {
namespace {

GrowthPoint point_of(double rate, const CycleResult& tip) {
    const double K_op = tip.opening.K_op;
    return {.a = tip.a, .per_mm = 1.0 / rate, .closure = std::isfinite(K_op) ? K_op / tip.K_max : 0.0};
}

// Half way into a larger element a tip is a whole element beyond the edge on which its faces end, and goes on by one.
double from_edge_to_edge(double increment, const TipSteps& steps, bool one) {
    if (steps.element == 0.0) return increment;
    constexpr double rounding = 1e-6;
    const double elements = one ? 1.0 : std::max(std::floor(increment / steps.element + rounding), 1.0);
    return elements * steps.element - std::remainder(steps.beyond, steps.element);
}

}  // namespace

double largest_increment(const GrowthSection& growth, bool flows, double zone_ahead, double a) {
    constexpr double elastic_fraction = 0.01;  // of the length, where nothing flows
    return flows ? growth.zone_fraction * zone_ahead : elastic_fraction * a;
}

double cut_to_end(double increment, const GrowthSection& growth, const std::vector<CycleResult>& last,
                  const std::vector<double>& lengthening) {
    if (!growth.until) return increment;
    for (std::size_t t = 0; t < last.size(); ++t)
        if (lengthening[t] > 0.0) increment = std::min(increment, (*growth.until - last[t].a) / lengthening[t]);
    return increment;
}

double cut_to_toughness(double increment, double toughness, const std::vector<LengthAndK>& now,
                        const std::vector<LengthAndK>& before, const std::vector<double>& lengthening) {
    constexpr double beyond = 1.001, least = 0.01, root = 0.5, steepest = 5.0;
    double cut = increment;
    for (std::size_t t = 0; t < now.size(); ++t) {
        const LengthAndK &tip = now[t], first = t < before.size() ? before[t] : LengthAndK();
        if (!(lengthening[t] > 0.0 && tip.a > 0.0 && tip.K > 0.0)) continue;
        const bool tells = first.K > 0.0 && tip.a > first.a && tip.K > first.K;
        const double power = tells ? std::min(std::log(tip.K / first.K) / std::log(tip.a / first.a), steepest) : root;
        const double lengthened = tip.a * std::expm1(std::log(beyond * toughness / tip.K) / power);
        cut = std::min(cut, lengthened / lengthening[t]);
    }
    return std::max(cut, least * increment);
}

void GrowthIncrement::add(const std::vector<CycleResult>& cycles) {
    memory_.zones.resize(cycles.size());
    for (std::size_t t = 0; t < cycles.size(); ++t) {
        ForwardZone& zone = memory_.zones[t];
        if (cycles[t].da > 0.0) zone = {};
        zone.ahead = std::max(zone.ahead, cycles[t].forward_axis);
        zone.anywhere = std::max(zone.anywhere, cycles[t].forward);
    }
}

double GrowthIncrement::next(const GrowthSection& growth, const std::vector<CycleResult>& last,
                             const std::vector<double>& rates, const std::vector<double>& lengthening,
                             const TipSteps& steps) {
    const CycleResult& fastest = last[steps.tip];
    const ForwardZone zone = steps.tip < memory_.zones.size() ? memory_.zones[steps.tip] : ForwardZone();
    const GrowthPoint now = point_of(rates[steps.tip], fastest);
    double factor = 2.0;
    if (const double error = error_at(now); error > 0.0)
        factor = std::clamp(std::sqrt(growth.accuracy / error), 0.5, 2.0);
    const double largest = largest_increment(growth, zone.anywhere > 0.0, zone.ahead, fastest.a);
    memory_.increment = std::clamp(factor * memory_.increment, steps.least, std::max(steps.least, largest));
    if (memory_.points.size() == 2) memory_.points.erase(memory_.points.begin());
    memory_.points.push_back(now);
    return cut_to_end(from_edge_to_edge(memory_.increment, steps, grows_by_openings(growth)), growth, last,
                      lengthening);
}

double GrowthIncrement::error_at(const GrowthPoint& now) const {
    if (memory_.points.empty()) return 0.0;
    const GrowthPoint &first = memory_.points.front(), &middle = memory_.points.back();
    const bool two = memory_.points.size() == 2 && now.a > first.a;
    const double share = two ? (middle.a - first.a) / (now.a - first.a) : 0.5;
    const auto off_the_chord = [&](double GrowthPoint::*value) {
        return std::abs(middle.*value - (first.*value + share * (now.*value - first.*value)));
    };
    return std::max(off_the_chord(&GrowthPoint::per_mm) / (2.0 * now.per_mm), off_the_chord(&GrowthPoint::closure));
}

}  // namespace stria::coarse
