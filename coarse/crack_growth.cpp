#include "coarse/crack_growth.hpp"

#include <cmath>

namespace stria::coarse {

bool grows_at(const GrowthSection& growth, const LoadStep& step) {
    const bool extreme = growth.at == GrowthAt::Maximum ? step.ends_cycle : step.at_minimum;
    return extreme && step.cycle % growth.every == 0;
}

double planned_growth(const GrowthSection& growth, const LoadSection& load) {
    int cycles = 0;
    for (const LoadBlock& block : load.blocks) cycles += block.cycles;
    return growth.increment * (cycles / growth.every);
}

double hoop_stress_angle(double K_I, double K_II) {
    if (std::abs(K_II) < 0.005 * std::abs(K_I)) return 0.0;
    const double ratio = K_I / K_II;
    return 2.0 * std::atan(0.25 * (ratio - std::copysign(std::sqrt(ratio * ratio + 8.0), K_II)));
}

double cycles_of_increment(const GrowthSection& growth, double K_max, double K_min, double K_op) {
    if (growth.law == GrowthLaw::Prescribed) return growth.every;
    const double range = K_max - (growth.driving == GrowthDriving::Range ? K_min : K_op);
    return growth.increment / (growth.C * std::pow(range, growth.m));
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

}  // namespace stria::coarse
