#include "coarse/specimen/handbook.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace stria::coarse {
namespace {

using std::numbers::pi;
using Polynomial = std::array<double, 6>;

/// Yield stress in tension under plane strain over the uniaxial one (von Mises).
const double plane_strain_constraint = 2.0 / std::sqrt(3.0);

// Saxena and Hudak, Int. J. Fracture 14 (1978) 453; the argument is u = 1 / (sqrt(C) + 1).
constexpr Polynomial load_line{1.000196, -4.06319, 11.242, -106.043, 464.335, -650.677};
constexpr Polynomial front_face{1.001, -4.6695, 18.46, -236.82, 1214.9, -2143.6};

double value_of(const Polynomial& polynomial, double u) {
    double sum = 0.0;
    for (std::size_t k = polynomial.size(); k-- > 0;) sum = sum * u + polynomial[k];
    return sum;
}

double crack_length(const Polynomial& polynomial, double C) { return value_of(polynomial, 1.0 / (std::sqrt(C) + 1.0)); }

/// Crack length grows with compliance: bisection over all that the polynomials are made for.
double compliance(const Polynomial& polynomial, double x) {
    double low = 5.0, high = 1e6;
    while (high - low > 1e-12 * high) {
        const double middle = 0.5 * (low + high);
        (crack_length(polynomial, middle) < x ? low : high) = middle;
        if (middle == low && middle == high) break;
    }
    return 0.5 * (low + high);
}

double in_tension(double F, double width, double a, double load) { return F * load / width * std::sqrt(pi * a); }

}  // namespace

double sent_factor(double x) {
    const double half_angle = 0.5 * pi * x;
    const double polynomial = 0.752 + 2.02 * x + 0.37 * std::pow(1.0 - std::sin(half_angle), 3);
    return std::sqrt(std::tan(half_angle) / half_angle) * polynomial / std::cos(half_angle);
}

double mt_factor(double x) { return (1.0 - 0.025 * x * x + 0.06 * std::pow(x, 4)) / std::sqrt(std::cos(0.5 * pi * x)); }

double ct_factor(double x) {
    const double polynomial = 0.886 + 4.64 * x - 13.32 * x * x + 14.72 * std::pow(x, 3) - 5.6 * std::pow(x, 4);
    return (2.0 + x) / std::pow(1.0 - x, 1.5) * polynomial;
}

double sent_K(double width, double a, double load) { return in_tension(sent_factor(a / width), width, a, load); }
double mt_K(double width, double a, double load) { return in_tension(mt_factor(2.0 * a / width), width, a, load); }
double ct_K(double width, double a, double load) { return load * ct_factor(a / width) / std::sqrt(width); }

double ct_load_line_compliance(double x) { return compliance(load_line, x); }
double ct_front_face_compliance(double x) { return compliance(front_face, x); }

double sent_limit_load(double width, double a, double yield_stress, PlaneState plane) {
    const double x = a / width, ligament = 1.0 - x;
    if (plane == PlaneState::Stress) {
        const double ratio = x / ligament;
        return 1.072 * (std::sqrt(1.0 + ratio * ratio) - ratio) * ligament * width * yield_stress;
    }
    double share = ligament - 1.232 * x * x + x * x * x;
    if (x > 0.545) {
        const double shift = 0.794 - ligament;
        share = 1.702 * (std::sqrt(shift * shift + 0.5876 * ligament * ligament) - shift);
    }
    return plane_strain_constraint * share * width * yield_stress;
}

double mt_limit_load(double width, double a, double yield_stress, PlaneState plane) {
    const double constraint = plane == PlaneState::Strain ? plane_strain_constraint : 1.0;
    return constraint * (width - 2.0 * a) * yield_stress;
}

double ct_limit_load(double width, double a, double yield_stress, PlaneState plane) {
    const double x = a / width;
    const bool strain = plane == PlaneState::Strain;
    const double rho = strain ? 1.702 : plane_strain_constraint;
    const double share = std::sqrt((1.0 + rho) * (1.0 + rho * x * x)) - (1.0 + rho * x);
    return (strain ? plane_strain_constraint : 1.0) * share * width * yield_stress;
}

}  // namespace stria::coarse
