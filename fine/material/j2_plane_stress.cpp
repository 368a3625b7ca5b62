#include "fine/material/j2_plane_stress.hpp"

#include <algorithm>

#include "fine/material/j2_pack.hpp"

namespace stria::fine {

namespace {

/// Newton's method takes 2 to 5.
constexpr int most_iterations = 50;

/// In the plane the relative stress xi = dev(sigma) - X has two independent parts, its zz component (the equibiaxial
/// stress) and the shears (xx - yy, xy). Each returns on its own: xi = xi_predicted / (1 + gamma rate).
struct PlaneBlock {
    const J2Update& update;
    double isotropic;     // MPa, H
    double biaxial;       // MPa, E / (1 - nu): equibiaxial stress per strain
    double two_shear;     // MPa, 2 G
    double biaxial_rate;  // MPa, E / (3 (1 - nu)) + 2/3 sum C
    double shear_rate;    // MPa, 2 G + 2/3 sum C
};

/// C : eps for every point of a pack.
template <int rows> Tensors<rows> in_plane_stress(const PlaneBlock& block, const Tensors<rows>& strain) {
    const Scalars<rows> mean = 0.5 * block.biaxial * (strain.col(0) + strain.col(1));
    const Scalars<rows> half_difference = 0.5 * block.two_shear * (strain.col(0) - strain.col(1));
    Tensors<rows> stress;
    stress.col(0) = mean + half_difference;
    stress.col(1) = mean - half_difference;
    stress.col(2).setZero();
    stress.col(3) = block.two_shear * strain.col(3);
    return stress;
}

/// The return at a plastic multiplier gamma: d(eps_p) = gamma xi.
template <int rows> struct Return {
    Scalars<rows> per_biaxial, per_shear;  // what is left of the two parts of the predicted xi
    Scalars<rows> equivalent;              // q = sqrt(3/2) |xi|
    Scalars<rows> softening;               // -1/3 d(q^2) / d gamma
};

/// Biaxial and shear parts of |xi|^2, squared and times 3/2.
template <int rows> struct Parts {
    Scalars<rows> biaxial, shear;

    explicit Parts(const Tensors<rows>& relative)
        : biaxial(2.25 * relative.col(2).square()),
          shear(1.5 * (0.5 * (relative.col(0) - relative.col(1)).square() + relative.col(3).square())) {}
};

template <int rows>
Return<rows> return_at(const PlaneBlock& block, const Parts<rows>& predicted, const Scalars<rows>& gamma) {
    Return<rows> result;
    result.per_biaxial = 1.0 / (1.0 + block.biaxial_rate * gamma);
    result.per_shear = 1.0 / (1.0 + block.shear_rate * gamma);
    const Scalars<rows> biaxial = predicted.biaxial * result.per_biaxial.square();
    const Scalars<rows> shear = predicted.shear * result.per_shear.square();
    result.equivalent = (biaxial + shear).sqrt();
    result.softening =
        2.0 / 3.0 * (block.biaxial_rate * biaxial * result.per_biaxial + block.shear_rate * shear * result.per_shear);
    return result;
}

/// gamma with q = sigma_y + R + H dp, dp = 2/3 gamma q, zero where a point does not flow. Written for 1/q,
///     h(gamma) = (1 - 2/3 H gamma) / (sigma_y + R) - 1/q(gamma) = 0,
/// h is decreasing and convex (1/q is a power mean, of order -2, of functions linear in gamma) and not negative where
/// the search starts, with the larger rate for both parts: Newton's method climbs to the root and never passes it.
template <int rows>
Scalars<rows> plastic_multiplier(const PlaneBlock& block, const Prediction<rows>& prediction,
                                 const Parts<rows>& parts) {
    const double H = block.isotropic, rate = std::max(block.biaxial_rate, block.shear_rate);
    const Scalars<rows> limit = prediction.yield_stress;
    Scalars<rows> gamma =
        prediction.flows.select(prediction.overstress / (rate * limit + 2.0 / 3.0 * H * prediction.equivalent), 0.0);
    Eigen::Array<bool, rows, 1> searching = prediction.flows;
    for (int iteration = 0; searching.any(); ++iteration) {
        if (iteration == most_iterations)
            throw NumericalFailure("return mapping in plane stress: no plastic multiplier found");
        const Return<rows> now = return_at<rows>(block, parts, gamma);
        const Scalars<rows> per_q = 1.0 / searching.select(now.equivalent, 1.0);
        const Scalars<rows> h = (1.0 - 2.0 / 3.0 * H * gamma) / limit - per_q;
        const Scalars<rows> slope = 2.0 / 3.0 * H / limit + 1.5 * now.softening * per_q * per_q * per_q;
        const Scalars<rows> step = searching.select(h / slope, 0.0);
        gamma += step;
        // The error left is the square of the step; below that is rounding. NaN goes on, to the failure.
        searching = searching && !(step <= 1e-9 * gamma + 1e-14 / rate);
    }
    return gamma;
}

/// Simo and Taylor's tangent: what is left of C after the return at constant gamma, less v x v / (softening +
/// hardening) with v = d sigma / d gamma. Where nothing flows gamma and v are zero and D is C to the last bit.
template <int rows>
void write_tangent(const PlaneBlock& block, PackPlace<rows> at, const Return<rows>& returned,
                   const Tensors<rows>& plastic, const Scalars<rows>& gamma, const Prediction<rows>& prediction) {
    const MandelMatrix& C = block.update.stiffness;
    const double H = block.isotropic;
    const Scalars<rows> lost_biaxial = block.biaxial * block.biaxial / 3.0 * gamma * returned.per_biaxial;
    const Scalars<rows> lost_shear = block.two_shear * block.two_shear * gamma * returned.per_shear;
    // gamma > 0 with q = limit / (1 - 2/3 H gamma): hardening = 4/9 H q^2 / (1 - 2/3 H gamma) = 4/9 H q^3 / limit.
    const Scalars<rows> hardening =
        4.0 / 9.0 * H * returned.equivalent.square() * returned.equivalent / prediction.yield_stress;
    const Scalars<rows> per_gamma = 1.0 / prediction.flows.select(gamma, 1.0);
    Tensors<rows> v = in_plane_stress<rows>(block, plastic.colwise() * per_gamma);  // C xi
    const Scalars<rows> mean = 0.5 * (v.col(0) + v.col(1)) * returned.per_biaxial;
    const Scalars<rows> half_difference = 0.5 * (v.col(0) - v.col(1)) * returned.per_shear;
    v.col(0) = mean + half_difference;
    v.col(1) = mean - half_difference;
    v.col(3) *= returned.per_shear;
    const Scalars<rows> per_denominator = 1.0 / prediction.flows.select(returned.softening + hardening, 1.0);

    const auto put = [&](int i, int j, const Scalars<rows>& lost) {
        const Scalars<rows> value = C(i, j) - lost - per_denominator * v.col(i) * v.col(j);
        at.scalars(block.update.tangent, 4 * i + j) = value;
        at.scalars(block.update.tangent, 4 * j + i) = value;
    };
    const Scalars<rows> lost_normal = 0.5 * (lost_biaxial + lost_shear);
    put(0, 0, lost_normal);
    put(1, 1, lost_normal);
    put(0, 1, 0.5 * (lost_biaxial - lost_shear));
    put(0, 3, Scalars<rows>::Zero());
    put(1, 3, Scalars<rows>::Zero());
    put(3, 3, lost_shear);
    for (int i = 0; i < 4; ++i) put(2, i, Scalars<rows>::Zero());  // C and v have no zz
}

template <int rows>
void return_to_surface(const PlaneBlock& block, PackPlace<rows> at, const Tensors<rows>& strain_increment,
                       const Prediction<rows>& prediction) {
    const Parts<rows> parts(prediction.relative);
    const Scalars<rows> gamma = plastic_multiplier<rows>(block, prediction, parts);
    const Return<rows> returned = return_at<rows>(block, parts, gamma);
    const Scalars<rows> dp = 2.0 / 3.0 * gamma * returned.equivalent;

    const Tensors<rows>& relative = prediction.relative;
    const Scalars<rows> zz = gamma * returned.per_biaxial * relative.col(2);
    const Scalars<rows> half_difference = 0.5 * gamma * returned.per_shear * (relative.col(0) - relative.col(1));
    Tensors<rows> plastic;
    plastic.col(0) = -0.5 * zz + half_difference;
    plastic.col(1) = -0.5 * zz - half_difference;
    plastic.col(2) = zz;
    plastic.col(3) = gamma * returned.per_shear * relative.col(3);
    const Tensors<rows> stress = prediction.stress - in_plane_stress<rows>(block, plastic);
    write_state<rows>(block.update, at, strain_increment, stress, plastic, dp);
    write_tangent<rows>(block, at, returned, plastic, gamma, prediction);
}

}  // namespace

void J2PlaneStress::return_points(const J2Update& update, int points, int stride) const {
    const Elasticity& elastic_part = parameters().elasticity;
    const double biaxial = elastic_part.young / (1.0 - elastic_part.poisson);
    const double two_shear = 2.0 * elastic_part.shear_modulus();
    const double back = 2.0 / 3.0 * parameters().prager_modulus();
    const PlaneBlock block{.update = update,
                           .isotropic = parameters().isotropic.linear()->modulus,
                           .biaxial = biaxial,
                           .two_shear = two_shear,
                           .biaxial_rate = biaxial / 3.0 + back,
                           .shear_rate = two_shear + back};
    update_packs(
        update, points, stride,
        [&]<int rows>(PackPlace<rows>, const Tensors<rows>& strain) { return in_plane_stress<rows>(block, strain); },
        [&]<int rows>(PackPlace<rows> at, const Tensors<rows>& strain, const Prediction<rows>& prediction, int) {
            return_to_surface<rows>(block, at, strain, prediction);
        });
}

}  // namespace stria::fine
