// How fast tips grow over the cycles from one growth to the next.
#pragma once

#include <vector>

namespace stria::coarse {

/// Of a period, the cycles between two growths. A checkpoint holds it.
struct PeriodMemory {
    std::vector<double> sum;             // of the rates of its cycles so far, one per tip, mm per cycle
    int cycles = 0;                      // so far
    std::vector<double> grown;           // where it began, one per tip, mm
    std::vector<double> before;          // mean rates of the period before, one per tip; empty: there was none
    std::vector<double> at_growth = {};  // likewise, of that before the last growth; empty: there was no growth
};

/// Mean rates da/dN of the tips over a period. A repeated load makes the crack grow by the sum over its sequence, so
/// many times; which cycle is the last one is of no account.
class PeriodRates {
public:
    explicit PeriodRates(PeriodMemory memory = {}) : memory_(std::move(memory)) {}

    /// A cycle has ended, and is the first of a period if `begins`. `rates`, mm per cycle, and `grown` since the cycle
    /// before, mm: one per tip.
    void add(const std::vector<double>& rates, const std::vector<double>& grown, bool begins);

    /// Means of the present period, one per tip, mm per cycle. Empty before the first cycle.
    [[nodiscard]] std::vector<double> present() const;
    [[nodiscard]] const std::vector<double>& before() const { return memory_.before; }
    /// What they are in the middle of a growth as long as the last one, one per tip, mm per cycle: their logarithms go
    /// on as over that one, by a factor of 2 at most. Those of the present where nothing has grown. It is for cycles
    /// that are all alike.
    [[nodiscard]] std::vector<double> ahead() const;
    [[nodiscard]] const std::vector<double>& grown() const { return memory_.grown; }

    [[nodiscard]] const PeriodMemory& memory() const { return memory_; }

private:
    PeriodMemory memory_;
};

}  // namespace stria::coarse
