// The integrands of J and of the interaction integrals at a point.
#pragma once

#include <numbers>

#include "common/crack/tip.hpp"
#include "common/fracture/auxiliary_fields.hpp"
#include "common/mandel.hpp"

namespace stria {

/// sigma_ij u_i,1 - W delta_1j with axis 1 along the tip: what the integrand of J dots with grad q.
inline Vec2 energy_momentum(const Tip& tip, const Mandel& stress, const Eigen::Matrix2d& gradient, double work) {
    return in_plane(stress) * (gradient * tip.direction) - work * tip.direction;
}

/// Its part that is mixed of the solution and an auxiliary field is linear in the solution. Dotted with grad q it is
/// xx sigma_xx + yy sigma_yy + xy sigma_xy + slope . u_,1.
struct MutualWeights {
    MutualWeights(const AuxiliaryField& field, const Vec2& along, const Vec2& dq)
        : slope(field.stress_xx * dq.x() + field.stress_xy * dq.y(),
                field.stress_xy * dq.x() + field.stress_yy * dq.y()) {
        const double ahead = along.dot(dq);
        xx = field.slope.x() * dq.x() - field.strain_xx * ahead;
        yy = field.slope.y() * dq.y() - field.strain_yy * ahead;
        xy = field.slope.y() * dq.x() + field.slope.x() * dq.y() - field.shear * ahead;
    }

    /// Of the stress, dotted with a strain in the plane.
    MutualWeights& operator+=(const Mandel& strain) {
        xx += strain[0];
        yy += strain[1];
        xy += std::numbers::sqrt2 * strain[3];
        return *this;
    }

    double xx, yy, xy;
    Vec2 slope;
};

/// The derivative along the tip of q times an auxiliary stress: xx, yy, 0, sqrt(2) xy. `ahead`: of q.
inline Mandel weighted_slope(const AuxiliaryField& field, const Mandel& stress_slope, double q, double ahead) {
    return q * stress_slope +
           ahead * Mandel(field.stress_xx, field.stress_yy, 0.0, std::numbers::sqrt2 * field.stress_xy);
}

/// What u_,1 is where the body turns by 1.
inline Vec2 turned(const Vec2& along) { return {-along.y(), along.x()}; }

/// (u_y,x - u_x,y) / 2.
inline double rotation(const Eigen::Matrix2d& gradient) { return 0.5 * (gradient(1, 0) - gradient(0, 1)); }

}  // namespace stria
