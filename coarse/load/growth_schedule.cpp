#include "coarse/load/growth_schedule.hpp"

namespace stria::coarse {

bool grows_at(const GrowthSection& growth, const LoadStep& step) {
    const bool extreme = growth.at == GrowthAt::Maximum ? step.ends_cycle : step.at_minimum;
    return extreme && step.cycle % growth.every == 0;
}

}  // namespace stria::coarse
