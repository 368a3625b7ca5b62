#include "coarse/load/growth_schedule.hpp"

namespace stria::coarse {

bool is_as_long_as_asked(const GrowthSection& growth, double a) {
    constexpr double rounding = 1e-9;
    return growth.until && a >= *growth.until * (1.0 - rounding);
}

bool grows_at(const GrowthSection& growth, const LoadStep& step) {
    const bool extreme = growth.at == GrowthAt::Maximum ? step.ends_cycle : step.at_minimum;
    return extreme && step.cycle % growth.every == 0;
}

}  // namespace stria::coarse
