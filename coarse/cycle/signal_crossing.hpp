// Where between two states a signal of closure passes zero, from states that have been tried and from what is expected.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "coupling/messages.hpp"

namespace stria::coarse {

/// A state on the way of an increment.
struct ClosureStation {
    double target, load_factor;
    std::vector<double> signal;                          // ClosureMeter::signal()
    std::vector<coupling::NearestContact> nearest = {};  // ClosureMeter::nearest()
};

[[nodiscard]] inline bool is_closed(double signal) { return signal > 0.0; }

/// What is expected of a signal: the target at which it passes zero, and what it changes by per target beside that, on
/// its open side and on its closed one. NaN: nobody knows.
struct ExpectedCrossing {
    double target = NAN;
    std::array<double, 2> rate{NAN, NAN};
};

/// What follows three values of a series whose changes grow or fade evenly, as opening loads come to their level: the
/// last and its change, as much smaller as that was smaller than the change before it. Where changes turn, or one is
/// not a number, the last; where they leap, little more.
[[nodiscard]] double next_in_series(double first, double second, double third);

/// Where between two stations a signal passes zero, as a share of the way, and whether that is known.
struct Crossing {
    double share;
    bool known;
};

/// Of signal k, between the stations i and i + 1 of a way, which say otherwise of it. Known to half of `precision`, of
/// a target; else where to try next.
[[nodiscard]] Crossing crossing(const std::vector<ClosureStation>& way, std::size_t i, std::size_t k, double precision,
                                const ExpectedCrossing& expected);

/// What signal k changes by per target on either side of `target`, at which it has been found to pass zero between the
/// stations i and i + 1: by the nearest station on each side that is neither on it nor far away.
[[nodiscard]] std::array<double, 2> rates_beside(const std::vector<ClosureStation>& way, std::size_t i, std::size_t k,
                                                 double precision, double target);

}  // namespace stria::coarse
