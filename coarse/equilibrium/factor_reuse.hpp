// When the tangent that one iterate was factored with serves the next one, too.
#pragma once

#include <algorithm>
#include <cmath>

#include "coarse/equilibrium/equilibrium.hpp"

namespace stria::coarse {

/// Watches the zone's residuals in one search for equilibrium; all ways of solving it go by the same rule.
///
/// A correction with a tangent of its own leaves r1 = c r0^2 of a residual r0. One more with the same tangent leaves
/// 2 c r0 r1 = 2 r1^2 / r0 (the chord method; Ortega and Rheinboldt, Iterative Solution of Nonlinear Equations in
/// Several Variables, 1970, section 10.2). Where that is within the tolerance a factor would gain nothing.
/// Where several tangents of their own have not sufficed, it is not them that residuals fall by: the tangent of the
/// exact return is made symmetric (docs/equations.md, exact return). Then a factor serves to the end of a short way,
/// for as long as residuals fall fast.
class FactorReuse {
public:
    explicit FactorReuse(double tolerance) : tolerance_(tolerance) {}

    /// Each iterate in turn.
    void add(const Residual& state) {
        const double residual = std::max(state.interior, state.contact) / state.scale;
        if (!state.keeps_factor) ++factored_;
        const bool at_end = factored_ > enough && residual <= tolerance_ / std::pow(fast, 5);
        const double by_chord = state.keeps_factor ? 0.0 : std::sqrt(tolerance_ * residual / (2.0 * margin));
        const double by_rate = at_end ? fast * residual : 0.0;
        // A small residual that does not end the search hides a large correction, which wants a tangent of its own.
        const bool hides = state.keeps_factor && residual <= tolerance_;
        below_ = hides ? 0.0 : state.scale * std::max({tolerance_, by_chord, by_rate});
    }

    /// N/mm: the residual up to which the next iterate is to keep the factor.
    [[nodiscard]] double below() const { return below_; }

private:
    static constexpr double margin = 2.0;  // flow that begins or ends is no parabola
    static constexpr double fast = 0.3;  // an iterate costs a third of what it does with a factor (docs/performance.md)
    static constexpr int enough = 3;
    double tolerance_, below_ = 0.0;
    int factored_ = 0;
};

}  // namespace stria::coarse
