// What an increment changes at the points of a pack, and what that changes by with its elastic deviatoric stress
// dev(C : d(eps)), on which alone it depends.
#pragma once

#include <array>

#include "fine/material/implicit/deviatoric_elasticity.hpp"
#include "fine/material/implicit/parts_of_increment.hpp"

namespace stria::fine {

/// Where the points of a pack are within an increment.
template <int rows> struct Progress {
    PackState<rows> state;
    Deviators<rows> plastic;                    // strain, so far in the increment
    Scalars<rows> equivalent, dissipated;       // dp, N/mm2, so far in it
    std::array<PackState<rows>, 3> derivative;  // of the state, by the elastic stress of the whole increment
    std::array<Deviators<rows>, 3> plastic_derivative;

    /// Further on the straight line from `start`: `factor` times as far.
    void extrapolate(const Progress& start, double factor) {
        const auto further = [factor](auto& value, const auto& from) { value = from + factor * (value - from); };
        const auto state_further = [&](PackState<rows>& value, const PackState<rows>& from) {
            further(value.stress, from.stress);
            further(value.p, from.p);
            for (std::size_t k = 0; k < value.back.size(); ++k) further(value.back[k], from.back[k]);
        };
        state_further(state, start.state);
        further(plastic, start.plastic);
        further(equivalent, start.equivalent);
        further(dissipated, start.dissipated);
        for (std::size_t j = 0; j < 3; ++j) {
            state_further(derivative[j], start.derivative[j]);
            further(plastic_derivative[j], start.plastic_derivative[j]);
        }
    }
};

/// Alexander's method of second order, SIAM J. Numer. Anal. 14 (1977) 1006: backward Euler over a = 1 - 1/sqrt(2) of
/// the part, along the straight line to 1 - a of it, and backward Euler again over a from there. So every part ends on
/// the yield surface, and errors of large parts fade.
struct Alexander {
    static constexpr double a = 1.0 - 0.5 * std::numbers::sqrt2, beyond = (1.0 - a) / a;
};

template <int rows> class IncrementInParts {
public:
    /// The arguments must outlive the increment.
    IncrementInParts(const J2Parameters& parameters, const DeviatoricElasticity& elasticity, const ReturnLaw& law)
        : parameters_(parameters), elasticity_(elasticity), law_(law) {}

    /// `elastic`: deviatoric elastic stress of the whole increment, MPa.
    void begin(const J2Update& update, PackPlace<rows> at, const Deviators<rows>& elastic) {
        elastic_ = elastic;
        now_.state.put(law_, at, update.committed);
        for (PackState<rows>& change : now_.derivative) change.set_zero(law_.recalling.size());
        for (Deviators<rows>& change : now_.plastic_derivative) change.setZero();
        now_.plastic.setZero();
        now_.equivalent.setZero();
        now_.dissipated.setZero();
    }

    void take_at_once() { flow(WithSlope<rows>(Scalars<rows>::Ones()), true); }

    void take_within_bound(const Mask<rows>& flows) {
        const PartsOfIncrement<rows> parts(parameters_, law_, now_.state, elastic_, flows);
        move(parts.elastic());
        for (int k = 0; k < parts.count(); ++k) {
            start_ = now_;
            const WithSlope<rows> stage = Alexander::a * parts.part(k);
            flow(stage, false);
            now_.extrapolate(start_, Alexander::beyond);
            keep_within_limits();
            flow(stage, false);
        }
    }

    void write(const J2Update& update, PackPlace<rows> at, const Tensors<rows>& strain_increment) const {
        const Tensors<rows> plastic = tensors_of<rows>(now_.plastic);
        const Tensors<rows> stress =
            at.tensors(update.committed, state::stress) + elasticity_.stress<rows>(strain_increment - plastic);
        write_flow<rows>(update, at, strain_increment, stress, plastic, now_.equivalent, now_.dissipated);
        for (std::size_t k = 0; k < law_.linear.size(); ++k)
            at.tensors(update.trial, law_.linear[k]) =
                at.tensors(update.committed, law_.linear[k]) + 2.0 / 3.0 * law_.linear_C[k] * plastic;
        for (std::size_t k = 0; k < law_.recalling.size(); ++k)
            at.tensors(update.trial, law_.back_stresses[k]) = tensors_of<rows>(now_.state.back[k]);
        write_tangent(update, at);
    }

private:
    /// A share of the increment without flow.
    void move(const WithSlope<rows>& share) {
        now_.state.stress += elastic_ * share.value;
        for (int j = 0; j < 3; ++j) {
            Deviators<rows>& change = now_.derivative[stria::at(j)].stress;
            change.col(j) += share.value;
            change += elastic_ * share.slope.col(j);
        }
    }

    /// The straight line of a large part leads beyond what recall allows a back stress: back to the limit C / gamma.
    void keep_within_limits() {
        for (std::size_t k = 0; k < law_.recalling.size(); ++k) {
            const KinematicHardening& term = law_.recalling[k];
            if (term.gamma == 0.0 || term.threshold) continue;
            const double limit = std::max(term.C, term.C_start.value_or(0.0)) / term.gamma;
            Deviators<rows>& X = now_.state.back[k];
            const Scalars<rows> size = equivalent<rows>(X);
            const Mask<rows> beyond = size > limit;
            if (!beyond.any()) continue;
            const Scalars<rows> per_size = beyond.select(1.0 / size, 0.0), share = beyond.select(limit * per_size, 1.0);
            const Deviators<rows> along = X * (std::sqrt(1.5) * per_size);
            for (PackState<rows>& change : now_.derivative)
                change.back[k] = (change.back[k] - along * dot<rows>(along, change.back[k])) * share;
            X = X * share;
        }
    }

    /// Backward Euler over a share of the increment; `whole`: of all of it.
    void flow(const WithSlope<rows>& share, bool whole) {
        const Deviators<rows> trial = now_.state.stress + elastic_ * share.value;
        const Scalars<rows> dp = PartReturn<rows>(parameters_, law_, now_.state, trial).find(found_);
        const Deviators<rows> plastic = found_.xi * found_.lambda;
        move(share);
        now_.state.stress -= law_.lost<rows>(plastic);
        now_.plastic += plastic;
        now_.equivalent += dp;
        now_.dissipated += parameters_.yield_stress * dp;
        for (std::size_t k = 0; k < law_.recalling.size(); ++k)
            now_.dissipated += whole ? dissipated_by_recall(k, dp) : dissipated_at_rate(k, dp);
        differentiate(dp);
        for (std::size_t k = 0; k < law_.recalling.size(); ++k) now_.state.back[k] = found_.back[k].X;
        now_.state.p += dp;
    }

    // docs/equations.md, "What recall dissipates". E: energy of a back stress.
    [[nodiscard]] Scalars<rows> dissipated_by_recall(std::size_t k, const Scalars<rows>& dp) const {
        const KinematicHardening& term = law_.recalling[k];
        if (term.C == 0.0 || term.threshold) return dissipated_at_rate(k, dp);
        const Recalled<rows>& back = found_.back[k];
        const Scalars<rows> E = 0.5 * dot<rows>(back.X, back.X) / back.stiffness;
        const Deviators<rows>& X_n = now_.state.back[k];
        const Scalars<rows> E_n = 0.75 * dot<rows>(X_n, X_n) / modulus<Scalars<rows>>(term, now_.state.p);
        const Scalars<rows> by_recall = term.gamma * (1.5 * E + 0.5 * E_n);
        if (!term.C_start) return dp * by_recall;
        const Scalars<rows> at_end = dot<rows>(back.X, X_n) / back.stiffness - E / back.theta;
        return dp *
               (by_recall + 0.5 * (growth_of_modulus<Scalars<rows>>(term, now_.state.p) * E_n + back.growth * at_end));
    }

    // The same by the rate at the end alone: what a stage of a method gives.
    [[nodiscard]] Scalars<rows> dissipated_at_rate(std::size_t k, const Scalars<rows>& dp) const {
        const KinematicHardening& term = law_.recalling[k];
        if (term.C == 0.0) return Scalars<rows>::Zero();
        const Recalled<rows>& back = found_.back[k];
        const Scalars<rows> E = 0.5 * dot<rows>(back.X, back.X) / back.stiffness;
        if (term.threshold) return 2.0 * E * (1.0 / back.theta - 1.0);
        return dp * E * (2.0 * term.gamma + back.growth);
    }

    // The equation of xi and q(xi) = Y, differentiated by the elastic stress and by dp. now_: still the state before,
    // but for the stress and what it changes by.
    void differentiate(const Scalars<rows>& dp) {
        const Mask<rows> flows = dp > 0.0;
        const Scalars<rows> towards = 1.5 / found_.equivalent;
        const Scalars<rows> lambda_by_p = -found_.lambda * found_.Y_slope / found_.Y;
        const Scalars<rows> per_stiffening = 1.0 / (found_.Y_slope - found_.equivalent_slope);
        const Deviators<rows> slowed = (found_.rate * found_.xi) * lambda_by_p;
        for (std::size_t j = 0; j < 3; ++j) {
            PackState<rows>& change = now_.derivative[j];
            Deviators<rows> rest = change.stress - slowed * change.p;
            for (std::size_t k = 0; k < change.back.size(); ++k) {
                change.back[k] = found_.back[k].following(change.back[k]) + found_.back[k].drift * change.p;
                rest -= change.back[k];
            }
            const Deviators<rows> at_dp = found_.eased(rest);
            const Scalars<rows> stretch = dot<rows>(found_.xi, at_dp) * towards - found_.Y_slope * change.p;
            const Scalars<rows> ddp = flows.select(stretch * per_stiffening, 0.0);
            const Scalars<rows> dlambda = found_.lambda_slope * ddp + lambda_by_p * change.p;
            const Deviators<rows> plastic = found_.xi * dlambda + (at_dp + found_.xi_slope * ddp) * found_.lambda;
            now_.plastic_derivative[j] += plastic;
            change.stress -= law_.lost<rows>(plastic);
            change.p += ddp;
            for (std::size_t k = 0; k < change.back.size(); ++k)
                change.back[k] +=
                    found_.back[k].following(plastic) * found_.back[k].stiffness + found_.back[k].by_dp() * ddp;
        }
    }

    // D = C - A^T S A, A = dev C, S the symmetric part of the plastic strain's derivative.
    void write_tangent(const J2Update& update, PackPlace<rows> at) const {
        const auto S = [&](int a, int b) -> Scalars<rows> {
            return 0.5 * (now_.plastic_derivative[stria::at(b)].col(a) + now_.plastic_derivative[stria::at(a)].col(b));
        };
        const auto& A = elasticity_.on_deviators;
        std::array<Tensors<rows>, 3> SA;
        for (int a = 0; a < 3; ++a)
            for (int j = 0; j < 4; ++j)
                SA[stria::at(a)].col(j) = S(a, 0) * A(0, j) + S(a, 1) * A(1, j) + S(a, 2) * A(2, j);
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j <= i; ++j) {
                Scalars<rows> value = Scalars<rows>::Constant(elasticity_.stiffness(i, j));
                for (int a = 0; a < 3; ++a) value -= A(a, i) * SA[stria::at(a)].col(j);
                at.scalars(update.tangent, 4 * i + j) = value;
                at.scalars(update.tangent, 4 * j + i) = value;
            }
    }

    const J2Parameters& parameters_;
    const DeviatoricElasticity& elasticity_;
    const ReturnLaw& law_;
    Deviators<rows> elastic_;
    Progress<rows> now_, start_;
    ReturnAt<rows> found_;
};

}  // namespace stria::fine
