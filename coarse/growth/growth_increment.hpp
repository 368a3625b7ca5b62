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

/// Of a tip, the largest forward plastic zone in the cycles since it has grown, mm: one that has shaken down has none.
struct ForwardZone {
    double ahead = 0.0, anywhere = 0.0;  // straight ahead; and to the sides as well
};

/// A checkpoint holds it.
struct GrowthIncrementMemory {
    double increment = 0.0;               // mm, the last one chosen; 0: none yet
    std::vector<GrowthPoint> points;      // the last two
    std::vector<ForwardZone> zones = {};  // one per tip
};

/// The largest that is chosen, mm, for what the forward plastic zone extends straight ahead of the tip and a crack
/// length, mm. `flows`: there is such a zone, maybe to the sides alone.
[[nodiscard]] double largest_increment(const GrowthSection& growth, bool flows, double zone_ahead, double a);

/// An increment of the fastest tip, mm, cut to what it is until a crack is as long as asked. One per tip: cycles that
/// have ended, of which the lengths count; and `lengthening`, as for GrowthIncrement::next().
[[nodiscard]] double cut_to_end(double increment, const GrowthSection& growth, const std::vector<CycleResult>& last,
                                const std::vector<double>& lengthening);

/// Of a tip, what it had reached when it grew: its length, mm, and the largest nominal K since the growth before, MPa
/// sqrt(mm).
struct LengthAndK {
    double a = 0.0, K = 0.0;
};

/// The same, cut to where K of a tip reaches `toughness`, MPa sqrt(mm), and a thousandth beyond: K goes with a power of
/// the length, by `now` and the growth `before` (empty: with its root; no more than its fifth power, by which K rises
/// where the load does). One per tip. Not less than a hundredth of the increment, for K may rise more slowly.
[[nodiscard]] double cut_to_toughness(double increment, double toughness, const std::vector<LengthAndK>& now,
                                      const std::vector<LengthAndK>& before, const std::vector<double>& lengthening);

/// What the mesh about the fastest tip asks of an increment, mm.
struct TipSteps {
    std::size_t tip = 0;  // its number
    double least = 0.0;
    double element = 0.0;  // increments are whole numbers of it; 0: of any size
    double beyond = 0.0;   // Tip::beyond: the next one makes up for what of it is no whole element
};

/// Increments of the fastest tip: at most `zone_fraction` of the plastic zone that the tip has just loaded, straight
/// ahead of it, so that the wake is laid down in steps that the zone is large against (to the sides it is four times as
/// large in plane strain, and by such steps K_op comes out too high: docs/verification/closure.md, how many elements);
/// at least an element at the tip, because K behind a bend that is nearer is not resolved. Where faces end on element
/// edges, whole elements from one edge to another: else now none and now two of them open, and K_op swings. Where
/// openings drive the growth one element, since two leave a crest that holds the faces: lives were 8 % longer. The
/// first is the smallest, each at most twice the one before, and smaller where errors would pass `accuracy`: with d the
/// distance of the last but one value from the chord between its neighbours, d / 2 of `per_mm` relative to it (the
/// trapezoidal rule of a life is off by d / 6 where the rate is smooth, by d at a jump), and d of `closure`. Errors
/// fall with the square of the size.
class GrowthIncrement {
public:
    explicit GrowthIncrement(GrowthIncrementMemory memory = {}) : memory_(std::move(memory)) {}

    /// A cycle has ended; one result per tip.
    void add(const std::vector<CycleResult>& cycles);

    /// The next one, mm. One per tip: `last`, the cycle that has ended; `rates`, mm per cycle, of which one at least is
    /// not zero; `lengthening`, by which its `a` grows of what the fastest tip advances: that of half a crack with two
    /// tips by half of what both do. Only an end of growth is nearer than the least.
    double next(const GrowthSection& growth, const std::vector<CycleResult>& last, const std::vector<double>& rates,
                const std::vector<double>& lengthening, const TipSteps& steps);

    [[nodiscard]] const GrowthIncrementMemory& memory() const { return memory_; }

private:
    [[nodiscard]] double error_at(const GrowthPoint& now) const;

    GrowthIncrementMemory memory_;
};

}  // namespace stria::coarse
