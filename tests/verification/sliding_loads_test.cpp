// Closed cracks under loads that do not grow in proportion: cyclic shear at constant pressure (docs/references.md 8.3).
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <iostream>
#include <numbers>

#include "tests/support/specimens.hpp"
#include "tests/support/staged_loads.hpp"

namespace stria::test {
namespace {

using std::numbers::pi;

constexpr double plate_width = 40.0;

/// A horizontal crack of half length 1 mm in the middle of a square plate of 40 mm.
Case closed_crack(double friction, double size = 0.1) {
    const Vec2 centre(plate_width / 2.0, plate_width / 2.0 + 0.3 * size), half(1.0, 0.0);
    Case input = specimen("plate", plate_width, {centre - half, centre + half});
    input.mesh.width = plate_width;
    input.mesh.size = 1.25 * plate_width * size;
    input.mesh.grading = {{.at = {centre}, .size = size, .outer_size = size, .radius = 1.6, .growth = 4.0 * size}};
    input.cracks[0].contact = ContactSection{friction};
    return input;
}

// references 8.3: constant pressure, shear to and fro; faces are locked until it has changed by 2 mu p.
TEST(SlidingLoads, CyclicShearUnderConstantPressure) {
    constexpr double pressure = 100.0, friction = 0.3, amplitude = 50.0;
    StagedBody body(closed_crack(friction));
    const auto sheared = [&](double shear) {
        Equilibrated now = body.load(UniformStress{.along = -pressure, .shear = shear}.sections());
        EXPECT_TRUE(now.newton.converged) << now.newton.table();
        return now;
    };
    sheared(0.0);
    const Equilibrated first = sheared(amplitude);
    const double bound = friction * pressure, range = 2.0 * amplitude - 2.0 * bound;
    std::vector<double> K{first.tips[0].K_II}, dissipated;
    for (const double sign : {-1.0, 1.0, -1.0, 1.0}) {
        const double edge = -sign * amplitude + sign * 2.0 * bound;  // where they are locked until
        const Equilibrated locked = sheared(edge - sign * 0.01 * bound);
        EXPECT_NEAR(locked.tips[0].K_II, K.back(), 2e-4 * range * std::sqrt(pi));
        EXPECT_NEAR(locked.zone.energy.friction, 0.0, 1e-9);
        const Equilibrated half = sheared(0.5 * (edge + sign * amplitude)), whole = sheared(sign * amplitude);
        EXPECT_NEAR(std::abs(half.tips[0].K_II - K.back()), 0.5 * range * std::sqrt(pi), 0.01 * range * std::sqrt(pi));
        K.push_back(whole.tips[0].K_II);
        dissipated.push_back(half.zone.energy.friction + whole.zone.energy.friction);
    }
    const double exact = 4.0 * pi * bound * range / plane_modulus;
    const double cycle = dissipated[2] + dissipated[3], dK = std::abs(K[4] - K[3]);
    std::cout << fmt::format("8.3: dK_II {:+.3f} %, dissipation per cycle {:+.3f} %, K_I {:.4f} % of dK_II\n",
                             100.0 * (dK / (range * std::sqrt(pi)) - 1.0), 100.0 * (cycle / exact - 1.0),
                             100.0 * first.tips[0].K_I / dK);
    EXPECT_NEAR(dK, range * std::sqrt(pi), 0.01 * range * std::sqrt(pi));
    EXPECT_NEAR(cycle, exact, 0.01 * exact);
    EXPECT_NEAR(dissipated[0] + dissipated[1], cycle, 1e-6 * cycle);
}

}  // namespace
}  // namespace stria::test
