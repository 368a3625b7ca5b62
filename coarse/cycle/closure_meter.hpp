// Opening, closing and sliding: the load factors between two states at which contact behind a tip is lost, made or made
// to slide, or at which the metal ahead of it goes from compression to tension or back.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "coarse/cycle/signal_crossing.hpp"
#include "coarse/equilibrium/newton.hpp"
#include "common/case/case.hpp"
#include "common/enrichment/enriched_mesh.hpp"
#include "common/index.hpp"

namespace stria::coarse {

/// A signal of closure came or went within an increment.
struct OpeningChange {
    int tip;
    int signal;           // ClosureMeter::signals()
    bool closes;          // or opens; of slip: begins to slide
    double load_factor;   // to the precision asked for; NaN where no trial between two states came to equilibrium
    double way = 1.0;     // of the increment
    double target = 0.0;  // where
    // What the signal changes by per target beside it, where it is open and where it is closed; NaN: not seen.
    std::array<double, 2> rate{NAN, NAN};
};

/// Reads signals of closure and finds where they change. Contact nearer to the tip than a fixed distance does not
/// count: it is as ambiguous as the tip's element (docs/method.md, section 9).
class ClosureMeter {
public:
    ClosureMeter() = default;

    /// `K`: K_of_closure (K_behind_turns.hpp), MPa sqrt(mm), one per tip. It gives the default distance, with the yield
    /// stress there, MPa, one per tip. Sliding is measured where there is friction and a profile is asked for.
    ClosureMeter(const ClosureSection& closure, const std::vector<double>& yield_stress,
                 const std::vector<CrackSection>& cracks, const std::vector<double>& K);

    /// Signals per tip, in this order: contact beyond each of distances(tip), the default one first; compression ahead
    /// of the tip where it is measured; and where sliding is, whether at each distance faces have slid in this half
    /// cycle.
    struct Signals {
        std::size_t contact = 0, tension = 0, slip = 0;
        [[nodiscard]] std::size_t first_slip() const { return contact + tension; }
        [[nodiscard]] std::size_t all() const { return first_slip() + slip; }
        [[nodiscard]] bool is_slip(std::size_t kind) const { return kind >= first_slip(); }
        /// Where a vector of the signals of all tips holds one, and which one it holds there.
        [[nodiscard]] std::size_t index(int tip, int kind) const { return at(tip) * all() + at(kind); }
        [[nodiscard]] std::size_t tip_of(std::size_t index) const { return index / all(); }
        [[nodiscard]] std::size_t kind_of(std::size_t index) const { return index % all(); }
    };
    [[nodiscard]] Signals signals() const;
    /// "opens", "closes" or "slides".
    [[nodiscard]] const char* what_a_tip_does(const OpeningChange& change) const;
    /// Behind the tip, mm.
    [[nodiscard]] const std::vector<double>& distances(int tip) const { return distance_[at(tip)]; }
    /// The distance behind each tip at which the opening is read, mm: the first of distances(tip).
    [[nodiscard]] std::vector<double> opening_at() const;
    /// Distances ahead of the tips over which the stress is averaged, mm: the first of distances(tip), no less than an
    /// element. One per tip; empty where compression is not measured.
    [[nodiscard]] std::vector<double> ahead(const EnrichedMesh& mesh) const;
    /// Distances behind the tips at which faces may slide: distances(tip), or nothing where it is not measured.
    [[nodiscard]] std::vector<std::vector<double>> slip_at() const;

    /// Behind each tip, at and beyond which contact is a signal, mm.
    [[nodiscard]] const std::vector<std::vector<double>>& contact_at() const { return distance_; }

    /// The signals of Newton's last state, all of the first tip, then of the next: above zero where one is closed. Of
    /// contact coupling::Digest::contact; of the metal ahead minus the normal force; of slip 1 or -1. `before`: in the
    /// state that it comes from, or empty. What has slid counts as sliding until the load turns. `largest`: the largest
    /// magnitudes so far, or empty. Faces that neither press nor gape but for rounding, and metal without load, say
    /// what they said before: where the load goes to nothing elastic faces lose no contact and make none.
    [[nodiscard]] std::vector<double> signal(const NewtonReport& report, const std::vector<double>& before,
                                             const std::vector<double>& largest = {}) const;
    /// Where sliding is measured the contact nearest to each tip, per distance, in Newton's last state.
    [[nodiscard]] std::vector<coupling::NearestContact> nearest(const NewtonReport& report) const;
    /// A tip that has not slid may have on the way between two states.
    [[nodiscard]] bool may_hide_slip(const ClosureStation& before, const ClosureStation& after) const;
    /// As a half cycle begins: nothing has slid in it.
    void forget_slip(std::vector<double>& signal) const;

    /// A trial equilibrium, and the load factor there.
    struct Trial {
        NewtonReport report;
        double load_factor;
    };
    /// Finds the trial equilibrium at a target.
    using Solve = std::function<Trial(double)>;

    /// How targets between two states are tried.
    struct Trials {
        double precision;                             // to which a target is looked for
        Solve solve;                                  // finds the trial equilibrium at one
        std::vector<ExpectedCrossing> expected = {};  // one per signal; empty: nobody knows
        std::vector<double> largest = {};             // as signal() has it
    };
    /// Tries targets between two states until it knows where each signal passes zero. It tries first where the signal
    /// is expected to, then where signals that it has seen on one side lead to, since they bend where contact is made
    /// or lost; in proportion to both where they lead nowhere; in the middle where they only say whether. A trial that
    /// fails is made again elsewhere.
    [[nodiscard]] std::vector<OpeningChange> locate(ClosureStation before, ClosureStation after,
                                                    const Trials& trials) const;

private:
    class Search;

    /// Null where no trial comes to equilibrium. `share`: of the way, tried first.
    [[nodiscard]] std::optional<ClosureStation> try_between(const ClosureStation& before, const ClosureStation& after,
                                                            double share, const Trials& trials) const;

    /// Faces that slide and part within one increment are seen to slide at neither end of it: where slip is measured a
    /// load at which contact comes or goes is known once a state beside it is, to `precision`, with the faces closed.
    [[nodiscard]] Crossing seen_closed(const Crossing& found, const ClosureStation& before, const ClosureStation& after,
                                       std::size_t k, double precision) const;

    /// Signals of slip that neither of two states has.
    [[nodiscard]] std::vector<std::size_t> unslid(const ClosureStation& before, const ClosureStation& after) const;
    /// Of a signal of slip the place in nearest().
    [[nodiscard]] std::size_t contact_of(std::size_t signal) const;

    void remember_slip(const std::vector<double>& before, std::vector<double>& signal) const;

    std::vector<std::vector<double>> distance_;  // per tip, mm
    bool tension_ = false, slip_ = false;
};

}  // namespace stria::coarse
