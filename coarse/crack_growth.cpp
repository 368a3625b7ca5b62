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
