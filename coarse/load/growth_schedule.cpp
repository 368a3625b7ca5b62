#include "coarse/load/growth_schedule.hpp"

#include <fmt/format.h>

#include "coarse/load/load_history.hpp"

namespace stria::coarse {
namespace {

bool varies_under_law(const Case& input) {
    return input.growth && input.growth->law != GrowthLaw::Prescribed && varies(input);
}

}  // namespace

bool is_as_long_as_asked(const GrowthSection& growth, double a) {
    constexpr double rounding = 1e-9;
    return growth.until && a >= *growth.until * (1.0 - rounding);
}

bool grows_at(const GrowthSection& growth, const LoadStep& step) {
    const bool extreme = growth.at == GrowthAt::Maximum ? step.ends_cycle : step.at_minimum;
    return extreme && step.cycle % growth.every == 0;
}

bool takes_mean_rate(const Case& input) { return varies_under_law(input) && input.growth->every > 1; }

bool ends_period(const GrowthSection& growth, int cycle) {
    const int next_growth = growth.at == GrowthAt::Maximum ? cycle : cycle + 1;
    return next_growth % growth.every == 0;
}

std::vector<std::string> growth_warnings(const Case& input) {
    if (!varies_under_law(input)) return {};
    const int every = input.growth->every, sequence = cycle_count(input.load) / input.load.repeat;
    if (every == 1)
        return {fmt::format("growth.every = 1 under a load that varies: each computed cycle stands for dN cycles like "
                            "itself, an overload too. Where the load repeats a sequence, growth.every = {} takes the "
                            "mean rate of its cycles",
                            sequence)};
    if (input.load.repeat > 1 && every % sequence != 0)
        return {fmt::format("growth.every = {} is no multiple of the {} cycles that load.repeat repeats: the mean rate "
                            "of those between two growths is not that of the sequence",
                            every, sequence)};
    return {};
}

}  // namespace stria::coarse
