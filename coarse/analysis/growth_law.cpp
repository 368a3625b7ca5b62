#include "coarse/analysis/growth_law.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "common/index.hpp"

namespace stria::coarse {

double hoop_stress_angle(double K_I, double K_II) {
    if (std::abs(K_II) < 0.005 * std::abs(K_I)) return 0.0;
    const double ratio = K_I / K_II;
    return 2.0 * std::atan(0.25 * (ratio - std::copysign(std::sqrt(ratio * ratio + 8.0), K_II)));
}

double growth_rate(const GrowthSection& growth, const CycleResult& cycle) {
    if (growth.law == GrowthLaw::Prescribed) return growth.increment;
    double range = cycle.CTOD_range();
    if (growth.law == GrowthLaw::Paris)
        range = cycle.K_max - (growth.driving == GrowthDriving::Range ? cycle.K_min : cycle.opening.K_op);
    return range > 0.0 ? growth.C * std::pow(range, growth.m) : 0.0;  // no opening load: it never opens
}

std::vector<double> advances(const GrowthSection& growth, const std::vector<CycleResult>& last, std::size_t tips) {
    std::vector<double> advance(tips, growth.increment);
    if (last.empty()) return advance;
    const double fastest = fastest_rate(growth, last);
    for (std::size_t t = 0; t < tips; ++t)
        advance[t] = fastest > 0.0 ? growth.increment * (growth_rate(growth, last[t]) / fastest) : 0.0;
    return advance;
}

double fastest_rate(const GrowthSection& growth, const std::vector<CycleResult>& cycles) {
    double fastest = 0.0;
    for (const CycleResult& cycle : cycles) fastest = std::max(fastest, growth_rate(growth, cycle));
    return fastest;
}

double cycles_passed(const GrowthSection& growth, double grown, double rate_before, double rate_after) {
    if (growth.law == GrowthLaw::Prescribed) return 1.0;
    return grown > 0.0 ? 0.5 * grown * (1.0 / rate_before + 1.0 / rate_after) : 0.0;
}

void advance(CrackSection& crack, const Tip& tip, const Vec2& direction, double increment) {
    const bool at_end = tip.upper > 0;
    const Vec2 next = tip.position + increment * direction;
    const bool straight = std::abs(tip.direction.x() * direction.y() - tip.direction.y() * direction.x()) < 1e-12;
    if (!straight)
        crack.points.insert(at_end ? crack.points.end() : crack.points.begin(), next);
    else
        (at_end ? crack.points.back() : crack.points.front()) = next;
}

Case with_longer_cracks(const Scene& scene, const std::vector<TipResult>& nominal,
                        const std::vector<double>& advance_by) {
    Case input = scene.input;
    for (std::size_t t = 0; t < nominal.size(); ++t) {
        if (advance_by[t] == 0.0) continue;
        const Tip& tip = scene.enriched.tips[t];
        const bool straight = input.growth->direction == GrowthDirection::Straight;
        const double angle = straight ? 0.0 : hoop_stress_angle(nominal[t].K_I, nominal[t].K_II);
        advance(input.cracks[at(tip.crack)], tip, Eigen::Rotation2Dd(angle) * tip.direction, advance_by[t]);
    }
    return input;
}

}  // namespace stria::coarse
