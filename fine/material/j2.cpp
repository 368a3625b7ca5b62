#include "fine/material/j2.hpp"

#include <cmath>

#include "fine/material/exact_flow.hpp"
#include "fine/material/j2_pack.hpp"

namespace stria::fine {

namespace {

struct Block {
    const J2Update& update;
    double bulk;
    double shear;
    double isotropic;
    double uniaxial;
    double lost;  // relative stress lost per plastic strain
};

constexpr double deviatoric(int i, int j) { return (i == j ? 1.0 : 0.0) - (i < 3 && j < 3 ? 1.0 / 3.0 : 0.0); }

/// D = C - 4 G^2 / (2 G + 2/3 C) (dev - d xi_1 / d d), where the relative stress left, xi_1, tells the plastic strain.
/// As long as the flow does not turn D is symmetric; what it is not otherwise is left out: it would make every front of
/// the zone unsymmetric.
template <int rows>
void write_tangent(const Block& block, PackPlace<rows> at, const Tensors<rows>& before, const Tensors<rows>& d,
                   const typename ExactFlow<rows>::Derivative& by_d, const Scalars<rows>& flowing) {
    const Scalars<rows> factor = flowing * (4.0 * block.shear * block.shear / block.lost);
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j <= i; ++j) {
            const Scalars<rows> left = by_d.identity * deviatoric(i, j) + by_d.dd * d.col(i) * d.col(j) +
                                       by_d.mixed * (d.col(i) * before.col(j) + before.col(i) * d.col(j)) +
                                       by_d.own * before.col(i) * before.col(j);
            const Scalars<rows> value = block.update.stiffness(i, j) - factor * (deviatoric(i, j) - left);
            at.scalars(block.update.tangent, 4 * i + j) = value;
            at.scalars(block.update.tangent, 4 * j + i) = value;
        }
}

template <int rows>
void return_exactly(const Block& block, PackPlace<rows> at, const Tensors<rows>& strain_increment,
                    const Prediction<rows>& prediction) {
    const double root = std::sqrt(2.0 / 3.0), all = block.lost + 2.0 / 3.0 * block.isotropic;
    const Scalars<rows> flowing = prediction.flows.template cast<double>();
    const Tensors<rows> d = 2.0 * block.shear * deviators<rows>(strain_increment);
    const Tensors<rows> before = prediction.relative - d;
    const Scalars<rows> radius = root * prediction.yield_stress;
    const ExactFlow<rows> flow(before, d, radius, prediction.flows, 2.0 / 3.0 * block.isotropic / all);
    const Scalars<rows> dp = flowing * flow.plastic_path() * (root / all);
    const Tensors<rows> plastic = (prediction.relative - flow.relative()).colwise() * (flowing / block.lost);
    const Tensors<rows> stress = prediction.stress - 2.0 * block.shear * plastic;
    write_state<rows>(block.update, at, strain_increment, stress, plastic, dp);
    write_tangent<rows>(block, at, before, d, flow.derivative(), flowing);
}

/// D = C - 2 G theta dev + 2 G (theta - 3 G / (3 G + H + C)) n x n with theta = 3 G dp / equivalent: the derivative of
/// the radial return (Simo and Taylor 1985). Where nothing flows both factors are zero and D is C to the last bit.
template <int rows>
void write_tangent(const Block& block, PackPlace<rows> at, const Tensors<rows>& relative,
                   const Scalars<rows>& per_equivalent, const Scalars<rows>& dp, const Scalars<rows>& flowing) {
    const double two_shear = 2.0 * block.shear;
    const Scalars<rows> theta = 3.0 * block.shear * dp * per_equivalent;
    const Scalars<rows> softening = two_shear * theta;
    const Scalars<rows> along =
        1.5 * two_shear * (theta - 3.0 * block.shear / block.uniaxial * flowing) * per_equivalent * per_equivalent;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j <= i; ++j) {
            const Scalars<rows> value =
                block.update.stiffness(i, j) - deviatoric(i, j) * softening + along * relative.col(i) * relative.col(j);
            at.scalars(block.update.tangent, 4 * i + j) = value;
            at.scalars(block.update.tangent, 4 * j + i) = value;
        }
}

/// Radially: backward Euler (Simo and Taylor 1985).
template <int rows>
void return_at_once(const Block& block, PackPlace<rows> at, const Tensors<rows>& strain_increment,
                    const Prediction<rows>& prediction) {
    const Scalars<rows> flowing = prediction.flows.template cast<double>();
    const Scalars<rows> dp = prediction.flows.select(prediction.overstress / block.uniaxial, 0.0);
    const Scalars<rows> per_equivalent = 1.0 / prediction.flows.select(prediction.equivalent, 1.0);
    const Tensors<rows> plastic = prediction.relative.colwise() * (1.5 * dp * per_equivalent);
    const Tensors<rows> stress = prediction.stress - 2.0 * block.shear * plastic;
    write_state<rows>(block.update, at, strain_increment, stress, plastic, dp);
    write_tangent<rows>(block, at, prediction.relative, per_equivalent * flowing, dp, flowing);
}

}  // namespace

J2::J2(const J2Parameters& parameters)
    : J2Law(parameters), bulk_(parameters.elasticity.bulk_modulus()), shear_(parameters.elasticity.shear_modulus()),
      isotropic_(parameters.isotropic.linear()->modulus), kinematic_(parameters.prager_modulus()),
      uniaxial_(3.0 * shear_ + isotropic_ + kinematic_) {}

void J2::return_points(const J2Update& update, int points, int stride) const {
    const Block block{.update = update,
                      .bulk = bulk_,
                      .shear = shear_,
                      .isotropic = isotropic_,
                      .uniaxial = uniaxial_,
                      .lost = 2.0 * shear_ + 2.0 / 3.0 * kinematic_};
    update_packs(
        update, points, stride,
        [&]<int rows>(PackPlace<rows>, const Tensors<rows>& strain) {
            return elastic_stress<rows>(block.bulk, block.shear, strain);
        },
        [&]<int rows>(PackPlace<rows> at, const Tensors<rows>& strain, const Prediction<rows>& prediction,
                      int substeps) {
            if (substeps > 1)
                return_exactly<rows>(block, at, strain, prediction);
            else
                return_at_once<rows>(block, at, strain, prediction);
        });
}

}  // namespace stria::fine
