// Growth at a reached load: whether it goes on, how far each tip advances and where.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "coarse/analysis/cracked_body.hpp"
#include "coarse/cycle/increment.hpp"
#include "coarse/cycle/opening_swing.hpp"
#include "coarse/growth/growth_increment.hpp"
#include "coarse/growth/growth_texts.hpp"
#include "coarse/growth/tip_rates.hpp"

namespace stria::coarse {

class CrackGrowth {
public:
    /// Of a case whose cracks grow. `note` must outlive it.
    CrackGrowth(const Case& input, const Note& note, GrowthMemory memory = {});

    [[nodiscard]] GrowthMemory memory() const;

    /// Growth has ended the run.
    [[nodiscard]] bool ended() const { return ended_; }
    /// The body holds no longer crack, and a tip is driven: it is not the mesh alone that holds none. All growth has
    /// been counted.
    [[nodiscard]] bool life_is_over() const {
        return ended_ && !left_the_mesh_ && rates_.drive_a_tip() && rates_.uncounted_of_the_past() == 0.0;
    }
    [[nodiscard]] const TipRates& rates() const { return rates_; }

    /// What loading of the `present` cracks has `reached`: the largest K, and the extremes of the cycle. A release of
    /// new faces is none: the load of an overload may not come again.
    void take(const Increment& reached, const Scene& present);
    /// The cracks grow there, or a K as large as growth.toughness ends the run.
    [[nodiscard]] bool is_due_at(const LoadStep& step) const;

    /// The scene with each tip advanced by the law, from what it has gone through up to the end of the `last` cycle, in
    /// the direction that the last maximum gives; its mesh follows the tips. Null before the first cycle of a law of
    /// da/dN has ended, or the first period whose mean it takes, and where growth ends the run: no tip is driven, a
    /// limit of [growth] is reached, or a crack would leave the body or meet another one. Throws NumericalFailure where
    /// what drives the growth was not found in a cycle that tells its rate.
    [[nodiscard]] GrownScene next(const CrackedBody& body, const std::vector<CycleResult>& last);

    /// A cycle has ended: TipRates::count_cycles(), and OpeningSwing::add().
    void count_cycles(int cycle, std::vector<CycleResult>& cycles, const Scene& present) {
        increment_.add(cycles);
        rates_.count_cycles(cycle, cycles, present);
        for (const std::string& warning : swing_.add(cycle, cycles, present)) note_("warning: " + warning);
    }

private:
    void require_drive(const std::vector<CycleResult>& last) const;
    /// A tip whose K has reached growth.toughness since it grew, or -1.
    [[nodiscard]] int broken_tip() const;
    [[nodiscard]] bool is_over(const std::vector<TipResult>& nominal, const std::vector<CycleResult>& last) const;
    using Cracks = std::vector<CrackSection>;

    [[nodiscard]] std::vector<LengthAndK> reached(const std::vector<CycleResult>& last) const;
    /// mm. `turn`: the largest of the tips, radians; `elements`: edges of theirs, mm.
    [[nodiscard]] double increment_of_fastest(const std::vector<CycleResult>& last, const Scene& present, double turn,
                                              const std::vector<double>& elements);
    /// Longer cracks: as their tips turn, and straight on where that is nearly the same.
    [[nodiscard]] std::vector<Cracks> ways(const Scene& present, const std::vector<TipResult>& guides,
                                           const std::vector<CycleResult>& last);
    void warn_of_sharp_turns(const std::vector<Tip>& tips, const Cracks& longer,
                             const std::vector<double>& elements) const;
    [[nodiscard]] TipSteps steps_about(std::size_t fastest, const Scene& present, double turn,
                                       const std::vector<double>& elements) const;
    /// Of a cycle that ends at its maximum.
    void note_cycle(const std::vector<ModesOfTip>& maximum);
    /// The law takes K_I, and K_II turns a tip: one that K_I drives less, or not at all, is driven by what it has once
    /// it has turned. Starts those of which that is known, and returns their numbers.
    std::set<std::size_t> start_by_turns(const CrackedBody& body, const std::vector<TipResult>& guides,
                                         const std::vector<CycleResult>& last);
    /// That the rates of tips that turn sharply leap, but for those that a turn has `started`.
    void note_turns(const CrackedBody& body, const Scene& longer, const std::vector<CycleResult>& last,
                    const std::set<std::size_t>& started);
    /// Where functions come to stand at the tips, or stand there no longer; and of each tip once where its functions
    /// are not retained as they are to be.
    void note_functions(const EnrichedMesh& before, const Scene& longer);
    [[nodiscard]] GrownScene along_first_of(const CrackedBody& body, const std::vector<Cracks>& ways);
    [[nodiscard]] GrownScene with_cracks(const CrackedBody& body, const Cracks& cracks) const;

    GrowthSection growth_;
    const Note& note_;
    bool ended_;
    bool left_the_mesh_ = false;
    bool turns_late_;  // along an element edge, at the growth before: that has been said
    GrowthIncrement increment_;
    TipRates rates_;
    std::vector<ReachedK> K_reached_;  // one per tip
    std::vector<LengthAndK> before_;   // what the tips had reached when they grew last; empty: they have not grown
    ReachedExtremes extremes_;
    TurningModes turning_;
    OpeningSwing swing_;
    std::optional<TurnOfTip> untold_turn_;  // what drives that tip behind it is not known
    std::set<int> said_to_freeze_;          // tips: no checkpoint, for a run that retains functions cannot be resumed
};

}  // namespace stria::coarse
