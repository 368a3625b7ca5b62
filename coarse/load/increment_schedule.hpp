// Where the increments between two reversals end, and how many there are where the program chooses (load.steps =
// "auto"): the opening behind a tip over the load is a path, and increments follow it along chords.
#pragma once

#include <optional>
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

/// |o''| / range at the end of a path o(way); the largest of the tips. What a leg lays down it lays down at its end:
/// paths of plastic strain that come nearly straight there forget how they came. A tip whose faces touch at the end has
/// nothing to say: its opening bends where they met. Nothing where no tip has.
[[nodiscard]] std::optional<double> curvature_at_end(const OpeningPath& path);

/// Parts of the way at which increments end, the first 0: k of h ends at (k/h)^grading. The one that ends nearest to
/// one of `turns`, where a load case turns, ends there.
[[nodiscard]] std::vector<double> graded_ways(int increments, double grading, const std::vector<double>& turns = {});

/// A last increment over a part w of the way is off by |o''| w^2 / 6 of the range (docs/performance.md has what was
/// measured). Legs that load and legs that unload have numbers of their own, of 3 to 24 increments. A number grows
/// after a leg whose end was farther off than `accuracy`, and falls by one where one less would clearly do: a predictor
/// wants the same increments a cycle later.
class IncrementSchedule {
public:
    struct State {
        int rising = 0, falling = 0;  // increments of a leg
        OpeningPath path;             // of the present leg
    };

    /// Chooses only where load.steps is no number, and `may_choose`. `turns`: as for graded_ways.
    IncrementSchedule(const LoadSection& load, std::vector<double> turns, bool may_choose);

    /// Parts of the way at which increments end, the first 0.
    [[nodiscard]] const std::vector<double>& ways(bool rises) const { return rises ? rising_ : falling_; }

    /// The state that the present leg starts from; and one that it has reached.
    void begin(std::vector<double> openings);
    void add(double way, std::vector<double> openings);
    /// The leg is done; its last state begins the next one.
    void end_leg(bool rises);

    [[nodiscard]] const State& state() const { return state_; }
    void resume(const State& state);

private:
    [[nodiscard]] double error(double curvature, int increments) const;
    [[nodiscard]] int enough(double curvature, int present) const;
    void learn(int& present, bool rises);
    void lay_out();

    bool chooses_;
    double accuracy_, grading_;
    std::vector<double> turns_, rising_, falling_;
    State state_;
};

}  // namespace stria::coarse
