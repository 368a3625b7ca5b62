// Cracks from holes on which pins press: K of the infinite plate, on the mesh of cases/plate-hole.
#include <gtest/gtest.h>

#include <cmath>
#include <fmt/format.h>
#include <iostream>
#include <numbers>

#include "common/case/schema/case_file.hpp"
#include "common/index.hpp"
#include "tests/support/cracks_from_a_hole.hpp"
#include "tests/support/folders.hpp"
#include "tests/support/specimens.hpp"

namespace stria::test {
namespace {

constexpr double radius_of_hole = 5.0;  // mm

/// Two pins of the largest pressure 1 MPa press on either half of the hole.
Case plate_with_pins(double length, int cracks) {
    Case input = read_case(std::string(source_folder) + "/cases/plate-hole/case.toml");
    input.growth.reset();
    input.cracks.resize(at(cracks));
    for (CrackSection& crack : input.cracks)
        crack.points[1].x() = std::copysign(radius_of_hole + length, crack.points[1].x());
    input.boundaries.clear();
    for (const double side : {1.0, -1.0}) {
        BoundarySection pin;
        pin.on = "hole";
        pin.pressure = 1.0;
        pin.cosine = Vec2(0.0, side);
        pin.centre = Vec2(0.0, 0.0);
        input.boundaries.push_back(pin);
    }
    return input;
}

// Half of the sum of this K and that of tension is K where one pin pulls and the plate is held on one side.
TEST(PinsInHoles, DriveCracksAsInTheInfinitePlate) {
    for (const double length : {1.0, 2.5, 5.0, 10.0}) {
        for (const int cracks : {1, 2}) {
            const ElasticSolution solution(plate_with_pins(length, cracks));
            const double F = factor_of_cracks_from_a_hole(length / radius_of_hole, cracks, stress_of_two_pins);
            const double K = F * std::sqrt(std::numbers::pi * length);
            for (const coarse::TipResult& tip : solution.tips) {
                const double off = 100.0 * (tip.K_I / K - 1.0);
                std::cout << fmt::format("{} cracks of {:4.1f} mm: F {:.4f}, K {:+.2f} %\n", cracks, length, F, off);
                EXPECT_LT(std::abs(off), 0.4) << length;
            }
        }
    }
}

// To the digits of docs/references.md 2.10, which another code has made with Chebyshev's third polynomials.
TEST(PinsInHoles, HaveTheFactorsOfTheReferences) {
    EXPECT_NEAR(factor_of_cracks_from_a_hole(0.2, 1, stress_of_two_pins), 0.8322, 2e-4);
    EXPECT_NEAR(factor_of_cracks_from_a_hole(1.0, 1, stress_of_two_pins), 0.2991, 2e-4);
    EXPECT_NEAR(factor_of_cracks_from_a_hole(0.5, 2, stress_of_two_pins), 0.5457, 2e-4);
    EXPECT_NEAR(factor_of_cracks_from_a_hole(3.0, 2, stress_of_two_pins), 0.1442, 2e-4);
}

}  // namespace
}  // namespace stria::test
