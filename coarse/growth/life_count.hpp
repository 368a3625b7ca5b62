// How many cycles growth takes: the sum of da over da/dN, where K is known and behind sharp turns.
#pragma once

#include <limits>

#include "coarse/growth/growth_law.hpp"

namespace stria::coarse {

/// About a tip at the end of a cycle.
struct GrownTip {
    double grown = 0.0;        // since the end of the cycle before, mm
    double length = 0.0;       // of its crack, as reported, mm; 0: not known
    double lengthening = 1.0;  // by which that becomes longer per mm that the tip grows
    double behind_turn = 0.0;  // from the last sharp turn of its crack to the tip, mm; infinite where there is none
    double resolved = 0.0;     // K of a tip that is nearer to a turn is not resolved, mm
    bool ends = false;         // growth ends the run here

    [[nodiscard]] bool is_resolved(double way) const { return way >= (1.0 - 1e-6) * resolved; }
    [[nodiscard]] bool is_resolved() const { return is_resolved(behind_turn); }
};

/// The last growth that was counted.
struct CountedGrowth {
    double grown = 0.0;          // mm; 0: there was none, or the length is not known
    RateAtLength from, to = {};  // where it began and ended
    double doubt = 0.0;          // cycles, as these two tell; 0: one before it has told, too
};

/// A checkpoint holds it.
struct LifeMemory {
    double uncounted = 0.0;                                          // grown since a turn and not yet counted, mm
    double rate_at_turn = std::numeric_limits<double>::quiet_NaN();  // with which that began, mm per cycle
    double doubt = 0.0;                                              // sum of cycles_in_doubt()
    CountedGrowth last = {};
};

/// By the trapezoidal rule of 1 / rate. Where a crack turns sharply its K leaps, and what follows is not resolved until
/// the tip is two elements farther. So that growth is counted once K is known again: from the rate of a crack that has
/// just turned to the one that the tip has then. Where the run ends before, to the larger of these.
class LifeCount {
public:
    /// `root`: as in cycles_in_doubt().
    explicit LifeCount(LifeMemory memory = {}, double root = 0.0) : memory_(memory), root_(root) {}

    /// The fastest tip turns sharply, and its rate leaps to this one, mm per cycle. Not positive, or NaN: not known,
    /// and the rate that it has two elements on stands for it.
    void turn(double rate);

    /// Cycles that a growth took; rates da/dN of the fastest tip, mm per cycle, NaN: not known. None where they are
    /// counted later.
    double passed(const GrownTip& tip, double rate_before, double rate_after);

    [[nodiscard]] const LifeMemory& memory() const { return memory_; }

private:
    double count(const GrownTip& tip, double grown, double rate_before, double rate_after);
    void doubt(double grown, double lengthened, const RateAtLength& from, const RateAtLength& to);

    LifeMemory memory_;
    double root_;
};

}  // namespace stria::coarse
