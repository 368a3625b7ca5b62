// Opening and closing: the load factors between two states at which contact behind a tip is lost or made.
#pragma once

#include <functional>
#include <vector>

#include "coarse/newton.hpp"
#include "coarse/scene.hpp"

namespace stria::coarse {

/// Contact farther behind a tip than the measuring distance came or went within an increment.
struct ContactChange {
    int tip;
    bool closes;         // or opens
    double load_factor;  // to 0.2 % of the largest target
};

/// Contact nearer to the tip than a fixed distance does not count: it is as ambiguous as the tip's element (NUMERICS
/// 2).
class ClosureMeter {
public:
    ClosureMeter() = default;

    /// `largest_K_I`: of the load history, one a tip.
    ClosureMeter(const Case& input, const std::vector<double>& largest_K_I);

    /// Per tip, whether there is contact beyond the distance, from what Newton's last state says.
    [[nodiscard]] std::vector<char> closed(const NewtonReport& report) const;

    /// Tries targets between two states until it knows where each change lies; solve(target) finds the trial
    /// equilibrium at a target, starting from the state `from`, and the load factor there.
    struct Trial {
        NewtonReport report;
        double load_factor;
    };
    [[nodiscard]] std::vector<ContactChange> locate(const std::vector<char>& before, const std::vector<char>& after,
                                                    double from, double to,
                                                    const std::function<Trial(double)>& solve) const;

    [[nodiscard]] const std::vector<double>& distances() const { return distance_; }

private:
    std::vector<double> distance_;  // per tip, mm
    double precision_ = 0.0;        // of a target
};

}  // namespace stria::coarse
