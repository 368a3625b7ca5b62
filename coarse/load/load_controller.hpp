// Hands out the next target, a load factor or a displacement, on the way from one extreme of the history to the next;
// halves an increment that failed and lets it grow again.
#pragma once

#include <optional>
#include <vector>

#include "coarse/load/case_histories.hpp"
#include "coarse/load/increment_schedule.hpp"
#include "coarse/load/load_factors.hpp"
#include "coarse/load/load_scale.hpp"
#include "coarse/load/load_step.hpp"
#include "coarse/load/taken_increment.hpp"

namespace stria::coarse {

/// How far a load has come: all that a controller remembers.
struct LoadPosition {
    std::size_t leg = 0;
    int increments = 0;          // of the leg, done
    double leg_start = 0.0;      // target where it began
    double reached = 0.0;        // target: a load factor, or a displacement, mm
    double way = 0.0;            // of the leg, done
    Eigen::VectorXd cases = {};  // factors of the load cases that are reached
    double fraction = 1.0;       // of a whole increment, after cuts
    int consecutive_cuts = 0, cuts = 0;
    std::vector<TakenIncrement> taken;  // increments to predict from, the last one first
    int misled = 0;                     // in a row, of those that were predicted from
    IncrementSchedule::State schedule = {};
};

/// Loads at the two ends of a half cycle. Where a displacement is controlled the main factor is that of the nominal
/// body.
struct LegEnds {
    LoadFactors from, to;
    double course = 0.0;  // above zero where the value of [load] rises, below zero where it falls
};

/// What a half cycle is expected to do to the tips.
struct LegOutlook {
    /// Loads at which faces that it closes are expected to meet, in units of the history; NaN: never.
    std::vector<double> met = {};
    bool presses = false;  // it goes to a load that presses faces together, or comes from there
    SensesOfK senses = {};
};

class LoadController {
public:
    explicit LoadController(const LoadSection& load, const SolverSection& solver, CaseHistories cases = {});

    [[nodiscard]] LoadPosition position() const;
    /// Goes on from where another one stood, in a history that was the same up to there.
    void resume(const LoadPosition& position);

    /// What a unit of the history is as a target, from now on; 1, or where K is controlled the load factor of a unit of
    /// K.
    void set_scale(double scale) { scale_ = scale; }
    [[nodiscard]] double scale() const { return scale_; }

    /// The next target, or nothing when all is done.
    [[nodiscard]] std::optional<LoadStep> next() const;

    /// Loads may go on to grow while [load] falls, and are known: load cases lag, and nothing but load is controlled.
    [[nodiscard]] bool looks_ahead() const { return control_ == Control::Load && cases_.lag(); }
    /// If so: the loads of the quarter of a cycle behind the present leg, the first those of its end, the last a little
    /// farther on. They are those of loads that turn back, and not what the history says: a run that is made longer
    /// knew nothing of that. Else none.
    [[nodiscard]] std::vector<LoadFactors> next_quarter() const;

    /// The next two increments of a leg as one, before they are taken, where that is to be tried to see how far the leg
    /// is off (IncrementSchedule); and the openings that it came to.
    [[nodiscard]] std::optional<LoadStep> two_as_one() const;
    void tried_as_one(std::vector<double> openings);
    /// IncrementSchedule::take_miss().
    [[nodiscard]] std::optional<double> take_missed_accuracy() { return schedule_.take_miss(); }

    /// `openings`: behind the tips, mm (OpeningPath); or nothing where they choose no increments.
    void accepted(std::vector<double> openings = {});

    /// Where the loaded boundary stands, mm. Where a displacement is controlled and no increment of [load] has been
    /// taken, its first half cycle goes on from there: dead loads and an initial stress have moved the boundary.
    void stands_at(double displacement);

    /// The half cycle of which no increment has been taken; nothing within one, or when all is done. `unit`: of the
    /// nominal body.
    [[nodiscard]] std::optional<LegEnds> leg_that_begins(const UnitDisplacement& unit) const;
    /// Of that one, before its increments are taken.
    void expect(const LegOutlook& outlook);

