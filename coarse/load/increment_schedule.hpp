// Where the increments between two reversals end, and how many there are where the program chooses (load.steps =
// "auto"): as many as the opening behind a tip takes to come out right, which two increments tried as one tell.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "common/case/case.hpp"

namespace stria::coarse {

/// What was measured on a leg: openings behind the tips, mm, over parts of its way.
struct OpeningPath {
    std::vector<double> way;                   // ascending, from 0; from beyond it where the start is not known
    std::vector<std::vector<double>> opening;  // per station: one per tip, NaN where there is none

    void begin(std::vector<double> openings);
    void add(double at, std::vector<double> openings);
};

/// How K of the tips goes with [load]; of two cracks in a plate that is bent one may go with it and the other against.
struct SensesOfK {
    bool with_load = true, against_load = false;  // of some tip
};

/// Two increments of a leg that follow each other, tried as one: from where to where, in parts of the way, and the
/// openings that this came to.
struct TwoAsOne {
    double from, to;
    std::vector<double> opening;  // one per tip, mm; NaN where none is known
};

/// What the increments of a leg are off by, of the range of the opening; the largest of the tips. Two over the parts v
/// and w of the way differ by 2 c v w from one over both, if an increment over w is off by c w^2: so much is taken from
/// the pairs and added up. A tip of which a pair knows no opening is elastic, and not off. Nothing where a pair is not
/// of the path, or no tip has an opening that changes.
[[nodiscard]] std::optional<double> error_of_leg(const OpeningPath& path, const std::vector<TwoAsOne>& pairs);

/// Parts of the way at which increments end, the first 0: k of h ends at (k/h)^grading.
[[nodiscard]] std::vector<double> graded_ways(int increments, double grading);

/// The same ways, but that the inner end nearest to each of `turns`, where a load case turns, lies there.
[[nodiscard]] std::vector<double> through_turns(std::vector<double> ways, const std::vector<double>& turns);

/// Legs that load and legs that unload have numbers of their own, of 4 to 24 increments, or to 40 where faces are
/// pressed together; at an accuracy below 0.002 up to four times as many. How far a leg is off is
/// measured now and then: each two of its increments are tried as one before they are taken (error_of_leg). It falls
/// with the square of the number (docs/verification/increments.md), which is then chosen for an error of a third of the
/// accuracy: a cycle has two legs, and the accuracy is that of all cycles while one is measured. In between the number
/// stays, since a predictor wants the same increments a cycle later. What an increment is off by in which faces meet no
/// opening tells, since they are closed at its end, and there the path of the metal bends. So one increment of a leg
/// that unloads a tip ends where they are expected to meet, those behind it begin small, and such a leg has at least
/// half as many as one that loads. Where it goes on into compression what the tip has left is crushed, and no opening
/// tells: four tenths of its increments come before faces meet, and it has no fewer than 8 at an accuracy of 0.002.
/// Until one of them has been measured, from the first one on, it has 20, and one that comes back from there 12: few
/// tried as fewer tell too little. What such cycles are off by adds up as a crack grows, so that their legs are chosen
/// for a sixth of the accuracy (docs/verification/increments.md).
class IncrementSchedule {
public:
    /// Those of one direction.
    struct Legs {
        int increments = 0;           // of a leg
        int alike = 0;                // in a row, from and to the same
        int unmeasured = 0;           // since one was measured
        bool taken = false;           // one has been, of a cycle
        bool knows_pressing = false;  // one has been measured that presses faces together, or comes back from there
    };
    struct State {
        Legs rising, falling;
        OpeningPath path;                   // of the present leg
        std::vector<TwoAsOne> pairs = {};   // likewise
        std::vector<double> meetings = {};  // likewise: parts of its way, ascending
        bool presses = false;               // likewise: it goes to or comes from a load that presses faces together
        SensesOfK senses = {};
        bool tells = false;   // likewise: an opening was known where it began
        bool missed = false;  // the accuracy, by some leg so far
    };

    /// Chooses where load.steps is no number.
    explicit IncrementSchedule(const LoadSection& load);
    /// The same ways in each leg.
    IncrementSchedule(const LoadSection& load, std::vector<double> ways);

    /// Parts of the way at which increments end, the first 0.
    [[nodiscard]] const std::vector<double>& ways(bool rises) const { return rises ? rising_ : falling_; }

    /// The state that the present leg starts from; and one that it has reached.
    void begin(std::vector<double> openings);
    void add(double way, std::vector<double> openings);
    /// The increments of the present leg are to be tried by twos. `alike`: it goes from and to where the one before in
    /// its direction did.
    [[nodiscard]] bool measures(bool rises, bool alike) const;
    /// The last of the same place counts: an increment that is made again, with a larger zone, is tried again before.
    void add(TwoAsOne pair);
    /// The leg is done; its last state begins the next one.
    void end_leg(bool rises, bool alike);
    /// Parts of the way at which faces are expected to meet in the leg that begins; next to its ends they do not count.
    /// `presses`: it goes to a load that presses them together, or comes from there.
    void meet_at(std::vector<double> ways, bool presses = false, SensesOfK senses = {});

    /// What the first leg is off by that needs more increments than there may be, of the range of the opening: where
    /// that is more than its half of the accuracy. Told once.
    [[nodiscard]] std::optional<double> take_miss() { return std::exchange(miss_, std::nullopt); }

    [[nodiscard]] const State& state() const { return state_; }
    void resume(const State& state);

private:
    void learn(bool rises);
    [[nodiscard]] double times_as_many() const;  // increments, for this accuracy and not the usual one
    [[nodiscard]] int most() const;
    [[nodiscard]] int within_limits(double wanted) const;
    [[nodiscard]] int increments(const Legs& legs) const;
    [[nodiscard]] std::vector<double> ways(const Legs& legs) const;
    [[nodiscard]] std::vector<double> ways_before(double meeting, int all) const;
    void lay_out();

    bool chooses_;
    double accuracy_, grading_;
    std::vector<double> rising_, falling_;
    State state_;
    std::optional<double> miss_;
};

}  // namespace stria::coarse
