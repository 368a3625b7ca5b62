// What a part of a ring adds up to the domain integrals about a tip.
#pragma once

#include "common/members.hpp"

namespace stria {

/// J in N/mm; interactions per unit K (I and II) and per N/mm of force (T). K_I = E'/2 interaction_I, K_II likewise
/// (Williams fields); T = E' interaction_T (point force).
struct DomainIntegral {
    double J = 0.0, interaction_I = 0.0, interaction_II = 0.0, interaction_T = 0.0;

    // How the solution turns in the ring, and what the quadrature makes of turning alone.
    double area = 0.0, rotation = 0.0;                       // mm2: the integrals of 1 and of (u_y,x - u_x,y) / 2
    double turned_I = 0.0, turned_II = 0.0, turned_T = 0.0;  // interactions of the rotation by 1

    double wake_I = 0.0, wake_II = 0.0;  // of the interactions: what the pressure of faces in a wake adds

    /// Of the whole ring: the interactions of what is left of the solution without its mean rotation. A rotation has
    /// none, for the auxiliary stresses are in equilibrium; but not with the quadrature of their r^(-1/2), so K would
    /// tell how the body is held.
    [[nodiscard]] DomainIntegral without_rotation() const {
        DomainIntegral left = *this;
        const double mean = rotation / area;
        left.interaction_I -= mean * turned_I;
        left.interaction_II -= mean * turned_II;
        left.interaction_T -= mean * turned_T;
        left.rotation = 0.0;
        return left;
    }

    /// Of the solution times a factor: J is of second order in it, and what the place of the ring says stays.
    [[nodiscard]] DomainIntegral of_scaled(double factor) const {
        DomainIntegral scaled = *this;
        scaled.J *= factor * factor;
        for (double* part : {&scaled.interaction_I, &scaled.interaction_II, &scaled.interaction_T, &scaled.rotation,
                             &scaled.wake_I, &scaled.wake_II})
            *part *= factor;
        return scaled;
    }
};

STRIA_MEMBERS(DomainIntegral, J, interaction_I, interaction_II, interaction_T, area, rotation, turned_I, turned_II,
              turned_T, wake_I, wake_II)

inline DomainIntegral& operator+=(DomainIntegral& sum, const DomainIntegral& more) { return add_members(sum, more); }

}  // namespace stria
