// J of a compact specimen of a power-law material beyond its limit load against the scheme of the EPRI handbook
// (docs/references.md 3.2).
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "coarse/specimen/handbook.hpp"
#include "tests/support/comparison.hpp"
#include "tests/support/mesh_convergence.hpp"
#include "tests/support/sent_analysis.hpp"
#include "tests/support/specimens.hpp"

namespace stria::test {
namespace {

constexpr double sigma_0 = 400.0, half = 0.5;  // MPa; crack length and ligament of W = 1 mm

/// Ramberg and Osgood's law with alpha = 1, plane strain, a/W = 1/2. J of the elastic crack that is longer by a share
/// of its plastic zone, and the fully plastic J = eps_0 sigma_0 b h_1 (P / P_0)^(n + 1).
struct Epri {
    double n, h1, h1_of_handbook;

    [[nodiscard]] static double P_0() {
        const double s = 2.0 * half / half, eta = std::sqrt(s * s + 2.0 * s + 2.0) - (s + 1.0);
        return 1.455 * eta * half * sigma_0;
    }
    [[nodiscard]] double J(double load, bool with_zone = true) const {  // P / P_0
        const double P = load * P_0(), K = P * coarse::ct_factor(half);
        const double r_y = (n - 1.0) / (n + 1.0) * std::pow(K / sigma_0, 2) / (6.0 * std::numbers::pi);
        const double longer = with_zone ? half + r_y / (1.0 + load * load) : half;
        return std::pow(P * coarse::ct_factor(longer), 2) / plane_modulus +
               sigma_0 * sigma_0 / young * half * h1 * std::pow(load, n + 1.0);
    }
};

/// The flow theory begins at a tenth of the reference stress, where the law has no plastic strain to speak of.
Case power_law_specimen(double n, double at_tip, double load) {
    Case input = compact_tension(half);
    const double h = half / at_tip;
    input.mesh.size = 0.1;
    input.mesh.grading = {
        {.at = {input.cracks[0].points[1]}, .size = h, .outer_size = h, .radius = 2.0 * h, .growth = 10.0 / at_tip}};
    input.material.yield_stress = (n < 4.0 ? 0.1 : 0.3) * sigma_0;
    input.material.isotropic = {.law = HardeningLaw::Power, .n = n, .alpha = 1.0, .reference = sigma_0};
    input.fine.radius = 10.0;
    input.load = {.steps = 48, .blocks = {{.cycles = 0, .max = load, .min = 0.0}}};
    return input;
}

/// On three meshes, of which `finest` is the last. The scheme says no more of its accuracy than this: the handbook's
/// h_1 are not those of an independent code, and flow beside the tip counts in both of its parts, in the longer crack
/// and in the fully plastic J. Without the first of these J is too small.
void expect_scheme(const Epri& scheme, double load, double finest) {
    std::array<double, 3> on{};
    for (std::size_t k = 0; k < 3; ++k) {
        const double at_tip = finest / std::array{4.0, 2.0, 1.0}[k];
        on[k] = run_direct(power_law_specimen(scheme.n, at_tip, load * scheme.P_0())).increments.back().tips[0].J;
    }
    const double J = scheme.J(load), of_mesh = error_of_finest(on),
                 of_h1 = std::abs(Epri{scheme.n, scheme.h1_of_handbook, 0.0}.J(load) / J - 1.0),
                 twice = 1.0 - scheme.J(load, false) / J;
    std::cout << fmt::format(
        "n = {:2}  P / P_0 = {:.1f}  J {:.5f} {:.5f} {:.5f}  scheme {:.5f}  {:+.2f} %; mesh {:.2f} %, "
        "h_1 {:.2f} %, flow that counts twice {:.2f} %\n",
        scheme.n, load, on[0], on[1], on[2], J, 100.0 * (on[2] / J - 1.0), 100.0 * of_mesh, 100.0 * of_h1,
        100.0 * twice);
    constexpr double a_tenth = 0.1;  // whatever the scheme leaves open
    verify({.scene = fmt::format("CT a/W 0.5, plane strain, power law n = {}, P / P_0 = {}", scheme.n, load),
            .source = "Kumar, German, Shih 1981 (3.2)",
            .quantity = "J, N/mm",
            .reference = J,
            .ours = on[2],
            .within = std::min(of_mesh + of_h1 + twice, a_tenth),
            .mesh = fmt::format("ligament / {}", finest)});
    EXPECT_LT(on[2], J * (1.0 + of_mesh + of_h1));
}

TEST(PowerLaw, TheSchemeIsThatOfItsExample) {  // W = 50 mm, n = 5
    const Epri scheme{5.0, 0.919, 0.919};
    EXPECT_NEAR(50.0 * Epri::P_0(), 2361.14, 0.01);
    for (const auto& [load, J] : {std::pair(0.5, 12.816), {0.75, 32.80}, {1.0, 73.10}, {1.2, 135.8}})
        EXPECT_NEAR(50.0 * scheme.J(load), J, 1e-3 * J);
}

TEST(PowerLaw, JOfACompactSpecimen) { expect_scheme({5.0, 0.8871, 0.919}, 1.2, 30.0); }

TEST(PowerLaw, JOfCompactSpecimensLong) {
    for (const Epri& scheme : {Epri{3.0, 1.2407, 1.24}, {5.0, 0.8871, 0.919}, {10.0, 0.4426, 0.461}})
        for (const double load : {0.5, 1.0, 1.5}) expect_scheme(scheme, load, 60.0);
}

}  // namespace
}  // namespace stria::test
