// Hands out the next target, a load factor or a displacement: a ramp to the first maximum, then cycles max -> min ->
// max, block after block; halves an increment that failed and lets it grow again.
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "coarse/target.hpp"
#include "common/predictor.hpp"

namespace stria::coarse {

struct LoadStep {
    int cycle = 0;  // 0: the ramp
    Target target;
    // The same increment a cycle ago; else the last one, in proportion; nothing at the start and after a reversal.
    Predictor predictor;
    bool reversal = false;  // a half cycle ends here
    bool at_maximum = false, at_minimum = false,
         at_zero = false;  // extremes of the cycle, and the step nearest to a target of zero
    bool ends_cycle = false;
};

class LoadController {
public:
    explicit LoadController(const LoadSection& load, const SolverSection& solver);

    /// The next target, or nothing when all blocks are done.
    [[nodiscard]] std::optional<LoadStep> next() const;

    void accepted();

    /// Increments taken so far are of no use to predict from: their unknowns are gone.
    void forget_increments() { taken_.clear(); }

    /// Halves the increment; false after `max_cuts` halvings.
    [[nodiscard]] bool cut();

    [[nodiscard]] int cuts() const { return cuts_; }
    /// The value reached: a load factor, or a displacement, mm.
    [[nodiscard]] double reached() const { return reached_; }

private:
    struct Stop {  // of uncut increments
        int cycle;
        double value;
        bool reversal, at_maximum, at_minimum, at_zero, ends_cycle;
    };
    void mark_reversals();
    void append_leg(int cycle, double from, double to, const LoadSection& load);

    Control control_;
    std::vector<Stop> stops_;
    std::size_t stop_ = 0;  // the next
    double reached_ = 0.0;
    struct Taken {
        int cycle;
        double from, to;
    };
    [[nodiscard]] Predictor predictor(int cycle, double to) const;
    std::deque<Taken> taken_;  // the last one first
    std::size_t remembered_;
    double fraction_ = 1.0;  // of a whole increment, after cuts
    int consecutive_cuts_ = 0, max_cuts_ = 0, cuts_ = 0;
};

}  // namespace stria::coarse
