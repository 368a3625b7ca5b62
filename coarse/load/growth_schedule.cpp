#include "coarse/load/growth_schedule.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "coarse/load/load_history.hpp"
#include "common/case/case_questions.hpp"

namespace stria::coarse {
namespace {

bool varies_under_law(const Case& input) { return input.growth && !is_prescribed(*input.growth) && varies(input); }

}  // namespace

// Tips that should grow alike do so to some digits of K, and half of their crack by the mean of theirs.
bool is_as_long_as_asked(const GrowthSection& growth, double a) {
    if (!growth.until) return false;
    constexpr double rounding = 1e-9, of_increment = 1e-3;
    const double near = growth.increment.is_auto() ? rounding * *growth.until : of_increment * growth.increment.value();
    return a >= *growth.until - near;
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

int cycle_cut_off(const LoadSection& load) {
    const bool goes_on = load.blocks.empty() || load.blocks.back().max == load.blocks.front().max;
    return goes_on ? 0 : cycle_count(load);
}

std::vector<std::string> growth_warnings(const Case& input) {
    std::vector<std::string> all;
    const auto never_touches = [](const CrackSection& crack) { return !crack.contact; };
    if (input.growth && !is_prescribed(*input.growth) && grows_by_opening_loads(*input.growth) &&
        std::ranges::any_of(input.cracks, never_touches))
        all.emplace_back("opening loads drive the growth (growth.driving), and a crack without contact never closes: "
                         "its K_op is K_min, or 0 where that is below: dK_eff is the range of K in tension");
    if (!varies_under_law(input)) return all;
    const int every = input.growth->every, sequence = cycle_count(input.load) / input.load.repeat;
    if (every == 1)
        all.push_back(
            fmt::format("growth.every = 1 under a load that varies: each computed cycle stands for dN cycles like "
                        "itself, an overload too. Where the load repeats a sequence, growth.every = {} takes the "
                        "mean rate of its cycles",
                        sequence));
    else if (input.load.repeat > 1 && every % sequence != 0)
        all.push_back(
            fmt::format("growth.every = {} is no multiple of the {} cycles that load.repeat repeats: the mean rate "
                        "of those between two growths is not that of the sequence",
                        every, sequence));
    return all;
}

}  // namespace stria::coarse
