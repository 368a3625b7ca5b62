#include "fine/material/hardening_curve.hpp"

#include <algorithm>
#include <cmath>

#include "common/index.hpp"

namespace stria::fine {
namespace {

// Of each law R and its slope, and the integral of R from 0 on.

HardeningAt<double> at_of(const LinearCurve& c, double p) { return {c.modulus * p, c.modulus}; }
double stored_of(const LinearCurve& c, double p) { return 0.5 * c.modulus * p * p; }

HardeningAt<double> at_of(const VoceCurve& c, double p) {
    const double lost = -std::expm1(-c.b * p);
    return {c.Q * lost, c.Q * c.b * (1.0 - lost)};
}
double stored_of(const VoceCurve& c, double p) { return c.Q * (p + std::expm1(-c.b * p) / c.b); }

double stress_of(const PowerCurve& c, double p) { return c.reference * std::pow((p + c.offset) / c.scale, 1.0 / c.n); }
HardeningAt<double> at_of(const PowerCurve& c, double p) {
    const double stress = stress_of(c, p);
    return {stress - c.yield_stress, stress / (c.n * (p + c.offset))};
}
double stored_of(const PowerCurve& c, double p) {
    const auto area = [&](double at) { return stress_of(c, at) * (at + c.offset) * c.n / (c.n + 1.0); };
    return area(p) - area(0.0) - c.yield_stress * p;
}

/// The segment that holds p: its first point. The last point: none.
std::size_t segment(const TableCurve& c, double p) { return at(std::ranges::upper_bound(c.p, p) - c.p.begin()) - 1; }
HardeningAt<double> at_of(const TableCurve& c, double p) {
    const std::size_t k = segment(c, p);
    const double slope = k + 1 < c.p.size() ? (c.R[k + 1] - c.R[k]) / (c.p[k + 1] - c.p[k]) : 0.0;
    return {c.R[k] + slope * (p - c.p[k]), slope};
}
double stored_of(const TableCurve& c, double p) {
    double area = 0.0;
    for (std::size_t k = 0; k <= segment(c, p); ++k) {
        const double end = k < segment(c, p) ? c.p[k + 1] : p;
        area += 0.5 * (c.R[k] + at_of(c, end).value) * (end - c.p[k]);
    }
    return area;
}

PowerCurve power(const MaterialSection& material) {
    const IsotropicHardening& given = material.isotropic;
    const double yield_stress = *material.yield_stress, reference = given.reference.value_or(yield_stress);
    const double scale = given.alpha * reference / material.young;
    return {reference, yield_stress, given.n, scale, scale * std::pow(yield_stress / reference, given.n)};
}

TableCurve table(const MaterialSection& material) {
    TableCurve curve{material.isotropic.plastic_strain, material.isotropic.stress};
    for (double& stress : curve.R) stress -= *material.yield_stress;
    return curve;
}

}  // namespace

HardeningCurve::HardeningCurve(const MaterialSection& material) {
    const IsotropicHardening& given = material.isotropic;
    switch (given.law) {
    case HardeningLaw::Linear:
        curve_ = LinearCurve{given.modulus};
        break;
    case HardeningLaw::Voce:
        curve_ = VoceCurve{given.Q, given.b};
        break;
    case HardeningLaw::Power:
        curve_ = power(material);
        break;
    case HardeningLaw::Table:
        curve_ = table(material);
        break;
    }
}

template <class P> HardeningAt<P> HardeningCurve::at(const P& p) const {
    return std::visit(
        [&](const auto& curve) {
            if constexpr (std::is_same_v<P, double>) {
                return at_of(curve, p);
            } else {
                HardeningAt<P> result;
                for (int q = 0; q < p.size(); ++q) {
                    const HardeningAt<double> each = at_of(curve, p[q]);
                    result.value[q] = each.value;
                    result.slope[q] = each.slope;
                }
                return result;
            }
        },
        curve_);
}

double HardeningCurve::stored(double p) const {
    return std::visit([&](const auto& curve) { return stored_of(curve, p); }, curve_);
}

template HardeningAt<double> HardeningCurve::at(const double&) const;
template HardeningAt<Scalars<1>> HardeningCurve::at(const Scalars<1>&) const;
template HardeningAt<Scalars<pack_size>> HardeningCurve::at(const Scalars<pack_size>&) const;

}  // namespace stria::fine
