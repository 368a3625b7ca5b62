#include "fine/material/j2_implicit.hpp"

#include <algorithm>
#include <limits>
#include <tuple>
#include <vector>

#include "common/index.hpp"
#include "fine/material/j2_pack.hpp"

namespace stria::fine {

PlaneElasticity::PlaneElasticity(const Elasticity& elasticity)
    : stiffness(elasticity.stiffness()),
      biaxial_rate(elasticity.plane == PlaneState::Stress ? elasticity.young / (3.0 * (1.0 - elasticity.poisson))
                                                          : 2.0 * elasticity.shear_modulus()),
      shear_rate(2.0 * elasticity.shear_modulus()) {}

namespace {

/// Newton's method takes 3 to 6; a curve with corners may need halvings of the bracket.
constexpr int most_trials = 100;

template <int rows> using Mask = Eigen::Array<bool, rows, 1>;

/// C : eps for every point of a pack.
template <int rows> Tensors<rows> stress_of(const MandelMatrix& C, const Tensors<rows>& strain) {
    return (strain.matrix() * C).array();
}

/// A deviator with its two parts scaled.
template <int rows>
Tensors<rows> scaled(const Tensors<rows>& t, const Scalars<rows>& biaxial, const Scalars<rows>& shear) {
    const Scalars<rows> zz = biaxial * t.col(2), half_difference = 0.5 * shear * (t.col(0) - t.col(1));
    Tensors<rows> result;
    result.col(0) = -0.5 * zz + half_difference;
    result.col(1) = -0.5 * zz - half_difference;
    result.col(2) = zz;
    result.col(3) = shear * t.col(3);
    return result;
}

/// 3/2 a : b of the two parts of deviators.
template <int rows> Scalars<rows> biaxial_product(const Tensors<rows>& a, const Tensors<rows>& b) {
    return 2.25 * a.col(2) * b.col(2);
}
template <int rows> Scalars<rows> shear_product(const Tensors<rows>& a, const Tensors<rows>& b) {
    return 1.5 * (0.5 * (a.col(0) - a.col(1)) * (b.col(0) - b.col(1)) + a.col(3) * b.col(3));
}

/// Stress, back stresses and p of a pack; or what they change by with a component of the strain.
template <int rows> struct PackState {
    Tensors<rows> stress = Tensors<rows>::Zero();
    std::vector<Tensors<rows>> back;
    Scalars<rows> p = Scalars<rows>::Zero();
};

/// The return of one part of an increment at a plastic strain increment dp. With the flow d(eps_p) = lambda xi, lambda
/// = 3/2 dp / Y, Y = sigma_y + R(p + dp), back stresses become theta (X + 2/3 C d(eps_p)), theta = 1 / (1 + gamma dp),
/// and the relative stress is xi = eta / (1 + lambda rate), eta = dev(trial) - sum theta X, the rate of each part its
/// elastic one and 2/3 sum C theta.
template <int rows> struct ReturnAt {
    Scalars<rows> Y, Y_slope;            // MPa; by dp
    Scalars<rows> lambda, lambda_slope;  // 1/MPa
    Scalars<rows> recall, recall_slope;  // 2/3 sum C theta, MPa
    Tensors<rows> eta, eta_slope;
    Scalars<rows> per_biaxial, per_shear;        // 1 / (1 + lambda rate)
    Scalars<rows> equivalent, equivalent_slope;  // sqrt(3/2) |xi|
};

template <int rows> class PartReturn {
public:
    PartReturn(const J2Parameters& law, const PlaneElasticity& elasticity, const PackState<rows>& before,
               const Tensors<rows>& trial)
        : law_(law), elasticity_(elasticity), before_(before), trial_(trial), deviator_(deviators<rows>(trial)) {}

    [[nodiscard]] ReturnAt<rows> at(const Scalars<rows>& dp) const {
        ReturnAt<rows> now;
        const Scalars<rows> p = before_.p + dp;
        now.Y = law_.yield_stress + law_.isotropic.value(p);
        now.Y_slope = law_.isotropic.slope(p);
        now.lambda = 1.5 * dp / now.Y;
        now.lambda_slope = (1.5 - now.lambda * now.Y_slope) / now.Y;
        now.recall = now.recall_slope = Scalars<rows>::Zero();
        now.eta = deviator_;
        now.eta_slope.setZero();
        for (std::size_t k = 0; k < law_.kinematic.size(); ++k) {
            const auto [C, gamma] = law_.kinematic[k];
            const Scalars<rows> theta = 1.0 / (1.0 + gamma * dp), faded = gamma * theta.square();
            now.recall += 2.0 / 3.0 * C * theta;
            now.recall_slope -= 2.0 / 3.0 * C * faded;
            now.eta -= before_.back[k].colwise() * theta;
            now.eta_slope += before_.back[k].colwise() * faded;
        }
        put_equivalent(now);
        return now;
    }

    /// dp of the points that flow, 0 of the others: the root of 1 - Y / q, nearly a straight line, between bounds.
    [[nodiscard]] Scalars<rows> plastic_increment() const {
        const Scalars<rows> zero = Scalars<rows>::Zero();
        const ReturnAt<rows> elastic = at(zero);
        const Mask<rows> flows = elastic.equivalent > elastic.Y * (1.0 + overstress_tolerance);
        Scalars<rows> below = zero, above = most();
        Scalars<rows> dp = flows.select((elastic.equivalent - elastic.Y) /
                                            (1.5 * (elasticity_.shear_rate + elastic.recall) + elastic.Y_slope),
                                        0.0);
        Mask<rows> searching = flows;
        for (int iteration = 0; searching.any(); ++iteration) {
            if (iteration == most_trials) throw NumericalFailure("return mapping: no plastic strain increment found");
            const ReturnAt<rows> now = at(dp);
            const Scalars<rows> per_q = 1.0 / now.equivalent;
            const Scalars<rows> F = 1.0 - now.Y * per_q;
            const Scalars<rows> slope = (now.Y * now.equivalent_slope * per_q - now.Y_slope) * per_q;
            below = (searching && F > 0.0).select(dp, below);
            above = (searching && F <= 0.0).select(dp, above);
            const Scalars<rows> newton = dp - F / slope;
            const Mask<rows> inside = newton > below && newton < above;
            const Scalars<rows> next = inside.select(newton, 0.5 * (below + above));
            const Scalars<rows> step = (next - dp).abs();
            const Mask<rows> off = searching && !(F.abs() <= 1e-15);  // NaN goes on, to the failure
            dp = off.select(next, dp);
            searching = off && !(step <= 1e-9 * dp);  // the error left is the square of the step
        }
        return dp;
    }

    [[nodiscard]] const PlaneElasticity& elasticity() const { return elasticity_; }
    [[nodiscard]] const Tensors<rows>& trial() const { return trial_; }

private:
    // q^2 of the parts of eta, each over (1 + lambda rate)^2.
    void put_equivalent(ReturnAt<rows>& now) const {
        const Scalars<rows> biaxial_rate = elasticity_.biaxial_rate + now.recall,
                            shear_rate = elasticity_.shear_rate + now.recall;
        now.per_biaxial = 1.0 / (1.0 + now.lambda * biaxial_rate);
        now.per_shear = 1.0 / (1.0 + now.lambda * shear_rate);
        const Scalars<rows> biaxial = biaxial_product<rows>(now.eta, now.eta) * now.per_biaxial.square();
        const Scalars<rows> shear = shear_product<rows>(now.eta, now.eta) * now.per_shear.square();
        now.equivalent = (biaxial + shear).sqrt().max(std::numeric_limits<double>::min());
        const Scalars<rows> biaxial_slope = now.lambda_slope * biaxial_rate + now.lambda * now.recall_slope;
        const Scalars<rows> shear_slope = now.lambda_slope * shear_rate + now.lambda * now.recall_slope;
        now.equivalent_slope = (biaxial_product<rows>(now.eta, now.eta_slope) * now.per_biaxial.square() +
                                shear_product<rows>(now.eta, now.eta_slope) * now.per_shear.square() -
                                biaxial * now.per_biaxial * biaxial_slope - shear * now.per_shear * shear_slope) /
                               now.equivalent;
    }

    /// More than any dp: with it the elastic part of the return alone would bring all stress below Y.
    [[nodiscard]] Scalars<rows> most() const {
        const auto size = [](const Tensors<rows>& t) -> Scalars<rows> {
            return (1.5 * contraction<rows>(t, t)).sqrt();
        };
        Scalars<rows> sum = size(deviator_);
        for (const Tensors<rows>& back : before_.back) sum += size(back);
        return sum / (1.5 * std::min(elasticity_.biaxial_rate, elasticity_.shear_rate));
    }

    const J2Parameters& law_;
    const PlaneElasticity& elasticity_;
    const PackState<rows>& before_;
    const Tensors<rows>& trial_;
    Tensors<rows> deviator_;
};

/// What an increment changes at the points of a pack, taken in `parts`, and what that changes by with the strain.
template <int rows> class IncrementInParts {
public:
    IncrementInParts(const J2Parameters& law, const PlaneElasticity& elasticity) : law_(law), elasticity_(elasticity) {}

    void begin(const J2Update& update, PackPlace<rows> at) {
        now_.stress = at.tensors(update.committed, state::stress);
        now_.p = at.scalars(update.committed, state::accumulated);
        now_.back.resize(law_.kinematic.size());
        for (std::size_t k = 0; k < now_.back.size(); ++k)
            now_.back[k] = at.tensors(update.committed, state::back_stress + 4 * static_cast<int>(k));
        for (PackState<rows>& change : by_strain_) {
            change.stress.setZero();
            change.p.setZero();
            change.back.assign(now_.back.size(), Tensors<rows>::Zero());
        }
        plastic_.setZero();
        equivalent_.setZero();
        dissipated_.setZero();
    }

    void take(const Tensors<rows>& strain, double part) {
        const Tensors<rows> trial = now_.stress + stress_of<rows>(elasticity_.stiffness, part * strain);
        const PartReturn<rows> problem(law_, elasticity_, now_, trial);
        const Scalars<rows> dp = problem.plastic_increment();
        const ReturnAt<rows> found = problem.at(dp);
        const Tensors<rows> xi = scaled<rows>(found.eta, found.per_biaxial, found.per_shear);
        const Tensors<rows> plastic = xi.colwise() * found.lambda;
        now_.stress = trial - stress_of<rows>(elasticity_.stiffness, plastic);
        now_.p += dp;
        plastic_ += plastic;
        equivalent_ += dp;
        dissipated_ += law_.yield_stress * dp;
        for (std::size_t k = 0; k < now_.back.size(); ++k) {
            const auto [C, gamma] = law_.kinematic[k];
            Tensors<rows>& X = now_.back[k];
            X = (X + 2.0 / 3.0 * C * plastic).colwise() / (1.0 + gamma * dp);
            if (C > 0.0) dissipated_ += 1.5 * gamma / C * contraction<rows>(X, X) * dp;
        }
        differentiate(found, xi, dp, part);
    }

    void write(const J2Update& update, PackPlace<rows> at, const Tensors<rows>& strain_increment) const {
        write_flow<rows>(update, at, strain_increment, now_.stress, plastic_, equivalent_, dissipated_);
        for (std::size_t k = 0; k < now_.back.size(); ++k)
            at.tensors(update.trial, state::back_stress + 4 * static_cast<int>(k)) = now_.back[k];
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j <= i; ++j) {
                const Scalars<rows> value =
                    0.5 * (by_strain_[stria::at(j)].stress.col(i) + by_strain_[stria::at(i)].stress.col(j));
                at.scalars(update.tangent, 4 * i + j) = value;
                at.scalars(update.tangent, 4 * j + i) = value;
            }
    }

private:
    // xi (1 + lambda rate) = eta and q(xi) = Y, differentiated by the strain and by dp. `found` is of the state before,
    // `now_` that after.
    void differentiate(const ReturnAt<rows>& found, const Tensors<rows>& xi, const Scalars<rows>& dp, double part) {
        const Mask<rows> flows = dp > 0.0;
        const Scalars<rows> per_q = 1.0 / found.equivalent;
        const Scalars<rows> biaxial_rate = elasticity_.biaxial_rate + found.recall,
                            shear_rate = elasticity_.shear_rate + found.recall;
        const Tensors<rows> rate_xi = scaled<rows>(xi, biaxial_rate, shear_rate);
        const auto eased = [&](const Tensors<rows>& t) { return scaled<rows>(t, found.per_biaxial, found.per_shear); };
        const Tensors<rows> by_dp = eased(found.eta_slope - rate_xi.colwise() * found.lambda_slope -
                                          xi.colwise() * (found.lambda * found.recall_slope));
        const Scalars<rows> lambda_by_p = -found.lambda * found.Y_slope / found.Y;
        const Scalars<rows> stiffening = found.Y_slope - 1.5 * contraction<rows>(xi, by_dp) * per_q;
        for (int j = 0; j < 4; ++j) {
            PackState<rows>& change = by_strain_[at(j)];
            Tensors<rows> trial = change.stress;
            for (int i = 0; i < 4; ++i) trial.col(i) += part * elasticity_.stiffness(i, j);
            Tensors<rows> eta = deviators<rows>(trial);
            for (std::size_t k = 0; k < change.back.size(); ++k)
                eta -= change.back[k].colwise() / (1.0 + law_.kinematic[k].gamma * dp);
            const Tensors<rows> by_strain = eased(eta - rate_xi.colwise() * (lambda_by_p * change.p));
            const Scalars<rows> ddp = flows.select(
                (1.5 * contraction<rows>(xi, by_strain) * per_q - found.Y_slope * change.p) / stiffening, 0.0);
            const Scalars<rows> dlambda = found.lambda_slope * ddp + lambda_by_p * change.p;
            const Tensors<rows> plastic =
                xi.colwise() * dlambda + (by_strain + by_dp.colwise() * ddp).colwise() * found.lambda;
            change.stress = trial - stress_of<rows>(elasticity_.stiffness, plastic);
            change.p += ddp;
            for (std::size_t k = 0; k < change.back.size(); ++k) {
                const auto [C, gamma] = law_.kinematic[k];
                change.back[k] =
                    (change.back[k] + 2.0 / 3.0 * C * plastic - now_.back[k].colwise() * (gamma * ddp)).colwise() /
                    (1.0 + gamma * dp);
            }
        }
    }

    const J2Parameters& law_;
    const PlaneElasticity& elasticity_;
    PackState<rows> now_;
    std::array<PackState<rows>, 4> by_strain_;
    Tensors<rows> plastic_ = Tensors<rows>::Zero();
    Scalars<rows> equivalent_ = Scalars<rows>::Zero(), dissipated_ = Scalars<rows>::Zero();
};

}  // namespace

void J2Implicit::return_points(const J2Update& update, int points, int stride) const {
    // Their memory serves one pack after the other.
    std::tuple increments{IncrementInParts<pack_size>(update.law, elasticity_),
                          IncrementInParts<1>(update.law, elasticity_)};
    update_packs(
        update, points, stride,
        [&]<int rows>(PackPlace<rows>, const Tensors<rows>& strain) {
            return stress_of<rows>(elasticity_.stiffness, strain);
        },
        [&]<int rows>(PackPlace<rows> at, const Tensors<rows>& strain, const Prediction<rows>&) {
            auto& increment = std::get<IncrementInParts<rows>>(increments);
            increment.begin(update, at);
            for (int k = 0; k < update.law.substeps; ++k) increment.take(strain, 1.0 / update.law.substeps);
            increment.write(update, at, strain);
        });
}

}  // namespace stria::fine
