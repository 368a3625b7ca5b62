// B and B^T at an integration point with its mean dilatation, whatever the number of functions (docs/method.md, section
// 3). g, mean: one row per function, 1/mm; nodal: one column per function. `mean` null: nothing keeps a volume.
#pragma once

#include <Eigen/LU>

#include "common/mandel.hpp"

namespace stria {

/// zz is the assumed part of a mean dilatation.
template <class Nodal, class Gradient> Mandel strain_at(const Nodal& nodal, const Gradient& g, const Gradient* mean) {
    const Eigen::Matrix2d local = nodal * g;
    if (mean == nullptr) return strain_of(local);
    const double dilatation = nodal.cwiseProduct(mean->transpose()).sum();
    return strain_of(local) + (dilatation - local.trace()) / 3.0 * mandel_identity;
}

/// B is 4 x 2f, component fastest.
template <class Gradient, class Matrix> void fill_strain_matrix(const Gradient& g, const Gradient* mean, Matrix& B) {
    const Gradient& m = mean == nullptr ? g : *mean;
    for (Eigen::Index f = 0; f < g.rows(); ++f) {
        const double dx = (m(f, 0) - g(f, 0)) / 3.0, dy = (m(f, 1) - g(f, 1)) / 3.0;
        B.col(2 * f) << g(f, 0) + dx, dx, dx, g(f, 1) / std::numbers::sqrt2;
        B.col(2 * f + 1) << dy, g(f, 1) + dy, dy, g(f, 0) / std::numbers::sqrt2;
    }
}

/// Adds weight * B^T stress.
template <class Gradient, class Nodal>
void add_force_at(const Mandel& stress, double weight, const Gradient& g, const Gradient* mean, Nodal& nodal) {
    const double pressure = mean == nullptr ? 0.0 : trace(stress) / 3.0;
    const Eigen::Matrix2d weighted = weight * (in_plane(stress) - pressure * Eigen::Matrix2d::Identity());
    nodal += weighted * g.transpose();
    if (mean != nullptr) nodal += weight * pressure * mean->transpose();
}

}  // namespace stria
