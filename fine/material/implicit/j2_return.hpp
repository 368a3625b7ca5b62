// One step of backward Euler of J2 plasticity at the points of a pack: the plastic strain increment dp whose relative
// stress lies on the yield surface, with any isotropic hardening and any back stresses.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "common/error.hpp"
#include "fine/material/implicit/plane_deviators.hpp"
#include "fine/material/implicit/return_law.hpp"
#include "fine/material/j2_pack.hpp"

namespace stria::fine {

/// Deviatoric stress less Prager's back stresses, the other back stresses and p of a pack; or what they change by.
template <int rows> struct PackState {
    Deviators<rows> stress;
    std::vector<Deviators<rows>> back;
    Scalars<rows> p;

    void set_zero(std::size_t back_stresses) {
        stress.setZero();
        back.assign(back_stresses, Deviators<rows>::Zero());
        p.setZero();
    }

    /// Of the points at a place of `field`, components as of the law's state.
    void put(const ReturnLaw& law, PackPlace<rows> at, const double* field) {
        const auto deviator = [&](int first) { return deviators_of<rows>(at.tensors(field, first)); };
        stress = deviator(state::stress);
        for (const int first : law.linear) stress -= deviator(first);
        back.resize(law.back_stresses.size());
        std::ranges::transform(law.back_stresses, back.begin(), deviator);
        p = at.scalars(field, state::accumulated);
    }
};

/// A back stress after recall, X = theta X*, where X* = X_n + 2/3 C(p) d(eps_p) is what it would be without. Armstrong
/// and Frederick: theta = 1 / (1 + gamma dp). With a threshold: the nearest point of the ball of radius r = C / gamma,
/// so theta = min(1, r / X*), and dX = theta (1 - n x n) dX* where it has reached the limit along n. N. Ohno, J.-D.
/// Wang, Int. J. Plasticity 9 (1993) 375; M. Kobayashi, N. Ohno, IJNME 53 (2002) 2217.
template <int rows> struct Recalled {
    Deviators<rows> X;
    Scalars<rows> theta;
    Scalars<rows> stiffness;  // 2/3 C(p), MPa
    Scalars<rows> growth;     // C'(p) / C(p)
    Scalars<rows> fading;     // by dp, over X: what recall takes
    Deviators<rows> drift;    // by p, MPa: as C grows
    Deviators<rows> limited;  // n, or zero
    bool has_limit;           // else `limited` is not set

    /// dX of dX*, at constant p.
    [[nodiscard]] Deviators<rows> following(const Deviators<rows>& d) const {
        if (!has_limit) return d * theta;
        return (d - limited * dot<rows>(limited, d)) * theta;
    }

    /// dX / d(dp) at a constant plastic strain increment.
    [[nodiscard]] Deviators<rows> by_dp() const { return drift - X * fading; }

    /// What depends on p alone.
    void put_p(const KinematicHardening& term, const Scalars<rows>& p, const Scalars<rows>& dp) {
        const double gamma = term.threshold ? 0.0 : term.gamma;
        stiffness = 2.0 / 3.0 * modulus<Scalars<rows>>(term, p);
        growth = growth_of_modulus<Scalars<rows>>(term, p);
        theta = 1.0 / (1.0 + gamma * dp);
        fading = gamma * theta;
        drift.setZero();
        has_limit = term.threshold;
    }

    void put_X(const KinematicHardening& term, const Deviators<rows>& X_n, const Deviators<rows>& plastic) {
        X = X_n + plastic * stiffness;
        if (term.threshold) limit(term.C / term.gamma);
        if (term.C_start) drift = plastic * (stiffness * growth * theta);
        X = X * theta;
    }

private:
    void limit(double radius) {
        const Scalars<rows> size = equivalent<rows>(X);
        const Mask<rows> beyond = size > radius * (1.0 + 1e-12);  // above rounding: what rests does not move
        const Scalars<rows> per_size = 1.0 / beyond.select(size, 1.0);
        theta = beyond.select(radius * per_size, 1.0);
        limited = X * beyond.select(std::sqrt(1.5) * per_size, 0.0);
    }
};

/// The return of one part of an increment at a plastic strain increment dp. With the flow d(eps_p) = lambda xi, lambda
/// = 3/2 dp / Y, Y = sigma_y + R(p + dp), the relative stress xi = dev(sigma) - sum X solves
///     xi + lambda rate xi + sum X(lambda xi, dp) = dev(trial).
template <int rows> struct ReturnAt {
    Scalars<rows> Y, Y_slope;            // MPa; by dp
    Scalars<rows> lambda, lambda_slope;  // 1/MPa
    std::vector<Recalled<rows>> back;
    DeviatorOperator<rows> rate;  // MPa: of the law and what back stresses follow by, by d(eps_p)
    EasedBy<rows> eased;          // by 1 + lambda rate
    Deviators<rows> xi, xi_slope;
    Scalars<rows> equivalent, equivalent_slope;  // sqrt(3/2) |xi|
};

/// Without thresholds xi solves a linear equation. With them it minimises a convex function of one kink for each:
/// Newton's method takes 2 to 4 steps, and after so many the one metric that bounds its curvature leads there surely.
inline constexpr int newton_steps = 20, most_steps = 2000;

/// 1 - Y / q and its derivative by dp. Nearly straight: Y / q is linear in dp without recall and with linear hardening,
/// in plane strain.
template <int rows> struct Residual {
    Scalars<rows> value, slope;

    Residual(const Scalars<rows>& Y, const Scalars<rows>& Y_slope, const Scalars<rows>& per_q,
             const Scalars<rows>& Y_times_q_slope)
        : value(1.0 - Y * per_q), slope((Y_times_q_slope * per_q - Y_slope) * per_q) {}
};

template <int rows> class PartReturn {
public:
    /// The arguments must outlive the return.
    PartReturn(const J2Parameters& parameters, const ReturnLaw& law, const PackState<rows>& before,
               const Deviators<rows>& trial)
        : parameters_(parameters), law_(law), before_(before), trial_(trial), trial_zz_(trial.col(0).square()),
          trial_shear_(trial.col(1).square() + trial.col(2).square()) {}

    /// dp of the points that flow, 0 of the others, and the return at it: the root of 1 - Y / q, nearly a straight
    /// line, between bounds.
    [[nodiscard]] Scalars<rows> find(ReturnAt<rows>& now) const;

private:
    [[nodiscard]] Residual<rows> residual_at(const Scalars<rows>& dp, ReturnAt<rows>& now) const;
    [[nodiscard]] Residual<rows> residual_of_trial(const Scalars<rows>& dp) const;
    void put(const Scalars<rows>& dp, ReturnAt<rows>& now) const;
    void put_at_Y(const Scalars<rows>& dp, ReturnAt<rows>& now) const;
    void put_relative_stress(ReturnAt<rows>& now) const;
    void solve_relative_stress(ReturnAt<rows>& now) const;
    void put_back_stresses(ReturnAt<rows>& now) const;
    [[nodiscard]] Deviators<rows> next_relative_stress(ReturnAt<rows>& now, bool surely) const;

    /// More than any dp: with it the return would bring all stress below Y if nothing were recalled.
    [[nodiscard]] Scalars<rows> most() const {
        Scalars<rows> sum = equivalent<rows>(trial_);
        for (const Deviators<rows>& back : before_.back) sum += equivalent<rows>(back);
        return sum / (1.5 * law_.rates.minCoeff());
    }

    const J2Parameters& parameters_;
    const ReturnLaw& law_;
    const PackState<rows>& before_;
    const Deviators<rows>& trial_;
    Scalars<rows> trial_zz_, trial_shear_;  // the two parts of its square that ease each in its way, MPa2
};

template <int rows> void PartReturn<rows>::put_back_stresses(ReturnAt<rows>& now) const {
    const Deviators<rows> plastic = now.xi * now.lambda;
    for (std::size_t k = 0; k < law_.recalling.size(); ++k)
        now.back[k].put_X(law_.recalling[k], before_.back[k], plastic);
}

/// One step from now.xi, with the derivative there or, `surely`, with one that is nowhere too small.
template <int rows> Deviators<rows> PartReturn<rows>::next_relative_stress(ReturnAt<rows>& now, bool surely) const {
    now.rate = DeviatorOperator<rows>(law_.rates);
    Deviators<rows> rest = trial_;
    for (std::size_t k = 0; k < law_.recalling.size(); ++k) {
        const Recalled<rows>& back = now.back[k];
        const bool bound = surely && back.has_limit;
        if (bound)
            now.rate.add(back.stiffness);
        else
            now.rate.add_across(back.stiffness * back.theta, back.limited);
        const Deviators<rows> slope = bound ? now.xi : back.following(now.xi);
        rest -= back.X - slope * (back.stiffness * now.lambda);
    }
    now.eased = EasedBy<rows>(now.lambda, now.rate);
    return now.eased(rest);
}

/// Without thresholds: what is left of back stresses stands beside the trial stress.
template <int rows> void PartReturn<rows>::solve_relative_stress(ReturnAt<rows>& now) const {
    now.rate = DeviatorOperator<rows>(law_.rates);
    Deviators<rows> rest = trial_;
    for (std::size_t k = 0; k < law_.recalling.size(); ++k) {
        now.rate.add(now.back[k].stiffness * now.back[k].theta);
        rest -= before_.back[k] * now.back[k].theta;
    }
    now.eased = EasedBy<rows>(now.lambda, now.rate);
    now.xi = now.eased(rest);
    put_back_stresses(now);
}

template <int rows> void PartReturn<rows>::put_relative_stress(ReturnAt<rows>& now) const {
    if (!law_.has_thresholds) return solve_relative_stress(now);
    Mask<rows> searching = Mask<rows>::Constant(true);
    for (int step = 0; searching.any(); ++step) {
        if (step == most_steps) throw NumericalFailure("return mapping: no back stresses found");
        put_back_stresses(now);
        const bool surely = step >= newton_steps && step < most_steps - newton_steps;  // near the end Newton's are sure
        const Deviators<rows> change = next_relative_stress(now, surely) - now.xi;
        now.xi += change * searching.template cast<double>();
        // NaN goes on, to the failure.
        searching = searching && !(equivalent<rows>(change) <= 1e-12 * (equivalent<rows>(now.xi) + now.Y));
    }
    put_back_stresses(now);
    static_cast<void>(next_relative_stress(now, false));  // the derivative there
}

template <int rows> void PartReturn<rows>::put(const Scalars<rows>& dp, ReturnAt<rows>& now) const {
    const HardeningAt<Scalars<rows>> hardening = parameters_.isotropic.at(Scalars<rows>(before_.p + dp));
    now.Y = parameters_.yield_stress + hardening.value;
    now.Y_slope = hardening.slope;
    put_at_Y(dp, now);
}

template <int rows> void PartReturn<rows>::put_at_Y(const Scalars<rows>& dp, ReturnAt<rows>& now) const {
    const Scalars<rows> p = before_.p + dp;
    now.lambda = 1.5 * dp / now.Y;
    now.lambda_slope = (1.5 - now.lambda * now.Y_slope) / now.Y;
    for (std::size_t k = 0; k < now.back.size(); ++k) now.back[k].put_p(law_.recalling[k], p, dp);
    put_relative_stress(now);
    Deviators<rows> less = (now.rate * now.xi) * now.lambda_slope;
    for (const Recalled<rows>& back : now.back) less += back.by_dp();
    now.xi_slope = -now.eased(less);
    now.equivalent = equivalent<rows>(now.xi).max(std::numeric_limits<double>::min());
    now.equivalent_slope = 1.5 * dot<rows>(now.xi, now.xi_slope) / now.equivalent;
}

template <int rows> Residual<rows> PartReturn<rows>::residual_at(const Scalars<rows>& dp, ReturnAt<rows>& now) const {
    if (law_.recalling.empty()) return residual_of_trial(dp);
    put(dp, now);
    return {now.Y, now.Y_slope, 1.0 / now.equivalent, now.Y * now.equivalent_slope};
}

/// Where nothing recalls xi is the trial stress, eased by 1 + lambda rate = (Y + 3/2 rate dp) / Y: of the whole return
/// its size is enough.
template <int rows> Residual<rows> PartReturn<rows>::residual_of_trial(const Scalars<rows>& dp) const {
    const HardeningAt<Scalars<rows>> hardening = parameters_.isotropic.at(Scalars<rows>(before_.p + dp));
    const double zz_rate = law_.rates[0], shear_rate = law_.rates[1];  // and rates[2]: isotropy
    const Scalars<rows> Y = parameters_.yield_stress + hardening.value, zz_sum = Y + (1.5 * zz_rate) * dp,
                        shear_sum = Y + (1.5 * shear_rate) * dp, per_both = 1.0 / (zz_sum * shear_sum),
                        per_zz = shear_sum * per_both, per_shear = zz_sum * per_both,
                        zz = trial_zz_ * (Y * per_zz).square(), shear = trial_shear_ * (Y * per_shear).square(),
                        per_q = 1.0 / (1.5 * (zz + shear)).sqrt().max(std::numeric_limits<double>::min()),
                        eased_by_dp = zz_rate * zz * per_zz + shear_rate * shear * per_shear;
    return {Y, hardening.slope, per_q, -2.25 * (Y - dp * hardening.slope) * eased_by_dp * per_q};
}

/// The root by the cubic that dp is as a function of the residual at two places, the first of which is dp = 0: of
/// fourth order where Newton's method from the second one is of second.
template <int rows>
Scalars<rows> root_between(const Residual<rows>& start, const Residual<rows>& there, const Scalars<rows>& dp) {
    const Scalars<rows> range = there.value - start.value, t = -start.value / range, left = -there.value / range;
    return t * (t * (3.0 - 2.0 * t) * dp + left * range * (left / start.slope + t / there.slope));
}

/// It takes two or three; a curve with corners may need halvings of the bracket.
inline constexpr int most_trials = 100;

/// Of the yield surface: as near as this, over its radius, a return is at its end. What flows is farther off.
inline constexpr double close = 1e-2 * overstress_tolerance;

template <int rows> Scalars<rows> PartReturn<rows>::find(ReturnAt<rows>& now) const {
    now.back.resize(law_.recalling.size());
    now.xi = trial_;
    const Scalars<rows> none = Scalars<rows>::Zero();
    const Residual<rows> start = residual_at(none, now);
    const Mask<rows> flows = start.value > overstress_tolerance;
    Scalars<rows> dp = flows.select(-start.value / start.slope, 0.0), below = none, above = most();
    Mask<rows> searching = flows;
    for (int iteration = 0; searching.any(); ++iteration) {
        if (iteration == most_trials) throw NumericalFailure("return mapping: no plastic strain increment found");
        const Residual<rows> here = residual_at(dp, now);
        below = (searching && here.value > 0.0).select(dp, below);
        above = (searching && here.value <= 0.0).select(dp, above);
        Scalars<rows> next = dp - here.value / here.slope;
        if (iteration == 0 && !law_.has_thresholds) next = root_between<rows>(start, here, dp);
        const Mask<rows> inside = next > below && next < above;
        const Mask<rows> off = searching && !(here.value.abs() <= close);  // NaN goes on, to the failure
        const Scalars<rows> step = off.select(inside.select(next, 0.5 * (below + above)) - dp, 0.0);
        dp += step;
        searching = off && !(step.abs() <= 1e-8 * dp);  // the error left is the square of the step
    }
    put(dp, now);
    return dp;
}

}  // namespace stria::fine
