// The exact return of J2 plasticity with linear isotropic and Prager hardening, for a strain increment along a straight
// line: R. D. Krieg, D. B. Krieg, J. Pressure Vessel Technol. 99 (1977) 510, for no hardening of the surface; with it
// M. Ristinmaa, J. Tryding, IJNME 36 (1993) 3599. In one closed form here, but for one integral.
#pragma once

#include <array>

#include "fine/material/point_pack.hpp"

namespace stria::fine {

/// The relative stress xi turns towards d = 2 G dev(d eps) while the radius R of the surface grows. With psi the angle
/// between both and tau the share of |d| gone, from where the surface is reached,
///     psi' = -|d| sin(psi) / R,  R' = h |d| cos(psi),  h = H / (3 G + C + H).
/// With w = ln tan(psi_0 / 2) - ln tan(psi / 2), c = cos(psi_0) and rho(w) = cosh w + c sinh w
///     sin(psi) = sin(psi_0) / rho,  R = R_0 rho^h,  and  int_0^w rho^h dw = l,
/// l the length of d beyond the surface over R_0. What is left, xi_1 = B xi_0 + A d, and its derivative by d follow.
template <int rows> class ExactFlow {
public:
    using S = Scalars<rows>;

    /// `before`, `d`: relative stress at the start and 2 G dev(d eps), MPa. `radius`: sqrt(2/3) (sigma_y + R), of the
    /// surface, MPa. A point that does not flow, or does not move, is elastic. The arguments must outlive the flow.
    ExactFlow(const Tensors<rows>& before, const Tensors<rows>& d, const S& radius,
              const Eigen::Array<bool, rows, 1>& flows, double h)
        : before_(before), d_(d), radius_(radius), h_(h),
          moves_(flows && contraction<rows>(d, d) > 1e-24 * radius * radius) {
        D2_ = moves_.select(contraction<rows>(d, d), 1.0);
        S_ = moves_.select(contraction<rows>(before, d), 0.0);
        const S inside = (radius * radius - contraction<rows>(before, before)).max(0.0);
        inside_ = moves_.select(inside, 0.0);
        D_ = D2_.sqrt();
        q_ = (S_ * S_ + D2_ * inside_).sqrt().max(1e-12 * radius * D_);
        c_ = (q_ / (radius * D_)).min(1.0);
        elastic_ = (q_ - S_) / D2_;
        length_ = moves_.select((1.0 - elastic_) * D_ / radius, 0.0).max(0.0);
        turn();
        A_ = (length_ > 0.0).select(A_, 1.0);
        B_ = (length_ > 0.0).select(B_, 1.0);
    }

    /// xi_1, MPa.
    [[nodiscard]] Tensors<rows> relative() const { return before_.colwise() * B_ + d_.colwise() * A_; }

    /// int |d| cos(psi) d tau: the length of the plastic strain path times 2/3 (3 G + C + H), MPa.
    [[nodiscard]] S plastic_path() const { return radius_ * grown_; }

    /// d xi_1 / d d = identity dev + dd d x d + mixed (d x xi_0 + xi_0 x d) + own xi_0 x xi_0. It is symmetric as long
    /// as the flow does not turn; `mixed` is the mean of both.
    struct Derivative {
        S identity, dd, mixed, own;
    };
    [[nodiscard]] Derivative derivative() const {
        const Change by_D2 = change(S::Ones(), S::Zero()), by_S = change(S::Zero(), S::Ones());
        const auto of_flow = [&](const S& value) { return (length_ > 0.0).select(value, 0.0).eval(); };
        return {A_, of_flow(2.0 * by_D2.A), of_flow(0.5 * by_S.A + by_D2.B), of_flow(by_S.B)};
    }

private:
    // rho = e^w (1 + c) / 2 (1 + k y), k = (1 - c) / (1 + c), y = e^-2w.
    void turn() {
        const S k = (1.0 - c_) / (1.0 + c_);
        S w = h_ > 0.0 ? S((h_ * length_).log1p() / h_) : length_;
        if (h_ > 0.0)
            for (int step = 0; step < newton_steps; ++step) {
                const S rho_h = (h_ * log_rho(w, k)).exp();
                w = (w - (integral(w, k) - length_) / rho_h).max(0.0);
            }
        log_rho_ = log_rho(w, k);
        const S y = (-2.0 * w).exp();
        rho_h_ = (h_ * log_rho_).exp();
        grown_ = h_ > 0.0 ? S((rho_h_ - 1.0) / h_) : log_rho_;
        c_end_ = ((1.0 - y) + c_ * (1.0 + y)) / ((1.0 + y) + c_ * (1.0 - y));
        sinh_per_rho_ = (1.0 - y) / ((1.0 + c_) * (1.0 + k * y));
        B_ = rho_h_ * (-log_rho_).exp();
        A_ = rho_h_ * radius_ * c_end_ / D_ - B_ * S_ / D2_;
        by_c_ = integral_by_c(w);
    }

    [[nodiscard]] S log_rho(const S& w, const S& k) const {
        return w + (0.5 * (1.0 + c_)).log() + (k * (-2.0 * w).exp()).log1p();
    }

    /// int_0^w rho^h: that of e^hw exactly, what 1 + k y adds by Gauss' formula in y.
    [[nodiscard]] S integral(const S& w, const S& k) const {
        const S y = (-2.0 * w).exp();
        S rest = S::Zero();
        for (const auto& [place, weight] : gauss) {
            const S at = y + place * (1.0 - y);
            rest += weight * (1.0 - y) * ((h_ * (k * at).log1p()).exp() - 1.0) / at * (-0.5 * h_ * at.log()).exp();
        }
        return (-h_ * k.log1p()).exp() * (((h_ * w).exp() - 1.0) / h_ + 0.5 * rest);
    }

    /// Its derivative by c, h int rho^(h-1) sinh w: in closed form, but where that is a difference of equals.
    [[nodiscard]] S integral_by_c(const S& w) const {
        if (h_ == 0.0) return S::Zero();
        const S sine2 = 1.0 - c_ * c_;
        const S radial = 0.5 * ((h_ * w).exp() - 1.0 - h_ / (2.0 - h_) * (1.0 - ((h_ - 2.0) * w).exp()));
        return (sine2 > 1e-6).select((rho_h_ - 1.0 - h_ * c_ * length_) / sine2.max(1e-6), radial);
    }

    /// Of A and B, as D2 = d : d and S = xi_0 : d change.
    struct Change {
        S A, B;
    };
    [[nodiscard]] Change change(const S& dD2, const S& dS) const {
        const S dq = (S_ * dS + 0.5 * inside_ * dD2) / q_;
        const S dD = 0.5 * dD2 / D_;
        const S dl = (dD * (1.0 + elastic_) - (dq - dS) / D_) / radius_;
        const S dc = dq / (radius_ * D_) - c_ * dD / D_;
        const S dw = (dl - by_c_ * dc) / rho_h_;
        const S dlog_rho = c_end_ * dw + sinh_per_rho_ * dc;
        const S dc_end = (-2.0 * log_rho_).exp() * (dc + (1.0 - c_ * c_) * dw);
        const S dB = (h_ - 1.0) * B_ * dlog_rho;
        const S turned = h_ * c_end_ * dlog_rho + dc_end - c_end_ * dD / D_;
        return {rho_h_ * radius_ / D_ * turned - (dB * S_ + B_ * dS - B_ * S_ * dD2 / D2_) / D2_, dB};
    }

    /// Newton's method starts from the solution of radial flow, wrong by less than h.
    static constexpr int newton_steps = 3;
    struct GaussPoint {
        double place, weight;  // on [0, 1]
    };
    static constexpr std::array<GaussPoint, 4> gauss{{{0.06943184420297371, 0.17392742256872692},
                                                      {0.33000947820757187, 0.32607257743127307},
                                                      {0.66999052179242813, 0.32607257743127307},
                                                      {0.93056815579702629, 0.17392742256872692}}};

    const Tensors<rows>&before_, &d_;
    const S& radius_;
    double h_;
    Eigen::Array<bool, rows, 1> moves_;
    S D2_, S_, inside_, D_;                  // |d|^2, xi_0 : d, R_0^2 - |xi_0|^2, |d|
    S q_, c_, elastic_, length_;             // R_0 |d| c; c; share of d that is elastic; l
    S log_rho_, rho_h_, grown_;              // at the end: ln rho, rho^h, (rho^h - 1) / h
    S c_end_, sinh_per_rho_, A_, B_, by_c_;  // cos(psi_1), sinh(w) / rho
};

}  // namespace stria::fine
