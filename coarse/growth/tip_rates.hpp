// How fast the tips grow by a law, what that makes of an increment of the fastest one, and how many cycles it took.
#pragma once

#include <cstddef>
#include <vector>

#include "coarse/cycle/cycle_result.hpp"
#include "coarse/growth/life_count.hpp"
#include "coarse/growth/period_rates.hpp"
#include "coarse/model/scene.hpp"
#include "common/case/case.hpp"

namespace stria::coarse {

/// A checkpoint holds it.
struct TipRatesMemory {
    PeriodMemory period;
    LifeMemory life;
    std::vector<double> at_turn;  // just behind the last sharp turn of each tip, mm per cycle; NaN: K is resolved
    // By what the tips have advanced too little in the last growth, mm, of what the fastest one did; where no trend is
    // told. Empty: by nothing.
    std::vector<double> owed = {};
    double last = 0.0;  // way of the fastest one in it, mm
};

/// The rate of a tip that turns sharply leaps by a factor; NaN: by what is not known.
struct SharpTurn {
    std::size_t tip = 0;
    double leap = 0.0;
};

class TipRates {
public:
    /// Of a case whose cracks grow.
    explicit TipRates(const Case& input, TipRatesMemory memory = {});

    [[nodiscard]] TipRatesMemory memory() const { return {period_.memory(), life_.memory(), at_turn_, owed_, last_}; }

    /// da/dN of the tips, mm per cycle; empty before the first cycle has ended. K of a tip that has just turned is not
    /// resolved and far too low: until it is, the rate with which the tip left the turn stands for a lower one, or a
    /// tip would never leave it.
    [[nodiscard]] std::vector<double> present() const;
    [[nodiscard]] bool drive_a_tip() const;

    /// They are means over the cycles from one growth to the next.
    [[nodiscard]] bool are_means() const { return takes_mean_; }
    /// And all cycles of such a period have told theirs. At minima the first chance to grow has a cycle less behind it.
    [[nodiscard]] bool are_of_a_whole_period() const;
    /// They are of the last cycle, and those that follow are other ones.
    [[nodiscard]] bool end_with_the_cycle() const { return varies_ && !takes_mean_; }

    /// What each of so many tips advances next of what the fastest one does: by the rates in the middle of the growth
    /// where they tell a trend; else by those where it begins, and what the last growth lacked by the mean of the rates
    /// at its ends, for a growth as long as that.
    [[nodiscard]] std::vector<double> shares(std::size_t tips) const;
    /// By which `a` of each tip grows then: half of a crack with two tips by half of what both do.
    [[nodiscard]] std::vector<double> lengthening(const std::vector<Tip>& tips) const;

    /// The tips turn so in a growth.
    void leap(const std::vector<SharpTurn>& turns);

    /// A tip that has stood still turns sharply, and grows at this rate behind its turn, mm per cycle.
    void start(std::size_t tip, double rate);

    /// Takes the rates of a cycle that has ended, and puts into `cycles`, one per tip, how many it stands for: what the
    /// growth took that is known to its end. `present`: with the tips as long as at its end.
    void count_cycles(int cycle, std::vector<CycleResult>& cycles, const Scene& present);
    /// Growth of the fastest tip of which no cycle has told yet how many it took, mm: of all, and of past periods.
    [[nodiscard]] double uncounted() const;
    [[nodiscard]] double uncounted_of_the_past() const { return life_.memory().uncounted; }
    /// Cycles that the life may be off by, since the rate changes from one growth to the next.
    [[nodiscard]] double life_in_doubt() const { return life_.memory().doubt; }

private:
    [[nodiscard]] bool has_just_turned(std::size_t tip) const;
    [[nodiscard]] bool one_has_just_turned(std::size_t tips) const;
    [[nodiscard]] bool tell_a_trend() const;
    /// Of the growth at the beginning of the period that the last cycle ends, which took so many cycles; 0: that is not
    /// known.
    void owe(double passed);
    /// Of the growth at the beginning of the period that the last cycle ends, one result per tip. `ends`: growth ends
    /// the run.
    [[nodiscard]] double cycles_of_period(const Scene& present, const std::vector<CycleResult>& last, int cycle,
                                          bool ends);

    GrowthSection growth_;
    bool varies_, takes_mean_;
    int cut_off_;  // the last cycle, where it does not rise as the sequence would; 0: it does
    PeriodRates period_;
    LifeCount life_;
    std::vector<double> at_turn_, owed_;
    double last_;
};

}  // namespace stria::coarse
