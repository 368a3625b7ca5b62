#include "fine/material/j2_implicit.hpp"

#include <array>
#include <tuple>

#include "common/index.hpp"
#include "fine/material/j2_return.hpp"

namespace stria::fine {

DeviatoricElasticity::DeviatoricElasticity(const Elasticity& elasticity)
    : stiffness(elasticity.stiffness()), on_deviators(deviator_basis() * stiffness),
      rates((on_deviators * deviator_basis().transpose()).diagonal()) {}

namespace {

/// C : eps for every point of a pack.
template <int rows> Tensors<rows> stress_of(const MandelMatrix& C, const Tensors<rows>& strain) {
    return (strain.matrix() * C).array();
}

/// What an increment changes at the points of a pack, taken in parts, and what that changes by with its elastic
/// deviatoric stress dev(C : d(eps)), on which alone it depends.
template <int rows> class IncrementInParts {
public:
    IncrementInParts(const J2Parameters& law, const DeviatoricElasticity& elasticity)
        : law_(law), elasticity_(elasticity) {}

    void begin(const J2Update& update, PackPlace<rows> at) {
        now_.stress = deviators_of<rows>(at.tensors(update.committed, state::stress));
        now_.p = at.scalars(update.committed, state::accumulated);
        now_.back.resize(law_.kinematic.size());
        for (std::size_t k = 0; k < now_.back.size(); ++k)
            now_.back[k] =
                deviators_of<rows>(at.tensors(update.committed, state::back_stress + 4 * static_cast<int>(k)));
        for (PackState<rows>& change : derivative_) change.set_zero(now_.back.size());
        for (Deviators<rows>& change : plastic_derivative_) change.setZero();
        plastic_.setZero();
        equivalent_.setZero();
        dissipated_.setZero();
    }

    /// One part after the other: the deviatoric elastic stress of each, and its share of the whole.
    void take(const Deviators<rows>& elastic, double part) {
        const Deviators<rows> trial = now_.stress + elastic;
        const Scalars<rows> dp = PartReturn<rows>(law_, elasticity_.rates, now_, trial).find(found_);
        const Deviators<rows> plastic = found_.xi.colwise() * found_.lambda;
        now_.stress = trial - rate_of(plastic);
        plastic_ += plastic;
        equivalent_ += dp;
        dissipated_ += law_.yield_stress * dp;
        for (std::size_t k = 0; k < now_.back.size(); ++k) dissipated_ += dissipated_by_recall(k, dp);
        differentiate(dp, part);
        for (std::size_t k = 0; k < now_.back.size(); ++k) now_.back[k] = found_.back[k].X;
        now_.p += dp;
    }

    void write(const J2Update& update, PackPlace<rows> at, const Tensors<rows>& strain_increment) const {
        const Tensors<rows> plastic = tensors_of<rows>(plastic_);
        const Tensors<rows> stress = at.tensors(update.committed, state::stress) +
                                     stress_of<rows>(elasticity_.stiffness, strain_increment - plastic);
        write_flow<rows>(update, at, strain_increment, stress, plastic, equivalent_, dissipated_);
        for (std::size_t k = 0; k < now_.back.size(); ++k)
            at.tensors(update.trial, state::back_stress + 4 * static_cast<int>(k)) = tensors_of<rows>(now_.back[k]);
        write_tangent(update, at);
    }

private:
    [[nodiscard]] Deviators<rows> rate_of(const Deviators<rows>& plastic) const {
        Deviators<rows> result;
        for (int i = 0; i < 3; ++i) result.col(i) = elasticity_.rates[i] * plastic.col(i);
        return result;
    }

    // docs/equations.md, "What recall dissipates". E: energy of a back stress.
    [[nodiscard]] Scalars<rows> dissipated_by_recall(std::size_t k, const Scalars<rows>& dp) const {
        const KinematicHardening& term = law_.kinematic[k];
        if (term.C == 0.0) return Scalars<rows>::Zero();
        const Recalled<rows>& back = found_.back[k];
        const Scalars<rows> E = 0.5 * dot<rows>(back.X, back.X) / back.stiffness;
        if (term.threshold) return 2.0 * E * (1.0 / back.theta - 1.0);
        const Deviators<rows>& X_n = now_.back[k];
        const Scalars<rows> E_n = 0.75 * dot<rows>(X_n, X_n) / modulus<Scalars<rows>>(term, now_.p);
        const Scalars<rows> by_recall = term.gamma * (1.5 * E + 0.5 * E_n);
        if (!term.C_start) return dp * by_recall;
        const Scalars<rows> at_end = dot<rows>(back.X, X_n) / back.stiffness - E / back.theta;
        return dp * (by_recall + 0.5 * (growth_of_modulus<Scalars<rows>>(term, now_.p) * E_n + back.growth * at_end));
    }

    // The equation of xi and q(xi) = Y, differentiated by the elastic stress and by dp. now_: still the state before,
    // but for the stress.
    void differentiate(const Scalars<rows>& dp, double part) {
        const Mask<rows> flows = dp > 0.0;
        const Scalars<rows> towards = 1.5 / found_.equivalent;
        const Scalars<rows> lambda_by_p = -found_.lambda * found_.Y_slope / found_.Y;
        const Scalars<rows> per_stiffening = 1.0 / (found_.Y_slope - found_.equivalent_slope);
        const Deviators<rows> slowed = (found_.rate * found_.xi).colwise() * lambda_by_p;
        for (int j = 0; j < 3; ++j) {
            PackState<rows>& change = derivative_[at(j)];
            change.stress.col(j) += part;
            Deviators<rows> rest = change.stress - slowed.colwise() * change.p;
            for (std::size_t k = 0; k < change.back.size(); ++k) {
                change.back[k] = found_.back[k].following(change.back[k]) + found_.back[k].drift.colwise() * change.p;
                rest -= change.back[k];
            }
            const Deviators<rows> at_dp = found_.eased(rest);
            const Scalars<rows> stretch = dot<rows>(found_.xi, at_dp) * towards - found_.Y_slope * change.p;
            const Scalars<rows> ddp = flows.select(stretch * per_stiffening, 0.0);
            const Scalars<rows> dlambda = found_.lambda_slope * ddp + lambda_by_p * change.p;
            const Deviators<rows> plastic =
                found_.xi.colwise() * dlambda + (at_dp + found_.xi_slope.colwise() * ddp).colwise() * found_.lambda;
            plastic_derivative_[at(j)] += plastic;
            change.stress -= rate_of(plastic);
            change.p += ddp;
            for (std::size_t k = 0; k < change.back.size(); ++k)
                change.back[k] += found_.back[k].following(plastic).colwise() * found_.back[k].stiffness +
                                  found_.back[k].by_dp().colwise() * ddp;
        }
    }

    // D = C - A^T S A, A = dev C, S the symmetric part of the plastic strain's derivative.
    void write_tangent(const J2Update& update, PackPlace<rows> at) const {
        const auto S = [&](int a, int b) -> Scalars<rows> {
            return 0.5 * (plastic_derivative_[stria::at(b)].col(a) + plastic_derivative_[stria::at(a)].col(b));
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

    const J2Parameters& law_;
    const DeviatoricElasticity& elasticity_;
    PackState<rows> now_;
    ReturnAt<rows> found_;
    std::array<PackState<rows>, 3> derivative_;
    std::array<Deviators<rows>, 3> plastic_derivative_;
    Deviators<rows> plastic_;
    Scalars<rows> equivalent_, dissipated_;
};

}  // namespace

void J2Implicit::return_points(const J2Update& update, int points, int stride) const {
    // Their memory serves one pack after the other.
    IncrementInParts<pack_size> of_packs(update.law, elasticity_);
    IncrementInParts<1> of_points(update.law, elasticity_);
    update_packs(
        update, points, stride,
        [&]<int rows>(PackPlace<rows>, const Tensors<rows>& strain) {
            return stress_of<rows>(elasticity_.stiffness, strain);
        },
        [&]<int rows>(PackPlace<rows> at, const Tensors<rows>& strain, const Prediction<rows>&) {
            auto& increment = std::get<IncrementInParts<rows>&>(std::tie(of_packs, of_points));
            const double part = 1.0 / update.law.substeps;
            const Deviators<rows> elastic = deviators_of<rows>(stress_of<rows>(elasticity_.stiffness, part * strain));
            increment.begin(update, at);
            for (int k = 0; k < update.law.substeps; ++k) increment.take(elastic, part);
            increment.write(update, at, strain);
        });
}

}  // namespace stria::fine
