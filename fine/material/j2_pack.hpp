// What the J2 laws of plane strain and plane stress share: prediction, yield function and state of a pack of points.
#pragma once

#include <cmath>

#include "common/error.hpp"
#include "fine/material/j2_parameters.hpp"
#include "fine/material/point_pack.hpp"

namespace stria::fine {

/// One update: what all its packs have in common.
struct J2Update {
    const J2Parameters& law;
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
    Tensors<rows> relative;      // dev(stress) - X
    Scalars<rows> equivalent;    // sqrt(3/2) |relative|
    Scalars<rows> yield_stress;  // sigma_y + R
    Scalars<rows> overstress;    // equivalent - yield_stress
    Eigen::Array<bool, rows, 1> flows;
};

/// `elastic`: what the stress changes by without flow. Throws NumericalFailure where it is not finite.
template <int rows> Prediction<rows> predict(const J2Update& update, PackPlace<rows> at, const Tensors<rows>& elastic) {
    Prediction<rows> prediction;
    prediction.stress = at.tensors(update.committed, state::stress) + elastic;
    prediction.relative = deviators<rows>(prediction.stress);
    for (std::size_t k = 0; k < update.law.kinematic.size(); ++k)
        prediction.relative -= at.tensors(update.committed, state::back_stress + 4 * static_cast<int>(k));
    prediction.equivalent = (1.5 * contraction<rows>(prediction.relative, prediction.relative)).sqrt();
    const Scalars<rows> p = at.scalars(update.committed, state::accumulated);
    prediction.yield_stress = update.law.yield_stress + update.law.isotropic.value(p);
    prediction.overstress = prediction.equivalent - prediction.yield_stress;
    prediction.flows = prediction.overstress > overstress_tolerance * prediction.yield_stress;
    if (!std::isfinite(prediction.equivalent.sum()))
        throw NumericalFailure("return mapping: the strain increment is not finite");
    return prediction;
}

/// Writes the trial state, but for back stresses, for an increment of the plastic strain, of p and of the dissipation.
template <int rows>
void write_flow(const J2Update& update, PackPlace<rows> at, const Tensors<rows>& strain_increment,
                const Tensors<rows>& stress, const Tensors<rows>& plastic, const Scalars<rows>& dp,
                const Scalars<rows>& dissipated) {
    const double* before = update.committed;
    double* after = update.trial;
    at.tensors(after, state::stress) = stress;
    at.tensors(after, state::plastic_strain) = at.tensors(before, state::plastic_strain) + plastic;
    at.scalars(after, state::accumulated) = at.scalars(before, state::accumulated) + dp;
    const Tensors<rows> mean_stress = 0.5 * (at.tensors(before, state::stress) + stress);
    at.scalars(after, state::work) = at.scalars(before, state::work) + contraction<rows>(mean_stress, strain_increment);
    at.scalars(after, state::dissipation) = at.scalars(before, state::dissipation) + dissipated;
}

/// Writes the trial state for a plastic strain increment (flow direction times dp) without recall; dp = 0: elastic.
template <int rows>
void write_state(const J2Update& update, PackPlace<rows> at, const Tensors<rows>& strain_increment,
                 const Tensors<rows>& stress, const Tensors<rows>& plastic, const Scalars<rows>& dp) {
    write_flow<rows>(update, at, strain_increment, stress, plastic, dp, update.law.yield_stress * dp);
    for (std::size_t k = 0; k < update.law.kinematic.size(); ++k) {
        const int back_stress = state::back_stress + 4 * static_cast<int>(k);
        at.tensors(update.trial, back_stress) =
            at.tensors(update.committed, back_stress) + 2.0 / 3.0 * update.law.kinematic[k].C * plastic;
    }
}

/// Of a pack in which no point flows.
template <int rows>
void write_elastic(const J2Update& update, PackPlace<rows> at, const Tensors<rows>& strain_increment,
                   const Tensors<rows>& stress) {
    write_state<rows>(update, at, strain_increment, stress, Tensors<rows>::Zero(), Scalars<rows>::Zero());
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) at.scalars(update.tangent, 4 * i + j).setConstant(update.stiffness(i, j));
}

/// Points that flow and that an initial stress holds beyond the yield surface, where no way of an increment begins.
/// They have not flowed yet: later they are on it or within.
template <int rows>
Eigen::Array<bool, rows, 1> begin_outside(const J2Update& update, PackPlace<rows> at,
                                          const Prediction<rows>& prediction) {
    constexpr double rounding = 1e-6;
    const Eigen::Array<bool, rows, 1> first =
        prediction.flows && at.scalars(update.committed, state::accumulated) == 0.0;
    if (!first.any()) return first;
    Tensors<rows> relative = deviators<rows>(at.tensors(update.committed, state::stress));
    for (std::size_t k = 0; k < update.law.kinematic.size(); ++k)
        relative -= at.tensors(update.committed, state::back_stress + 4 * static_cast<int>(k));
    return first && (1.5 * contraction<rows>(relative, relative)).sqrt() > (1.0 + rounding) * prediction.yield_stress;
}

/// Pack by pack: `elastic` tells what the stress changes by without flow, `flow` returns a pack to the yield surface,
/// in so many substeps, and writes its state and tangent. A pack in which nothing flows is written here. What begins
/// outside of the surface returns at once.
template <class Elastic, class Flow>
void update_packs(const J2Update& update, int points, int stride, const Elastic& elastic, const Flow& flow) {
    for_each_pack<pack_size>(points, stride, [&]<int rows>(PackPlace<rows> at) {
        const Tensors<rows> strain_increment = at.tensors(update.strain_increment, 0);
        Prediction<rows> prediction = predict<rows>(update, at, elastic(at, strain_increment));
        for (int q = 0; q < rows; ++q) update.yielding[at.first + q] = prediction.flows[q];
        if (!prediction.flows.any()) {
            write_elastic<rows>(update, at, strain_increment, prediction.stress);
            return;
        }
        const Eigen::Array<bool, rows, 1> outside = begin_outside<rows>(update, at, prediction);
        prediction.flows = prediction.flows && !outside;
        flow(at, strain_increment, prediction, update.law.substeps);
        for (int q = 0; q < rows; ++q) {
            if (!outside[q]) continue;
            const PackPlace<1> point{at.stride, at.first + q};
            const Tensors<1> strain = point.tensors(update.strain_increment, 0);
            flow(point, strain, predict<1>(update, point, elastic(point, strain)), 1);
        }
    });
}

}  // namespace stria::fine
