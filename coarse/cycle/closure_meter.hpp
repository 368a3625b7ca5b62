// Opening and closing: the load factors between two states at which contact behind a tip is lost or made, or at which
// the metal ahead of it goes from compression to tension or back.
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
    bool closes;         // or opens
    double load_factor;  // to the precision asked for; NaN where no trial between two states came to equilibrium
};

/// Reads signals of closure and finds where they change. Contact nearer to the tip than a fixed distance does not
/// count: it is as ambiguous as the tip's element (docs/method.md, section 9).
class ClosureMeter {
public:
    ClosureMeter() = default;

    /// `largest_K_I`: of the load history, MPa sqrt(mm), one per tip. The yield stress gives the default distance.
    ClosureMeter(const ClosureSection& closure, const MaterialSection& material,
                 const std::vector<double>& largest_K_I);

    /// Signals per tip: contact beyond each of distances(tip), the default one first; then compression ahead of the tip
    /// where it is measured.
    [[nodiscard]] int signals() const { return contact_signals() + (tension_ ? 1 : 0); }
    [[nodiscard]] int contact_signals() const { return distance_.empty() ? 0 : static_cast<int>(distance_[0].size()); }
    /// Behind the tip, mm.
    [[nodiscard]] const std::vector<double>& distances(int tip) const { return distance_[at(tip)]; }
    /// The distance behind each tip at which the opening is read, mm: the first of distances(tip).
    [[nodiscard]] std::vector<double> behind() const;
    /// Distances ahead of the tips over which the stress is averaged, mm: the first of distances(tip), no less than an
    /// element. One per tip; empty where compression is not measured.
    [[nodiscard]] std::vector<double> ahead(const EnrichedMesh& mesh) const;

    /// 1 where a signal is closed in Newton's last state: all signals of the first tip, then of the next.
    [[nodiscard]] std::vector<char> closed(const NewtonReport& report) const;

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
    bool tension_ = false;
};

}  // namespace stria::coarse