    /// An increment has been committed at the load that is reached, which is no step of the history.
    void committed_besides(int cycle, std::vector<double> openings = {});

    /// Increments taken so far are of no use to predict from: their unknowns are gone.
    void forget_increments() { position_.taken.clear(); }

    /// Whether Newton's method was misled by what the increment was predicted from, as one is where a crack has grown
    /// onto other elements. Where two in a row mislead, the others would too.
    void judge_predictor(bool misled);

    /// Halves the increment; false after `max_cuts` halvings.
    [[nodiscard]] bool cut();

    [[nodiscard]] int max_cuts() const { return max_cuts_; }
    [[nodiscard]] int cuts() const { return position_.cuts; }
    /// The value reached: a load factor, or a displacement, mm.
    [[nodiscard]] double reached() const { return position_.reached; }
    [[nodiscard]] Target reached_target() const { return {control(), position_.reached, 0.0, position_.cases}; }
    /// How much of the loads of the present half cycle the next increment changes: of that load which changes most, in
    /// parts of the largest magnitude that it comes to there.
    [[nodiscard]] double part_of_loads() const;

private:
    [[nodiscard]] bool begins_leg() const {
        return position_.leg < legs_.size() && position_.increments == 0 && position_.way == 0.0;
    }
    /// What of a leg is done where the next increment ends, and whether that is where an uncut one does.
    struct Way {
        double end;
        bool arrives;
    };
    [[nodiscard]] bool leads() const { return position_.leg < legs_.size() && legs_[position_.leg].leads; }
    /// Dead loads come on while the main load is none, not while a displacement is held.
    [[nodiscard]] Control control() const { return leads() ? Control::Load : control_; }
    /// The present leg is the first one of [load], and begins at the displacement that the boundary has then.
    [[nodiscard]] bool begins_where_boundary_stands() const {
        return control_ == Control::Displacement && position_.leg == (cases_.leads() ? 1U : 0U);
    }
    [[nodiscard]] double end_of_leg() const;
    [[nodiscard]] bool rises(std::size_t leg) const { return legs_[leg].to > legs_[leg].from; }
    [[nodiscard]] bool rises() const {
        return begins_where_boundary_stands() ? end_of_leg() > position_.leg_start : rises(position_.leg);
    }
    [[nodiscard]] bool turns_at_end() const;  // of the leg: a half cycle ends there
    /// Parts of the leg at the ends of its uncut increments; the first is its start.
    [[nodiscard]] const std::vector<double>& ways() const { return schedule_.ways(rises()); }
    [[nodiscard]] int increments() const { return static_cast<int>(ways().size()) - 1; }  // of the leg, uncut
    [[nodiscard]] double stop(int increment) const;  // target where an uncut increment of the leg ends; 0: its start
    [[nodiscard]] int stop_nearest_to_zero() const;
    [[nodiscard]] Way next_way() const;
    [[nodiscard]] double size_of_next(const Way& taken) const;
    [[nodiscard]] double fraction_of_next() const;
    [[nodiscard]] bool is_alike() const;  // the present leg, and the last one in its direction
    [[nodiscard]] Eigen::VectorXd cases_at(double way) const;
    [[nodiscard]] Eigen::VectorXd cases_at_stop(int increment) const { return cases_at_stop(position_.leg, increment); }
    [[nodiscard]] Eigen::VectorXd cases_at_stop(std::size_t leg, int increment) const;
    [[nodiscard]] Eigen::ArrayXd largest_cases() const;  // magnitudes, at the stops of the leg
    [[nodiscard]] TakenIncrement taken_by(const LoadStep& step) const;
    void remember(const TakenIncrement& last);

    Control control_;
    CaseHistories cases_;
    std::vector<Leg> legs_;
    IncrementSchedule schedule_;
    double scale_ = 1.0;
    LoadPosition position_;
    std::size_t remembered_;
    int max_cuts_ = 0;
};

}  // namespace stria::coarse
