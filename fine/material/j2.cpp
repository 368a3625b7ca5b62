#include "fine/material/j2.hpp"

#include <array>

#include "common/index.hpp"
#include "fine/material/j2_pack.hpp"

namespace stria::fine {

namespace {

struct Block {
    const J2Update& update;
    double bulk;
    double shear;
    double isotropic;
    double kinematic;
    double uniaxial;
};

/// Plastic strain of an increment, its equivalent, and the derivative of the relative stress left by the deviatoric
/// trial stress 2 G dev(d eps) of the whole increment.
template <int rows> struct Flow {
    Tensors<rows> plastic = Tensors<rows>::Zero();
    Scalars<rows> equivalent = Scalars<rows>::Zero();
    std::array<Tensors<rows>, 4> relative;  // [j]: d relative / d trial_j
};

constexpr double deviatoric(int i, int j) { return (i == j ? 1.0 : 0.0) - (i < 3 && j < 3 ? 1.0 / 3.0 : 0.0); }

/// Radial returns one after the other: each turns the flow a little further towards the deviator of the increment, as
/// the exact solution does. The increment starts in the elastic domain or on its surface, which is convex: what flows
/// in a part of it flows in the whole, so `prediction` tells which points these are.
template <int rows>
Flow<rows> flow_in_parts(const Block& block, const Prediction<rows>& prediction,
                         const Tensors<rows>& strain_increment) {
    const int parts = block.update.law.substeps;
    const double isotropic = block.isotropic;
    const double slope = 2.0 * block.shear + 2.0 / 3.0 * block.kinematic;  // relative stress lost per plastic strain
    const Tensors<rows> part = 2.0 * block.shear * deviators<rows>(strain_increment) / parts;
    Tensors<rows> relative = prediction.relative - parts * part;
    Flow<rows> flow;
    for (Tensors<rows>& derivative : flow.relative) derivative.setZero();
    Tensors<rows> dp_derivative = Tensors<rows>::Zero();  // d equivalent / d trial_j
    for (int k = 0; k < parts; ++k) {
        relative += part;
        const Scalars<rows> equivalent = (1.5 * contraction<rows>(relative, relative)).sqrt();
        const Scalars<rows> overstress = equivalent - prediction.yield_stress - isotropic * flow.equivalent;
        const auto flows = (prediction.flows && overstress > 0.0).eval();
        const Scalars<rows> flowing = flows.template cast<double>();
        const Scalars<rows> per_equivalent = flowing / flows.select(equivalent, 1.0);
        const Scalars<rows> dp = flowing * overstress / block.uniaxial;
        const Tensors<rows> direction = relative.colwise() * (1.5 * per_equivalent);
        for (int j = 0; j < 4; ++j) {
            Tensors<rows>& derivative = flow.relative[at(j)];
            for (int i = 0; i < 4; ++i) derivative.col(i) += deviatoric(i, j) / parts;
            const Scalars<rows> dq = contraction<rows>(direction, derivative);
            const Scalars<rows> ddp = (dq - flowing * isotropic * dp_derivative.col(j)) / block.uniaxial;
            derivative -= slope * (derivative.colwise() * (1.5 * dp * per_equivalent) +
                                   direction.colwise() * (ddp - dp * per_equivalent * dq));
            dp_derivative.col(j) += ddp;
        }
        const Tensors<rows> plastic = direction.colwise() * dp;
        relative -= slope * plastic;
        flow.plastic += plastic;
        flow.equivalent += dp;
    }
    return flow;
}

/// D = C - 2 G d(eps_p)/d eps, where the relative stress left tells the plastic strain. As long as the flow does not
/// turn D is symmetric; what it is not otherwise is left out: it would make every front of the zone unsymmetric.
template <int rows> void write_tangent(const Block& block, PackPlace<rows> at, const Flow<rows>& flow) {
    const double factor = 4.0 * block.shear * block.shear / (2.0 * block.shear + 2.0 / 3.0 * block.kinematic);
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j <= i; ++j) {
            const Scalars<rows> left = 0.5 * (flow.relative[stria::at(j)].col(i) + flow.relative[stria::at(i)].col(j));
            const Scalars<rows> value = block.update.stiffness(i, j) - factor * (deviatoric(i, j) - left);
            at.scalars(block.update.tangent, 4 * i + j) = value;
            at.scalars(block.update.tangent, 4 * j + i) = value;
        }
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

template <int rows>
void return_to_surface(const Block& block, PackPlace<rows> at, const Tensors<rows>& strain_increment,
                       const Prediction<rows>& prediction) {
    if (block.update.law.substeps > 1) {
        const Flow<rows> flow = flow_in_parts<rows>(block, prediction, strain_increment);
        const Tensors<rows> stress = prediction.stress - 2.0 * block.shear * flow.plastic;
        write_state<rows>(block.update, at, strain_increment, stress, flow.plastic, flow.equivalent);
        write_tangent<rows>(block, at, flow);
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
    : J2Law(parameters), bulk_(parameters.elasticity.bulk_modulus()), shear_(parameters.elasticity.shear_modulus()),
      isotropic_(parameters.isotropic.linear()->modulus), kinematic_(parameters.prager_modulus()),
      uniaxial_(3.0 * shear_ + isotropic_ + kinematic_) {}

void J2::return_points(const J2Update& update, int points, int stride) const {
    const Block block{.update = update,
                      .bulk = bulk_,
                      .shear = shear_,
                      .isotropic = isotropic_,
                      .kinematic = kinematic_,
                      .uniaxial = uniaxial_};
    update_packs(
        update, points, stride,
        [&]<int rows>(PackPlace<rows>, const Tensors<rows>& strain) {
            return elastic_stress<rows>(block.bulk, block.shear, strain);
        },
        [&]<int rows>(PackPlace<rows> at, const Tensors<rows>& strain, const Prediction<rows>& prediction) {
            return_to_surface<rows>(block, at, strain, prediction);
        });
}

}  // namespace stria::fine
