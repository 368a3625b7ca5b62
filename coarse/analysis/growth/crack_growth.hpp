// Growth at a reached load: whether it goes on, how far each tip advances and where.
#pragma once

#include <memory>
#include <vector>

#include "coarse/analysis/cracked_body.hpp"
#include "coarse/analysis/growth/growth_increment.hpp"
#include "coarse/analysis/growth/life_count.hpp"
#include "coarse/analysis/growth/period_rates.hpp"
#include "coarse/cycle/increment.hpp"
#include "coarse/load/load_controller.hpp"

namespace stria::coarse {

/// What a growth of the cracks makes of a scene.
struct GrownScene {
    std::unique_ptr<Scene> longer;      // null: growth ends the run
    std::unique_ptr<FinerScene> finer;  // the present cracks on the mesh of `longer`; null: it is the present mesh
};

class CrackGrowth {
public:
    /// Of a case whose cracks grow. `note` must outlive it. `from`: null at the start of a run.
    CrackGrowth(const Case& input, const Note& note, const AnalysisState* from);

    /// Its part of what a run remembers.
    void write(AnalysisState& state) const;

    /// Growth has ended the run.
    [[nodiscard]] bool ended() const { return ended_; }
    /// And a tip is driven, in a body that holds no longer crack: not on a mesh alone that holds none. All growth has
    /// been counted.
    [[nodiscard]] bool life_is_over() const {
        return ended_ && !left_the_mesh_ && is_driven() && life_.memory().uncounted == 0.0;
    }

    /// Growth of the fastest tip of which no cycle has told yet how many it took, mm.
    [[nodiscard]] double uncounted() const;
    /// Cycles that the life may be off by, since the rate changes from one growth to the next.
    [[nodiscard]] double life_in_doubt() const { return life_.memory().doubt; }

    /// A tip grows by the law, from what the tips have gone through.
    [[nodiscard]] bool is_driven() const;

    /// Takes what K loading has `reached`. True where the cracks grow there, or a K as large as growth.toughness ends
    /// the run.
    [[nodiscard]] bool is_due(const Increment& reached);

    /// The scene with each tip advanced by the law, from what it has gone through up to the end of the `last` cycle, in
    /// the direction that the last maximum gives; its mesh follows the tips. Null before the first cycle of a law of
    /// da/dN has ended, or the first period whose mean it takes, and where growth ends the run: no tip is driven, a
    /// limit of [growth] is reached, or a crack would leave the body or meet another one. Throws NumericalFailure where
    /// what drives the growth was not found in a cycle that tells its rate.
    [[nodiscard]] GrownScene next(const CrackedBody& body, const std::vector<CycleResult>& last);

    /// Takes the rates of a cycle that has ended, and puts into `cycles`, one per tip, how many it stands for: what the
    /// growth took that is known to its end. `present`: with the tips as long as at its end.
    void count_cycles(int cycle, std::vector<CycleResult>& cycles, const Scene& present);

private:
    void require_drive(const std::vector<double>& rates, const std::vector<CycleResult>& last) const;
    /// A tip whose K has reached growth.toughness since it grew, or -1.
    [[nodiscard]] int broken_tip() const;
    [[nodiscard]] bool is_over(const std::vector<TipResult>& nominal, const std::vector<CycleResult>& last) const;
    /// That the growth at the beginning of the period took that `cycle` ends. `ends`: growth ends the run.
    [[nodiscard]] double cycles_of_period(const Scene& present, int cycle, bool ends);
    using Cracks = std::vector<CrackSection>;

    /// Of the fastest tip, mm. `turn`: the largest of the tips, radians; `elements`: edges of theirs, mm.
    [[nodiscard]] double increment(const std::vector<CycleResult>& last, const Scene& present, double turn,
                                   const std::vector<double>& elements);
    /// Longer cracks: as their tips turn, and straight on where that is nearly the same.
    [[nodiscard]] std::vector<Cracks> ways(const Scene& present, const std::vector<TipResult>& guides,
                                           const std::vector<CycleResult>& last);
    void warn_of_sharp_turns(const std::vector<Tip>& tips, const Cracks& longer,
                             const std::vector<double>& elements) const;
    /// By which `a` of each tip grows, mm per cycle: half of a crack with two tips by the mean of theirs.
    [[nodiscard]] std::vector<double> lengthening(const std::vector<Tip>& tips) const;
    [[nodiscard]] TipSteps steps_about(std::size_t fastest, const Scene& present, double turn,
                                       const std::vector<double>& elements) const;
    /// Where a tip turns sharply its rate leaps.
    void note_turns(const CrackedBody& body, const Scene& longer, const std::vector<TipResult>& guides,
                    const std::vector<CycleResult>& last);
    /// da/dN of the tips, mm per cycle. K of a tip that has just turned is not resolved and far too low: until it is,
    /// the rate with which the tip left the turn stands for a lower one, or a tip would never leave it.
    [[nodiscard]] std::vector<double> tip_rates() const;
    /// Where a tip stands, at the end of a cycle.
    [[nodiscard]] static GrownTip grown_tip(const Scene& present, std::size_t t);
    /// Where functions come to stand at the tips, or stand there no longer.
    void note_functions(const EnrichedMesh& before, const EnrichedMesh& longer) const;
    [[nodiscard]] GrownScene along_first_of(const CrackedBody& body, const std::vector<Cracks>& ways);
    [[nodiscard]] GrownScene with_cracks(const CrackedBody& body, const Cracks& cracks) const;

    GrowthSection growth_;
    bool varies_, takes_mean_;
    int cut_off_;  // the last cycle, where it does not rise as the sequence would; 0: it does
    const Note& note_;
    bool ended_;
    bool left_the_mesh_ = false;
    GrowthIncrement increment_;
    PeriodRates rates_;
    LifeCount life_;
    std::vector<double> rate_at_turn_;  // just behind the last sharp turn of each tip, mm per cycle; NaN: K is resolved
    std::vector<double> K_reached_;     // largest nominal K since the tips have grown, one per tip, MPa sqrt(mm)
    ReachedExtremes extremes_;
};

}  // namespace stria::coarse
