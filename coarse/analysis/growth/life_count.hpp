// How many cycles growth takes: the sum of da over da/dN, where K is known and behind sharp turns.
#pragma once

namespace stria::coarse {

/// About the fastest tip at the end of a cycle.
struct GrownTip {
    double grown = 0.0;        // since the end of the cycle before, mm
    double behind_turn = 0.0;  // from the last sharp turn of its crack to the tip, mm; infinite where there is none
    double resolved = 0.0;     // K of a tip that is nearer to a turn is not resolved, mm
};

/// By the trapezoidal rule of 1 / rate. Where a crack turns sharply its K leaps, and what follows is not resolved until
/// the tip is two elements farther: the rate before the turn says nothing of the growth behind it. So that growth is
/// counted once K is known again, at the rate that the tip has then.
class LifeCount {
public:
    /// `uncounted`: of a run that goes on.
    explicit LifeCount(double uncounted = 0.0) : uncounted_(uncounted) {}

    /// Cycles that a growth took; rates da/dN of the fastest tip, mm per cycle, NaN: not known. None where they are
    /// counted later.
    double passed(const GrownTip& tip, double rate_before, double rate_after);

    /// Grown since a turn and not yet counted, mm.
    [[nodiscard]] double uncounted() const { return uncounted_; }

private:
    double uncounted_;
};

}  // namespace stria::coarse
