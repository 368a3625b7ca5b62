// Deviators of plane problems by three numbers in an orthonormal basis, so that contractions are dot products: zz with
// what balances it in the plane, xx - yy, and xy. Elasticity and recall are symmetric operators on them.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "fine/material/point_pack.hpp"

namespace stria::fine {

template <int rows> using Mask = Eigen::Array<bool, rows, 1>;

/// A deviator at each point of a pack. Its three numbers lie apart: as columns of one array a product with a number per
/// point is no vector operation to Eigen, and takes three times as long.
template <int rows> class Deviators {
public:
    using Number = Scalars<rows>;

    Deviators() = default;  // not set, as Eigen's
    Deviators(const Number& first, const Number& second, const Number& third) : columns_{first, second, third} {}

    static Deviators Zero() { return {Number::Zero(), Number::Zero(), Number::Zero()}; }
    void setZero() { *this = Zero(); }

    [[nodiscard]] Number& col(int i) { return columns_[static_cast<std::size_t>(i)]; }
    [[nodiscard]] const Number& col(int i) const { return columns_[static_cast<std::size_t>(i)]; }

    Deviators& operator+=(const Deviators& b) {
        for (int i = 0; i < 3; ++i) col(i) += b.col(i);
        return *this;
    }
    Deviators& operator-=(const Deviators& b) {
        for (int i = 0; i < 3; ++i) col(i) -= b.col(i);
        return *this;
    }
    friend Deviators operator+(const Deviators& a, const Deviators& b) {
        return {a.col(0) + b.col(0), a.col(1) + b.col(1), a.col(2) + b.col(2)};
    }
    friend Deviators operator-(const Deviators& a, const Deviators& b) {
        return {a.col(0) - b.col(0), a.col(1) - b.col(1), a.col(2) - b.col(2)};
    }
    friend Deviators operator-(const Deviators& a) { return {-a.col(0), -a.col(1), -a.col(2)}; }
    friend Deviators operator*(const Deviators& a, const Number& factor) {
        return {a.col(0) * factor, a.col(1) * factor, a.col(2) * factor};
    }
    friend Deviators operator*(double factor, const Deviators& a) {
        return {factor * a.col(0), factor * a.col(1), factor * a.col(2)};
    }
    /// Number by number.
    friend Deviators operator*(const Deviators& a, const Deviators& b) {
        return {a.col(0) * b.col(0), a.col(1) * b.col(1), a.col(2) * b.col(2)};
    }

private:
    std::array<Number, 3> columns_;
};

/// Rows: the basis in Mandel form.
inline Eigen::Matrix<double, 3, 4> deviator_basis() {
    Eigen::Matrix<double, 3, 4> basis;
    basis.row(0) = Eigen::RowVector4d(-1.0, -1.0, 2.0, 0.0) / std::sqrt(6.0);
    basis.row(1) = Eigen::RowVector4d(1.0, -1.0, 0.0, 0.0) / std::numbers::sqrt2;
    basis.row(2) = Eigen::RowVector4d(0.0, 0.0, 0.0, 1.0);
    return basis;
}

/// Of the deviatoric part of each tensor.
template <int rows> [[nodiscard]] inline Deviators<rows> deviators_of(const Tensors<rows>& t) {
    Deviators<rows> d;
    d.col(0) = (2.0 * t.col(2) - t.col(0) - t.col(1)) * (1.0 / std::sqrt(6.0));
    d.col(1) = (t.col(0) - t.col(1)) * (0.5 * std::numbers::sqrt2);
    d.col(2) = t.col(3);
    return d;
}

template <int rows> [[nodiscard]] inline Tensors<rows> tensors_of(const Deviators<rows>& d) {
    const Scalars<rows> zz = std::sqrt(2.0 / 3.0) * d.col(0), half_difference = 0.5 * std::numbers::sqrt2 * d.col(1);
    Tensors<rows> t;
    t.col(0) = -0.5 * zz + half_difference;
    t.col(1) = -0.5 * zz - half_difference;
    t.col(2) = zz;
    t.col(3) = d.col(2);
    return t;
}

template <int rows> [[nodiscard]] inline Scalars<rows> dot(const Deviators<rows>& a, const Deviators<rows>& b) {
    return a.col(0) * b.col(0) + a.col(1) * b.col(1) + a.col(2) * b.col(2);
}

/// sqrt(3/2) |d|.
template <int rows> [[nodiscard]] inline Scalars<rows> equivalent(const Deviators<rows>& d) {
    return (1.5 * dot<rows>(d, d)).sqrt();
}

/// A symmetric operator on the deviators of each point: diagonal, unless something is added across a direction.
template <int rows> class DeviatorOperator {
public:
    explicit DeviatorOperator(const Eigen::Array3d& diagonal = Eigen::Array3d::Zero()) {
        for (int i = 0; i < 3; ++i) diagonal_.col(i).setConstant(diagonal[i]);
    }

    /// Adds factor 1.
    void add(const Scalars<rows>& factor) {
        for (int i = 0; i < 3; ++i) diagonal_.col(i) += factor;
    }
    /// Adds factor (1 - n x n).
    void add_across(const Scalars<rows>& factor, const Deviators<rows>& n) {
        if (!mixes_) mixed_.setZero();
        mixes_ = true;
        const Deviators<rows> scaled = n * factor;
        add(factor);
        diagonal_ -= scaled * n;
        mixed_.col(0) -= scaled.col(0) * n.col(1);
        mixed_.col(1) -= scaled.col(0) * n.col(2);
        mixed_.col(2) -= scaled.col(1) * n.col(2);
    }

    [[nodiscard]] Deviators<rows> operator*(const Deviators<rows>& d) const {
        Deviators<rows> result = diagonal_ * d;
        if (!mixes_) return result;
        result.col(0) += mixed_.col(0) * d.col(1) + mixed_.col(1) * d.col(2);
        result.col(1) += mixed_.col(0) * d.col(0) + mixed_.col(2) * d.col(2);
        result.col(2) += mixed_.col(1) * d.col(0) + mixed_.col(2) * d.col(1);
        return result;
    }

private:
    template <int> friend class EasedBy;

    Deviators<rows> diagonal_, mixed_;  // mixed: 01, 02, 12
    bool mixes_ = false;
};

/// The inverse of 1 + lambda K for lambda >= 0 and a K without negative eigenvalues, by its factors L D L^T.
template <int rows> class EasedBy {
public:
    EasedBy() = default;
    EasedBy(const Scalars<rows>& lambda, const DeviatorOperator<rows>& K) : mixes_(K.mixes_) {
        const Deviators<rows> more = K.diagonal_ * lambda;
        if (!mixes_) {
            for (int i = 0; i < 3; ++i) per_pivot_.col(i) = 1.0 / (1.0 + more.col(i));
            return;
        }
        const Deviators<rows> mixed = K.mixed_ * lambda;
        per_pivot_.col(0) = 1.0 / (1.0 + more.col(0));
        lower_.col(0) = mixed.col(0) * per_pivot_.col(0);
        lower_.col(1) = mixed.col(1) * per_pivot_.col(0);
        per_pivot_.col(1) = 1.0 / (1.0 + more.col(1) - lower_.col(0) * mixed.col(0));
        const Scalars<rows> left = mixed.col(2) - lower_.col(1) * mixed.col(0);
        lower_.col(2) = left * per_pivot_.col(1);
        per_pivot_.col(2) = 1.0 / (1.0 + more.col(2) - lower_.col(1) * mixed.col(1) - lower_.col(2) * left);
    }

    [[nodiscard]] Deviators<rows> operator()(const Deviators<rows>& d) const {
        if (!mixes_) return d * per_pivot_;
        Deviators<rows> x = d;
        x.col(1) -= lower_.col(0) * x.col(0);
        x.col(2) -= lower_.col(1) * x.col(0) + lower_.col(2) * x.col(1);
        x = x * per_pivot_;
        x.col(1) -= lower_.col(2) * x.col(2);
        x.col(0) -= lower_.col(0) * x.col(1) + lower_.col(1) * x.col(2);
        return x;
    }

private:
    Deviators<rows> per_pivot_, lower_;  // lower: 10, 20, 21
    bool mixes_ = false;
};

}  // namespace stria::fine
