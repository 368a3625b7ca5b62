// A pack of neighbouring points as one small array, a row per point and a column per component: laws are written once,
// as for one point, and the compiler gives each row a lane of its vector registers.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <type_traits>

namespace stria::fine {

/// Points handled together: 4 is fastest with the registers of plain x86-64 (bench/return_mapping.cpp; 2 and 8 tried).
inline constexpr int pack_size = 4;

template <int rows> using Scalars = Eigen::Array<double, rows, 1>;

template <int rows> using Tensors = Eigen::Array<double, rows, 4>;

/// The places of one pack in fields stored component by component with `stride`, from point `first` on.
template <int rows> struct PackPlace {
    std::ptrdiff_t stride;
    std::ptrdiff_t first;

    [[nodiscard]] auto scalars(const double* field, int component) const {
        return Eigen::Map<const Scalars<rows>>(field + component * stride + first);
    }
    // NOLINTNEXTLINE(readability-non-const-parameter): the map writes through it
    [[nodiscard]] auto scalars(double* field, int component) const {
        return Eigen::Map<Scalars<rows>>(field + component * stride + first);
    }
    [[nodiscard]] auto tensors(const double* field, int component) const {
        return Eigen::Map<const Tensors<rows>, 0, Steps>(field + component * stride + first, Steps(stride));
    }
    // NOLINTNEXTLINE(readability-non-const-parameter): the map writes through it
    [[nodiscard]] auto tensors(double* field, int component) const {
        return Eigen::Map<Tensors<rows>, 0, Steps>(field + component * stride + first, Steps(stride));
    }

private:
    /// Eigen stores a single row row-major: its columns then are the inner direction.
    using Steps = std::conditional_t<rows == 1, Eigen::InnerStride<>, Eigen::OuterStride<>>;
};

/// C : eps for every point of a pack, C = K 1 x 1 + 2 G dev.
template <int rows>
[[nodiscard]] inline Tensors<rows> elastic_stress(double bulk, double shear, const Tensors<rows>& strain) {
    Tensors<rows> stress = 2.0 * shear * strain;
    const Scalars<rows> pressure = (bulk - 2.0 / 3.0 * shear) * (strain.col(0) + strain.col(1) + strain.col(2));
    for (int i = 0; i < 3; ++i) stress.col(i) += pressure;
    return stress;
}

template <int rows> [[nodiscard]] inline Scalars<rows> contraction(const Tensors<rows>& a, const Tensors<rows>& b) {
    return a.col(0) * b.col(0) + a.col(1) * b.col(1) + a.col(2) * b.col(2) + a.col(3) * b.col(3);
}

template <int rows> [[nodiscard]] inline Tensors<rows> deviators(const Tensors<rows>& t) {
    Tensors<rows> deviator = t;
    const Scalars<rows> mean = (t.col(0) + t.col(1) + t.col(2)) / 3.0;
    for (int i = 0; i < 3; ++i) deviator.col(i) -= mean;
    return deviator;
}

/// Calls `pack` with a PackPlace over all points, whole packs first and the rest one by one.
template <int rows, class Pack> void for_each_pack(int points, int stride, const Pack& pack) {
    const int whole = points - points % rows;
    for (int q = 0; q < whole; q += rows) pack(PackPlace<rows>{stride, q});
    for (int q = whole; q < points; ++q) pack(PackPlace<1>{stride, q});
}

}  // namespace stria::fine
