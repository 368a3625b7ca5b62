// What a run says of itself where it finds no equilibrium, or not all that is asked for.
#pragma once

#include <string>
#include <vector>

#include "coarse/analysis/analysis_state.hpp"
#include "coarse/cycle/increment.hpp"
#include "coarse/equilibrium/newton.hpp"

namespace stria::coarse {

/// The last equilibrium that was found.
struct LastConverged {
    int increments = 0;  // up to it; 0: there is none
    Target reached;
    double load_factor = 0.0;
};

/// Halved so often an increment still finds none.
[[nodiscard]] std::string no_equilibrium(const LoadStep& step, const NewtonReport& report, int halvings,
                                         const LastConverged& last);

[[nodiscard]] std::string stress_does_not_settle(const NewtonReport& report);

/// Figure 3 (b) finds no equilibrium at once.
[[nodiscard]] std::string released_in_parts(const LoadStep& step, const NewtonReport& report);

/// Figure 3 (b) has no end. `nominal`: one per tip, of the longer cracks.
[[nodiscard]] std::string faces_not_released(const LoadStep& step, const NewtonReport& report,
                                             const FaceRelease& release, const std::vector<TipResult>& nominal);

/// No trial on the way to a step tells where a tip opens, closes or slides (`does`).
[[nodiscard]] std::string load_left_empty(const LoadStep& step, const Target& reached, int tip, const char* does);

/// Counts an increment in which no ring about a tip lies outside what has flowed, or in which faces without contact
/// overlap. Says so for the first of a kind.
[[nodiscard]] std::vector<std::string> count_doubts(const Increment& increment, const Scene& scene, RunCounts& counts);

/// Empty where the work that the loads have done is found again: to within a hundredth of it, and of what flow,
/// friction and growth have taken well enough for that to be a number.
[[nodiscard]] std::string work_out_of_balance(const WorkBalance& work);

/// Half cycles with as many increments as there may be are still off by a part of the range of the opening
/// (IncrementSchedule::take_miss()).
[[nodiscard]] std::string misses_accuracy(double off, double accuracy);

/// Of so many elements outside the zone that are beyond yield.
[[nodiscard]] std::string elements_stay_elastic(const LoadStep& step, std::size_t elements);
[[nodiscard]] std::string elements_join_zone(const LoadStep& step, std::size_t elements);

}  // namespace stria::coarse
