// Unilateral contact with Coulomb's friction, per multiplier: p >= 0, g >= 0, p g = 0 and |tau| <= mu p, where slip
// goes on along the shear that reaches the bound (Simo and Laursen, eq. (4)).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace stria::fine {

/// Which branch of the law a multiplier is on. Faces without friction that touch are on Stick: nothing of theirs slides
/// against a traction.
enum class FaceStatus : std::int8_t { Open = 0, Stick = 1, SlipForward = 2, SlipBack = 3 };

inline bool is_closed(FaceStatus status) { return status != FaceStatus::Open; }
inline bool slides(FaceStatus status) { return status == FaceStatus::SlipForward || status == FaceStatus::SlipBack; }

/// What a multiplier transmits, MPa, and the weighted jumps beside it, mm. The shear is t . sigma n: it has the sign of
/// the slip that it brakes. `slip`: since the last commit.
struct FaceState {
    double pressure = 0.0, shear = 0.0, gap = 0.0, slip = 0.0;
};

/// The augmented Lagrangian of eq. (4) with its interface field w eliminated, solved as a semismooth Newton step
/// together with the bulk: p = max(0, p - c g), and tau is what tau + c slip leaves inside +-mu max(0, p - c g). c is
/// the paper's alpha, MPa/mm: it weighs tractions against jumps and changes no solution.
struct CoulombContact {
    /// Where faces have slid and have not moved since they are on the bound to the last bit but one: they stick.
    static constexpr double rounding = 1e-10;

    double friction = 0.0;
    double c = 1.0;

    /// Augmented pressure, MPa: closed where it is positive.
    [[nodiscard]] double augmented_pressure(const FaceState& s) const { return s.pressure - c * s.gap; }
    [[nodiscard]] double augmented_shear(const FaceState& s) const { return s.shear + c * s.slip; }

    /// What the shear may reach, MPa.
    [[nodiscard]] double bound(const FaceState& s) const { return friction * std::max(0.0, augmented_pressure(s)); }

    /// Faces that touch and bear nothing: whether they press or part has yet to show.
    [[nodiscard]] bool is_undecided(const FaceState& s) const { return s.pressure == 0.0 && s.gap == 0.0; }

    [[nodiscard]] FaceStatus status(const FaceState& s) const {
        if (augmented_pressure(s) <= 0.0) return FaceStatus::Open;
        if (friction == 0.0 || std::abs(augmented_shear(s)) <= (1.0 + rounding) * bound(s)) return FaceStatus::Stick;
        return augmented_shear(s) > 0.0 ? FaceStatus::SlipForward : FaceStatus::SlipBack;
    }

    /// p - max(0, p - c g), MPa: zero exactly where the three conditions of contact hold.
    [[nodiscard]] double pressure_residual(const FaceState& s) const {
        return s.pressure - std::max(0.0, augmented_pressure(s));
    }

    /// tau - clamp(tau + c slip), MPa: zero exactly where those of friction hold. None without friction.
    [[nodiscard]] double shear_residual(const FaceState& s) const {
        return friction == 0.0 ? 0.0 : s.shear - std::clamp(augmented_shear(s), -bound(s), bound(s));
    }

    /// The pressure at which slip begins, MPa, on the way from the tractions of a state to its jumps and to a pressure.
    /// Faces on the bound slide at once. Where the pressure falls, others come to the bound the later, the farther
    /// their shear is from the side that brakes the slip.
    [[nodiscard]] double slides_from(const FaceState& s, double pressure) const {
        const double fall = std::max(s.pressure - pressure, 0.0);
        if (s.pressure <= 0.0 || fall == 0.0) return std::max(s.pressure, 0.0);
        const double braking = s.slip < 0.0 ? -s.shear : s.shear;
        return s.pressure - 0.5 * (1.0 - std::clamp(braking / (friction * s.pressure), -1.0, 1.0)) * fall;
    }

    /// The integral of the pressure over the slip on that way, N/mm, where the faces slide at its end.
    [[nodiscard]] double pressure_times_slip(const FaceState& s, double pressure) const {
        const double reached = std::max(pressure, 0.0);
        return 0.5 * (slides_from(s, reached) + reached) * std::abs(s.slip);
    }

    /// The same where they part: they have touched over the share of the way at whose end p - c g, linear, is none.
    /// Where no gap is left this is what sliding to no pressure gives: which of both it is rounding says.
    [[nodiscard]] double pressure_times_slip_until_open(const FaceState& s) const {
        if (s.pressure <= 0.0) return 0.0;
        const double touching = s.pressure / (s.pressure + c * std::max(s.gap, 0.0));
        return touching * touching * pressure_times_slip(s, 0.0);
    }

    /// How far a state is beyond the branch that it is said to be on, MPa.
    [[nodiscard]] double violation(const FaceState& s, FaceStatus said) const {
        if (is_closed(said) != (augmented_pressure(s) > 0.0)) return std::abs(augmented_pressure(s));
        return std::abs(std::abs(augmented_shear(s)) - bound(s));
    }
};

/// Weighted jumps of a multiplier, or what they have grown by, mm.
struct FaceJumps {
    double gap = 0.0, slip = 0.0;
};

/// What faces `gap` apart slide until they meet, mm, if they go on as in their last two increments: along the parabola
/// through three states, or the chord of the last two where that comes to no gap of zero. 0: they open. What they
/// would not do within an increment like the last one is not in sight: if they meet, something else has turned them.
/// `next_over_last`: sizes of increments, where the last one has been halved.
[[nodiscard]] inline double slip_until_met(double gap, const FaceJumps& last, const FaceJumps& before,
                                           double next_over_last = 1.0) {
    if (gap <= 0.0) return 0.0;
    const FaceJumps more{last.gap - before.gap, last.slip - before.slip};
    const double speed = last.gap + 0.5 * more.gap, root = speed * speed - 2.0 * more.gap * gap;
    double share = 0.0, slip = 0.0;  // of an increment
    if (more.gap < 0.0 || (speed < 0.0 && root >= 0.0)) {
        share = 2.0 * gap / (std::sqrt(root) - speed);
        slip = share * (last.slip + 0.5 * (1.0 + share) * more.slip);
    } else if (last.gap < 0.0) {
        share = -gap / last.gap;
        slip = share * last.slip;
    }
    const double beyond = share / std::max(1.0, next_over_last);
    return slip / std::max(1.0, beyond * beyond * beyond);
}

/// mu with the sign of the shear that brakes.
inline double signed_friction(FaceStatus status, double friction) {
    return status == FaceStatus::SlipBack ? -friction : friction;
}

}  // namespace stria::fine
