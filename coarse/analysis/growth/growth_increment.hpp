// How far a crack grows in one computed cycle where the program chooses it (growth.increment = "auto").
#pragma once

#include <vector>

#include "coarse/cycle/cycle_result.hpp"
#include "common/case/case.hpp"

namespace stria::coarse {

/// What the choice goes by, at a crack length.
struct GrowthPoint {
    double a = 0.0;        // mm
    double per_mm = 0.0;   // cycles that a millimetre of growth takes
    double closure = 0.0;  // K_op / K_max; 0 where nothing is measured
};

/// A checkpoint holds it.
struct GrowthIncrementMemory {
    double increment = 0.0;           // mm, the last one chosen; 0: none yet
    std::vector<GrowthPoint> points;  // the last two
};

/// The largest that is chosen, mm, for a forward plastic zone and a crack length, mm.
[[nodiscard]] double largest_increment(const GrowthSection& growth, double forward_zone, double a);

/// Increments of the fastest tip: at most `zone_fraction` of the plastic zone that the tip has just loaded, so that the
/// wake is laid down in steps that the zone is large against; at least an element at the tip, because K behind a bend
/// that is nearer is not resolved. The first is the smallest, each at most twice the one before, and smaller where
/// errors would pass `accuracy`: with d the distance of the last but one value from the chord between its neighbours,
/// d / 2 of `per_mm` relative to it (the trapezoidal rule of a life is off by d / 6 where the rate is smooth, by d at a
/// jump), and d of `closure`. Errors fall with the square of the size.
class GrowthIncrement {
public:
    explicit GrowthIncrement(GrowthIncrementMemory memory = {}) : memory_(std::move(memory)) {}

    /// The next one, mm; `last`: the cycle that has ended, one per tip, of which one at least is driven. `least`: mm,
    /// as the mesh has it; only an end of growth is nearer.
    double next(const GrowthSection& growth, const std::vector<CycleResult>& last, double least);

    [[nodiscard]] const GrowthIncrementMemory& memory() const { return memory_; }

private:
    [[nodiscard]] double error_at(const GrowthPoint& now) const;

    GrowthIncrementMemory memory_;
};

}  // namespace stria::coarse
