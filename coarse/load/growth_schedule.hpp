// When cracks grow in a load history, and which of its cycles tell how fast.
#pragma once

#include <string>
#include <vector>

#include "coarse/load/load_controller.hpp"
#include "common/case/case.hpp"

namespace stria::coarse {

/// True where a crack of this length, mm, ends the run where it would grow next.
[[nodiscard]] bool is_as_long_as_asked(const GrowthSection& growth, double a);

/// True where the cracks advance once a step of the load has been reached.
[[nodiscard]] bool grows_at(const GrowthSection& growth, const LoadStep& step);

/// True where the rate of a growth is the mean of all cycles since the one before: by a law of da/dN under a load that
/// varies, several cycles from one growth to the next. Else it is that of the last cycle, which has settled.
[[nodiscard]] bool takes_mean_rate(const Case& input);

/// True in the last cycle before the cracks grow again, or in that of the present growth where they grow at minima.
[[nodiscard]] bool ends_period(const GrowthSection& growth, int cycle);

/// The last cycle of a history, if it rises to another maximum than that of the first one, with which a sequence goes
/// on; else 0.
[[nodiscard]] int cycle_cut_off(const LoadSection& load);

/// Sentences where a law of da/dN sees other cycles than those of the load, or what closes a crack that nothing closes.
[[nodiscard]] std::vector<std::string> growth_warnings(const Case& input);

}  // namespace stria::coarse
