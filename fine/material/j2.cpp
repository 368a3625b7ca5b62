#include "fine/material/j2.hpp"

#include <cmath>
#include <numeric>

#include "common/error.hpp"
#include "fine/material/point_pack.hpp"

namespace stria::fine {

namespace {

/// The return leaves a point on the yield surface up to rounding, and an increment of nothing must not make it flow: a
/// point flows where its overstress exceeds this fraction of the yield stress, far above rounding and below any
/// tolerance.
constexpr double overstress_tolerance = 1e-10;

/// Points handled together: 4 is fastest with the registers of plain x86-64 (bench/return_mapping.cpp; 2 and 8 tried).
constexpr int pack_size = 4;

/// What every pack of one call has in common.
struct Block {
    const J2Parameters& law;
    double bulk;
    double shear;
    double uniaxial;
    MandelMatrix stiffness;
    const double* strain_increment;
    const double* committed;
    double* trial;
    double* tangent;
    unsigned char* yielding;
};

/// The increment taken as elastic.
template <int rows> struct Prediction {
    Tensors<rows> stress;
    Tensors<rows> relative;    // dev(stress) - X
    Scalars<rows> equivalent;  // sqrt(3/2) |relative|
    Scalars<rows> overstress;  // equivalent - (sigma_y + R)
    Eigen::Array<bool, rows, 1> flows;
};

template <int rows>
Prediction<rows> predict(const Block& block, PackPlace<rows> at, const Tensors<rows>& strain_increment) {
    Prediction<rows> prediction;
    prediction.stress =
        at.tensors(block.committed, state::stress) + elastic_stress<rows>(block.bulk, block.shear, strain_increment);
    prediction.relative = deviators<rows>(prediction.stress);
    for (std::size_t k = 0; k < block.law.kinematic.size(); ++k)
        prediction.relative -= at.tensors(block.committed, state::back_stress + 4 * static_cast<int>(k));
    prediction.equivalent = (1.5 * contraction<rows>(prediction.relative, prediction.relative)).sqrt();
    const Scalars<rows> yield_stress =
        block.law.yield_stress + block.law.isotropic * at.scalars(block.committed, state::accumulated);
    prediction.overstress = prediction.equivalent - yield_stress;
    prediction.flows = prediction.overstress > overstress_tolerance * yield_stress;
    return prediction;
}

/// Writes the trial state for a plastic strain increment (flow direction times dp); dp = 0: elastic.
template <int rows>
void write_state(const Block& block, PackPlace<rows> at, const Tensors<rows>& strain_increment,
                 const Tensors<rows>& stress, const Tensors<rows>& plastic, const Scalars<rows>& dp) {
    const double* before = block.committed;
    double* after = block.trial;
    at.tensors(after, state::stress) = stress;
    at.tensors(after, state::plastic_strain) = at.tensors(before, state::plastic_strain) + plastic;
    at.scalars(after, state::accumulated) = at.scalars(before, state::accumulated) + dp;
    const Tensors<rows> mean_stress = 0.5 * (at.tensors(before, state::stress) + stress);
    at.scalars(after, state::work) = at.scalars(before, state::work) + contraction<rows>(mean_stress, strain_increment);
    at.scalars(after, state::dissipation) = at.scalars(before, state::dissipation) + block.law.yield_stress * dp;
    for (std::size_t k = 0; k < block.law.kinematic.size(); ++k) {
        const int back_stress = state::back_stress + 4 * static_cast<int>(k);
        at.tensors(after, back_stress) = at.tensors(before, back_stress) + 2.0 / 3.0 * block.law.kinematic[k] * plastic;
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
            const double deviatoric = (i == j ? 1.0 : 0.0) - (i < 3 && j < 3 ? 1.0 / 3.0 : 0.0);
            const Scalars<rows> value =
                block.stiffness(i, j) - deviatoric * softening + along * relative.col(i) * relative.col(j);
            at.scalars(block.tangent, 4 * i + j) = value;
            at.scalars(block.tangent, 4 * j + i) = value;
        }
}

template <int rows> void write_elastic_tangent(const Block& block, PackPlace<rows> at) {
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) at.scalars(block.tangent, 4 * i + j).setConstant(block.stiffness(i, j));
}

template <int rows> void return_to_surface(const Block& block, PackPlace<rows> at) {
    const Tensors<rows> strain_increment = at.tensors(block.strain_increment, 0);
    const Prediction<rows> prediction = predict<rows>(block, at, strain_increment);
    if (!std::isfinite(prediction.equivalent.sum()))
        throw NumericalFailure("return mapping: the strain increment is not finite");

    for (int q = 0; q < rows; ++q) block.yielding[at.first + q] = prediction.flows[q];
    if (!prediction.flows.any()) {
        write_state<rows>(block, at, strain_increment, prediction.stress, Tensors<rows>::Zero(), Scalars<rows>::Zero());
        write_elastic_tangent<rows>(block, at);
        return;
    }
    const Scalars<rows> flowing = prediction.flows.template cast<double>();
    const Scalars<rows> dp = prediction.flows.select(prediction.overstress / block.uniaxial, 0.0);
    const Scalars<rows> per_equivalent = 1.0 / prediction.flows.select(prediction.equivalent, 1.0);
    const Tensors<rows> plastic = prediction.relative.colwise() * (1.5 * dp * per_equivalent);
    const Tensors<rows> stress = prediction.stress - 2.0 * block.shear * plastic;
    write_state<rows>(block, at, strain_increment, stress, plastic, dp);
    write_tangent<rows>(block, at, prediction.relative, per_equivalent * flowing, dp, flowing);
}

}  // namespace

J2::J2(const J2Parameters& parameters)
    : parameters_(parameters), bulk_(parameters.elasticity.bulk_modulus()),
      shear_(parameters.elasticity.shear_modulus()),
      uniaxial_(3.0 * shear_ + parameters.isotropic +
                std::accumulate(parameters.kinematic.begin(), parameters.kinematic.end(), 0.0)) {}

int J2::state_size() const { return state::back_stress + 4 * static_cast<int>(parameters_.kinematic.size()); }

void J2::update(int points, int stride, const double* strain_increment, const double* committed, double* trial,
                double* tangent, unsigned char* yielding) const {
    const Block block{.law = parameters_,
                      .bulk = bulk_,
                      .shear = shear_,
                      .uniaxial = uniaxial_,
                      .stiffness = elastic(),
                      .strain_increment = strain_increment,
                      .committed = committed,
                      .trial = trial,
                      .tangent = tangent,
                      .yielding = yielding};
    for_each_pack<pack_size>(points, stride, [&block]<int rows>(PackPlace<rows> at) { return_to_surface(block, at); });
}

}  // namespace stria::fine
