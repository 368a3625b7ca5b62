#include "fine/material/j2.hpp"

#include <numeric>

#include "fine/material/j2_pack.hpp"

namespace stria::fine {

namespace {

struct Block {
    J2Update update;
    double bulk;
    double shear;
    double uniaxial;
};

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
            const double deviatoric = (i == j ? 1.0 : 0.0) - (i < 3 && j < 3 ? 1.0 / 3.0 : 0.0);
            const Scalars<rows> value =
                block.update.stiffness(i, j) - deviatoric * softening + along * relative.col(i) * relative.col(j);
            at.scalars(block.update.tangent, 4 * i + j) = value;
            at.scalars(block.update.tangent, 4 * j + i) = value;
        }
}

template <int rows> void return_to_surface(const Block& block, PackPlace<rows> at) {
    const Tensors<rows> strain_increment = at.tensors(block.update.strain_increment, 0);
    const Prediction<rows> prediction =
        predict<rows>(block.update, at, elastic_stress<rows>(block.bulk, block.shear, strain_increment));
    for (int q = 0; q < rows; ++q) block.update.yielding[at.first + q] = prediction.flows[q];
    if (!prediction.flows.any()) {
        write_elastic<rows>(block.update, at, strain_increment, prediction.stress);
        return;
    }
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
    : parameters_(parameters), bulk_(parameters.elasticity.bulk_modulus()),
      shear_(parameters.elasticity.shear_modulus()),
      uniaxial_(3.0 * shear_ + parameters.isotropic +
                std::accumulate(parameters.kinematic.begin(), parameters.kinematic.end(), 0.0)) {}

void J2::update(int points, int stride, const double* strain_increment, const double* committed, double* trial,
                double* tangent, unsigned char* yielding) const {
    const Block block{.update = {.law = parameters_,
                                 .stiffness = elastic(),
                                 .strain_increment = strain_increment,
                                 .committed = committed,
                                 .trial = trial,
                                 .tangent = tangent,
                                 .yielding = yielding},
                      .bulk = bulk_,
                      .shear = shear_,
                      .uniaxial = uniaxial_};
    for_each_pack<pack_size>(points, stride, [&block]<int rows>(PackPlace<rows> at) { return_to_surface(block, at); });
}

}  // namespace stria::fine
