// One signal of closure through a cycle: the loads at which a tip opens and closes by it.
#pragma once

#include "coarse/cycle/cycle_result.hpp"

namespace stria::coarse {

/// K_op belongs to the rise that leads to the largest K of the cycle: the last contact that is lost in it, or the K
/// where it begins, if the tip is open by then. K_cl is of the first contact that is made while K falls. K rises and
/// falls as the tip has it, and not as [load] does: of two cracks in a plate that is bent one closes as the other
/// opens.
struct SignalOfCycle {
    OpeningLoads found;     // of the cycle so far
    OpeningLoads rising;    // K_op of the present rise, or of where the next one begins; kept until it closes
    OpeningLoads rest;      // likewise, of a rise that belongs to the cycle before
    bool changed = false;   // in this cycle
    bool was_open = false;  // in it, at the end of some increment

    /// Another cycle begins, perhaps within a rise.
    void begin_cycle() { *this = {.found = {}, .rising = rising, .rest = {}}; }
    /// Contact is made (`closes`) or lost at `K`, which is not a number where nobody found it. `rise`: of K over the
    /// increment; zero where the load stands.
    void note_change(bool closes, double K, double rise);
    /// At the end of an increment. No change tells what comes or goes at that load itself, behind the longer crack; and
    /// where contact is lost on the way down the tip is open from the minimum on. `K`: the least that it is known to be
    /// open at, or closed. Of a tip that is closed as K falls, or stands, the rise before tells nothing any more.
    void note_state(bool is_open, double K, double rise);
    /// K is at the largest of the cycle so far, or of the rest of the cycle before.
    void reach_largest() { take(found); }
    void reach_largest_of_rest() { take(rest); }
    /// The rise of the cycle before went no higher than that of this one, which is to come: it stands for it.
    void take_rest();
    /// There is no such rise, and K goes on to rise as the cycle ends: where it opens then nobody tells.
    void miss_rest();

    /// `K_min`: what opens a tip that is open all cycle. Of one that is closed all cycle there is nothing to say.
    [[nodiscard]] OpeningLoads loads(double K_min) const;

private:
    void take(OpeningLoads& largest) const;
};

}  // namespace stria::coarse
