// Symmetric second-order tensors of plane problems as 4-vectors (xx, yy, zz, sqrt(2) xy): double contractions are dot
// products.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>

namespace stria {

using Mandel = Eigen::Vector4d;
using MandelMatrix = Eigen::Matrix4d;

inline const Mandel mandel_identity{1.0, 1.0, 1.0, 0.0};

inline double trace(const Mandel& t) { return t[0] + t[1] + t[2]; }

inline Mandel deviator(const Mandel& t) { return t - trace(t) / 3.0 * mandel_identity; }

/// von Mises stress sqrt(3/2) |dev t|.
inline double von_mises(const Mandel& t) { return std::sqrt(1.5) * deviator(t).norm(); }

/// In-plane 2 x 2 part of a tensor in Mandel form.
inline Eigen::Matrix2d in_plane(const Mandel& t) {
    const double xy = t[3] / std::numbers::sqrt2;
    return Eigen::Matrix2d{{t[0], xy}, {xy, t[1]}};
}

/// Symmetric part of a displacement gradient (row i, column j: du_i/dx_j); zz is zero: the strain of plane strain,
/// no unknown in plane stress.
inline Mandel strain_of(const Eigen::Matrix2d& gradient) {
    return {gradient(0, 0), gradient(1, 1), 0.0, (gradient(0, 1) + gradient(1, 0)) / std::numbers::sqrt2};
}

}  // namespace stria
