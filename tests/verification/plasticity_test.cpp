// One material point against closed forms (docs/references.md 6: values worked out independently of this code).
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "common/material/elasticity.hpp"
#include "tests/support/comparison.hpp"
#include "tests/support/material_point.hpp"

namespace stria::test {
namespace {

/// Plane strain with sigma_xx = 0, pulled along yy.
double plane_strain_tension(MaterialPoint& point, double strain) { return point.drive(1, strain, {0}).stress()[1]; }

double angle(const Mandel& a, const Mandel& b) {
    return std::acos(a.dot(b) / (a.norm() * b.norm())) * 180.0 / std::numbers::pi;
}

TEST(Plasticity, MixedHardeningBarSsnv133) {  // Code_Aster V6.04.133
    const std::vector<std::pair<double, double>> history{{2e-3, 400}, {4.5e-3, 500}, {1e-4, -380}, {-2e-3, -464}};
    for (const std::vector<double>& kinematic : {std::vector{30e3}, std::vector{10e3, 20e3}}) {  // a sum, however split
        MaterialPoint bar(linear_hardening(400.0, 20e3, kinematic));
        for (const auto& [strain, stress] : history)
            verify({.scene = fmt::format("bar, mixed hardening, {} back stresses", kinematic.size()),
                    .source = "Code_Aster SSNV133 (6.1)",
                    .quantity = fmt::format("stress at the strain {}, MPa", strain),
                    .reference = stress,
                    .ours = bar.uniaxial(strain),
                    .within = 1e-10});
    }
}

TEST(Plasticity, UniaxialCyclesIsotropicAndKinematic) {
    const double H = 200e3 * 2e3 / (200e3 - 2e3);  // from the tangent modulus 2000 MPa
    MaterialPoint isotropic(linear_hardening(200.0, H));
    MaterialPoint kinematic(linear_hardening(200.0, 0.0, {H}));
    const std::vector<double> stresses{218.0000, -253.6400, 288.5672, -322.7959};
    double strain = 0.01;
    for (const double stress : stresses) {
        const auto row = [&](const std::string& hardening, double reference, double ours, double within) {
            verify({.scene = fmt::format("bar, {} hardening, strain +-0.01", hardening),
                    .source = "closed form (6.2)",
                    .quantity = "stress, MPa",
                    .reference = reference,
                    .ours = ours,
                    .within = within / std::abs(reference)});
        };
        row("isotropic", stress, isotropic.uniaxial(strain), 5.1e-5);
        row("kinematic", std::copysign(218.0, strain), kinematic.uniaxial(strain), 1e-8);
        strain = -strain;
    }
}

TEST(Plasticity, ManySmallIncrementsEqualOneLargeInUniaxialStress) {
    MaterialPoint coarse(linear_hardening(350.0, 1000.0, {4000.0}));
    MaterialPoint fine(linear_hardening(350.0, 1000.0, {4000.0}));
    for (int step = 1; step <= 100; ++step) fine.uniaxial(1e-4 * step);
    EXPECT_NEAR(coarse.uniaxial(1e-2), fine.last().stress()[1], 1e-8);
}

TEST(Plasticity, PlaneStrainTensionFirstYield) {
    const double first_yield = 281.271975;
    const double strain = first_yield * (1.0 - 0.3 * 0.3) / 200e3;
    for (const double sign : {1.0, -1.0}) {
        MaterialPoint below(linear_hardening(250.0));
        MaterialPoint above(linear_hardening(250.0));
        plane_strain_tension(below, sign * strain * (1 - 2e-9));
        EXPECT_FALSE(below.last().yields);
        plane_strain_tension(above, sign * strain * (1 + 2e-9));
        EXPECT_TRUE(above.last().yields);
        verify({.scene = "plane strain tension",
                .source = "closed form (6.6)",
                .quantity = "stress just below yield, MPa",
                .reference = sign * first_yield,
                .ours = below.last().stress()[1],
                .within = 1e-6 / first_yield});
    }
}

TEST(Plasticity, PlaneStrainTensionCollapse) {
    MaterialPoint point(linear_hardening(250.0));
    for (int step = 1; step <= 200; ++step) plane_strain_tension(point, 2e-4 * step);
    verify({.scene = "plane strain tension, perfectly plastic",
            .source = "closed form (6.6)",
            .quantity = "collapse stress, MPa",
            .reference = 288.675135,
            .ours = point.last().stress()[1],
            .within = 1e-6 / 288.675135});
    EXPECT_NEAR(point.last().stress()[2], 0.5 * 288.675135, 1e-6);
}

TEST(Plasticity, PureShearYieldsAndCollapses) {
    MaterialPoint point(linear_hardening(250.0));
    const Mandel shear = Mandel::Unit(3) * 250.0 / std::numbers::sqrt3 * std::numbers::sqrt2 * 1.3 / 200e3;
    point.strain_by(shear * (1.0 - 1e-9));
    EXPECT_FALSE(point.last().yields);
    point.strain_by(shear);
    EXPECT_TRUE(point.last().yields);
    verify({.scene = "pure shear, perfectly plastic",
            .source = "closed form (6.6)",
            .quantity = "collapse stress, MPa",
            .reference = 144.337567,
            .ours = point.last().stress()[3] / std::numbers::sqrt2,
            .within = 1e-6 / 144.337567});
}

struct ReturnError {
    double start;    // degrees between the stress and the strain increment
    double size;     // 2 G |d eps| / radius of the surface
    double degrees;  // radial return minus tan(psi/2) = tan(psi0/2) exp(-x) (Krieg and Krieg 1977)
};

TEST(Plasticity, RadialReturnHasItsKnownError) {
    const Elasticity elasticity{200e3, 0.3};
    const Mandel shear = Mandel::Unit(3);
    const Mandel stretch = Mandel(1.0, -1.0, 0.0, 0.0) / std::numbers::sqrt2;  // deviatoric, orthogonal to the shear
    const double radius = std::sqrt(2.0 / 3.0) * 250.0;
    for (const auto& [start, size, degrees] :
         {ReturnError{90, 0.5, 0.9588}, ReturnError{90, 1, 4.6049}, ReturnError{90, 2, 11.1504},
          ReturnError{90, 3, 12.7345}, ReturnError{135, 1, -15.7191}, ReturnError{45, 1, 5.1718}}) {
        MaterialPoint point(linear_hardening(250.0));
        const double unit = radius / (2.0 * elasticity.shear_modulus());
        point.strain_by(unit * shear);
        const double psi0 = start * std::numbers::pi / 180.0;
        const Mandel direction = std::cos(psi0) * shear + std::sin(psi0) * stretch;
        const double psi = angle(point.strain_by(size * unit * direction).stress(), direction);
        const double exact = 2.0 * std::atan(std::tan(psi0 / 2.0) * std::exp(-size)) * 180.0 / std::numbers::pi;
        verify({.scene = fmt::format("one radial return from {} degrees, x = {}", start, size),
                .source = "Krieg and Krieg 1977 (6.7)",
                .quantity = "its known error, degrees",
                .reference = degrees,
                .ours = psi - exact,
                .within = 5.1e-5 / std::abs(degrees)});
    }
}

}  // namespace
}  // namespace stria::test
