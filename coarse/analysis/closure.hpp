// Opening and closing: the load factors between two states at which contact behind a tip is lost or made, or at which
// the metal ahead of it goes from compression to tension or back.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "coarse/equilibrium/newton.hpp"
#include "coarse/model/scene.hpp"
#include "common/index.hpp"

namespace stria::coarse {

/// A signal of closure came or went within an increment.
struct OpeningChange {
    int tip;
    int signal;          // ClosureMeter::signals()
    bool closes;         // or opens
    double load_factor;  // to the precision asked for
};

/// Contact nearer to the tip than a fixed distance does not count: it is as ambiguous as the tip's element
/// (docs/method.md, section 9).
class ClosureMeter {
public:
    ClosureMeter() = default;

    /// `largest_K_I`: of the load history, one a tip.
    ClosureMeter(const Case& input, const std::vector<double>& largest_K_I);

    /// Signals of a tip: contact beyond each of distances(tip), the default one first; then, if it is measured,
    /// compression ahead of the tip.
    [[nodiscard]] int signals() const { return contact_signals() + (tension_ ? 1 : 0); }
    [[nodiscard]] int contact_signals() const { return distance_.empty() ? 0 : static_cast<int>(distance_[0].size()); }
    [[nodiscard]] const std::vector<double>& distances(int tip) const { return distance_[at(tip)]; }
    /// Per tip: over what distance ahead of it stress is to be averaged, mm: the first one, no less than an element;
    /// empty where it is not measured.
    [[nodiscard]] std::vector<double> ahead(const EnrichedMesh& mesh) const;

    /// Per tip and signal, whether it is closed, from what Newton's last state says.
    [[nodiscard]] std::vector<char> closed(const NewtonReport& report) const;

    /// Tries targets between two states until each change lies between two no more than `precision` apart;
    /// solve(target) finds the trial equilibrium at a target, starting from the state `from`, and the load factor
    /// there.
    struct Trial {
        NewtonReport report;
        double load_factor;
    };
    using Solve = std::function<Trial(double)>;
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

/// Where the compliance dv/dP at the mouth, on the way up from the minimum, last is less than 1 - `offset` times that
/// of the open crack: of the upper quarter of the way down (ASTM E647, appendix on opening force). Loads and openings
/// at the increments from the maximum to the minimum and from there to the maximum. NaN where it is nowhere, or where
/// the mouth does not open.
double compliance_offset_opening(std::span<const double> load_down, std::span<const double> opening_down,
                                 std::span<const double> load_up, std::span<const double> opening_up,
                                 double offset = 0.02);

}  // namespace stria::coarse
