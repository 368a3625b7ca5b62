// Numbers of a pack of points with their derivatives by a deviator, so that formulas are written once, as of numbers.
#pragma once

#include <array>

#include "common/index.hpp"
#include "fine/material/implicit/plane_deviators.hpp"

namespace stria::fine {

template <int rows> struct WithSlope {
    Scalars<rows> value;
    Deviators<rows> slope = Deviators<rows>::Zero();

    WithSlope(const Scalars<rows>& constant)
        : value(constant) {}  // NOLINT(google-explicit-constructor): a number is one
    WithSlope(const Scalars<rows>& number, const Deviators<rows>& derivative) : value(number), slope(derivative) {}

    friend WithSlope operator+(const WithSlope& a, const WithSlope& b) {
        return {a.value + b.value, a.slope + b.slope};
    }
    friend WithSlope operator-(const WithSlope& a, const WithSlope& b) {
        return {a.value - b.value, a.slope - b.slope};
    }
    friend WithSlope operator*(const WithSlope& a, const WithSlope& b) {
        return {a.value * b.value, a.slope * b.value + b.slope * a.value};
    }
    friend WithSlope operator/(const WithSlope& a, const WithSlope& b) {
        const Scalars<rows> per_b = 1.0 / b.value, ratio = a.value * per_b;
        return {ratio, (a.slope - b.slope * ratio) * per_b};
    }
    friend WithSlope operator*(double factor, const WithSlope& a) { return {factor * a.value, factor * a.slope}; }

    friend WithSlope sqrt(const WithSlope& a) {
        const Scalars<rows> root = a.value.sqrt();
        return {root, a.slope * (0.5 / root)};
    }
};

/// Where `first` holds a, elsewhere b.
template <int rows>
WithSlope<rows> chosen(const Mask<rows>& first, const WithSlope<rows>& a, const WithSlope<rows>& b) {
    WithSlope<rows> result(first.select(a.value, b.value));
    for (int j = 0; j < 3; ++j) result.slope.col(j) = first.select(a.slope.col(j), b.slope.col(j));
    return result;
}

/// A deviator whose derivative is known.
template <int rows> using DeviatorWithSlope = std::array<WithSlope<rows>, 3>;

template <int rows>
[[nodiscard]] WithSlope<rows> dot(const DeviatorWithSlope<rows>& a, const DeviatorWithSlope<rows>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <int rows>
[[nodiscard]] DeviatorWithSlope<rows> operator*(const WithSlope<rows>& factor, const DeviatorWithSlope<rows>& a) {
    return {factor * a[0], factor * a[1], factor * a[2]};
}

template <int rows>
[[nodiscard]] DeviatorWithSlope<rows> operator+(const DeviatorWithSlope<rows>& a, const DeviatorWithSlope<rows>& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

template <int rows>
[[nodiscard]] DeviatorWithSlope<rows> operator-(const DeviatorWithSlope<rows>& a, const DeviatorWithSlope<rows>& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// Known, and not changing.
template <int rows> [[nodiscard]] DeviatorWithSlope<rows> fixed(const Deviators<rows>& d) {
    return {Scalars<rows>(d.col(0)), Scalars<rows>(d.col(1)), Scalars<rows>(d.col(2))};
}

/// What derivatives are by.
template <int rows> [[nodiscard]] DeviatorWithSlope<rows> varied(const Deviators<rows>& d) {
    DeviatorWithSlope<rows> result = fixed<rows>(d);
    for (int j = 0; j < 3; ++j) result[stria::at(j)].slope.col(j).setOnes();
    return result;
}

}  // namespace stria::fine
