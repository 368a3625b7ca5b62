// Isotropic hardening: what the accumulated plastic strain p adds to the yield stress.
#pragma once

#include <variant>
#include <vector>

#include "common/case/case.hpp"
#include "fine/material/point_pack.hpp"

namespace stria::fine {

/// R = H p.
struct LinearCurve {
    double modulus;  // MPa
};

/// R = Q (1 - exp(-b p)). E. Voce, J. Inst. Metals 74 (1948) 537.
struct VoceCurve {
    double Q;  // MPa
    double b;
};

/// sigma = reference ((p + offset) / scale)^(1/n): the curve p = scale (sigma / reference)^n of Ramberg and Osgood,
/// NACA TN 902 (1943), scale = alpha reference / E, from the yield stress upward.
struct PowerCurve {
    double reference, yield_stress;  // MPa
    double n, scale, offset;
};

/// Straight lines between points, the last stress beyond them.
struct TableCurve {
    std::vector<double> p, R;  // MPa; from (0, 0) on
};

/// R(p) and dR/dp, MPa.
template <class P> struct HardeningAt { P value, slope; };

class HardeningCurve {
public:
    HardeningCurve(LinearCurve curve = {0.0}) : curve_(curve) {}  // NOLINT(google-explicit-constructor)
    /// Of a case, whose schema has checked the parameters.
    HardeningCurve(const MaterialSection& material);  // NOLINT(google-explicit-constructor)

    /// R(p), MPa, of a number or of a pack of points.
    template <class P> [[nodiscard]] P value(const P& p) const {
        if (const LinearCurve* line = linear()) return line->modulus * p;
        return at(p).value;
    }
    /// dR/dp, MPa.
    template <class P> [[nodiscard]] P slope(const P& p) const { return at(p).slope; }
    /// Both together: what is dear in them is computed once.
    template <class P> [[nodiscard]] HardeningAt<P> at(const P& p) const;
    /// Integral of R from 0 to p, N/mm2: what isotropic hardening stores.
    [[nodiscard]] double stored(double p) const;

    /// The modulus of a linear curve; null for others.
    [[nodiscard]] const LinearCurve* linear() const { return std::get_if<LinearCurve>(&curve_); }

private:
    std::variant<LinearCurve, VoceCurve, PowerCurve, TableCurve> curve_;
};

}  // namespace stria::fine
