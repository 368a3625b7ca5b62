// Which of the increments taken before tells the next one.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "common/predictor.hpp"

namespace stria::coarse {

struct TakenIncrement {
    int cycle = 0;                                   // 0: the ramp
    double from = 0.0, to = 0.0;                     // in units of the history
    Eigen::VectorXd cases_from = {}, cases_to = {};  // factors of the load cases
};

/// Nearly the same increment of a cycle before; else the last one, in proportion; nothing at the start and after a
/// reversal. `before`: the last one first.
[[nodiscard]] Predictor predictor_from(const std::vector<TakenIncrement>& before, const TakenIncrement& next);

}  // namespace stria::coarse
