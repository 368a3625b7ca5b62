// Opening, closing and sliding: the load factors between two states at which contact behind a tip is lost, made or made
// to slide, or at which the metal ahead of it goes from compression to tension or back.
#pragma once

#include <functional>
#include <vector>

#include "coarse/equilibrium/newton.hpp"
#include "common/case/case.hpp"
#include "common/enrichment/enriched_mesh.hpp"
#include "common/index.hpp"

namespace stria::coarse {

/// A signal of closure came or went within an increment.
struct OpeningChange {
    int tip;
    int signal;          // ClosureMeter::signals()
    bool closes;         // or opens; of slip: begins to slide
    double load_factor;  // to the precision asked for; NaN where no trial between two states came to equilibrium
};

/// Reads signals of closure and finds where they change. Contact nearer to the tip than a fixed distance does not
/// count: it is as ambiguous as the tip's element (docs/method.md, section 9).
class ClosureMeter {
public:
    ClosureMeter() = default;

    /// `largest_K_I`: of the load history, MPa sqrt(mm), one per tip. The yield stress gives the default distance.
    /// Sliding is measured where there is friction and a profile is asked for.
    ClosureMeter(const ClosureSection& closure, const MaterialSection& material,
                 const std::vector<CrackSection>& cracks, const std::vector<double>& largest_K_I);

    /// Signals per tip, in this order: contact beyond each of distances(tip), the default one first; compression ahead
    /// of the tip where it is measured; and where sliding is, whether at each distance faces have slid since the load
    /// began to rise.
    struct Signals {
        std::size_t contact = 0, tension = 0, slip = 0;
        [[nodiscard]] std::size_t first_slip() const { return contact + tension; }
        [[nodiscard]] std::size_t all() const { return first_slip() + slip; }
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

    /// 1 where a signal is closed in Newton's last state: all signals of the first tip, then of the next. `before`: in
    /// the state that it comes from, or empty. What has slid while the load rises counts as sliding until it falls.
    [[nodiscard]] std::vector<char> closed(const NewtonReport& report, const std::vector<char>& before,
                                           bool rises) const;
    /// As a half cycle begins: nothing has slid in it.
    void forget_slip(std::vector<char>& closed) const;

    /// A trial equilibrium, and the load factor there.
    struct Trial {
        NewtonReport report;
        double load_factor;
    };
    /// Finds the trial equilibrium at a target, starting from the state `from`.
    using Solve = std::function<Trial(double)>;

    /// Tries targets between two states until each change lies between two that are no more than `precision` apart. A
    /// trial that fails is made again elsewhere between them.
    [[nodiscard]] std::vector<OpeningChange> locate(const std::vector<char>& before, const std::vector<char>& after,
                                                    double from, double to, double precision, const Solve& solve) const;

private:
    struct End {
        double target;
        std::vector<char> closed;
    };
    void bisect(const End& before, const End& after, double load_factor, double precision, const Solve& solve,
                std::vector<OpeningChange>& changes) const;

    std::vector<std::vector<double>> distance_;  // per tip, mm
    bool tension_ = false, slip_ = false;
};

}  // namespace stria::coarse
