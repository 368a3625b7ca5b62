// Closed cracks under loads that do not grow in proportion, or whose pressure grows along the crack: docs/references.md
// 8.2 and 8.3, and the rule of Masing for a zone of slip that travels.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <iostream>
#include <numbers>

#include "coarse/cycle/closure_meter.hpp"
#include "tests/support/comparison.hpp"
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

/// Over the stations that are not next to a tip: the mean square of what the slip misses, over that of `scale`.
template <class Slip, class Scale>
double slip_error(const coupling::StepReport& zone, const Slip& exact, const Scale& scale) {
    double wrong = 0.0, whole = 0.0;
    for (const coupling::FaceSample& face : zone.faces) {
        const double x = face.x - 0.5 * plate_width;
        if (std::abs(x) > 0.8) continue;
        wrong += std::pow(face.slip - exact(x), 2);
        whole += std::pow(scale(x), 2);
    }
    return std::sqrt(wrong / whole);
}

// The row of a load of zero said that 8.7 of 11.1 mm were closed, by pressures of 1e-12 MPa.
TEST(SlidingLoads, NothingIsInContactWhereNothingIsLoaded) {
    StagedBody body(closed_crack(0.3));
    EXPECT_NEAR(body.load(UniformStress{.along = -100.0, .shear = 50.0}.sections()).zone.contact_length[0], 2.0, 1e-9);
    EXPECT_NEAR(body.load(UniformStress{.along = -1e-3, .shear = 0.0}.sections()).zone.contact_length[0], 2.0, 1e-9);
    EXPECT_EQ(body.load(UniformStress{.along = 0.0, .shear = 0.0}.sections()).zone.contact_length[0], 0.0);
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
    const auto row = rows_of({.scene = "closed crack, cyclic shear at constant pressure",
                              .source = "closed form (8.3)",
                              .within = 0.01,
                              .mesh = "a / 10"});
    row("range of K_II, MPa sqrt(mm)", range * std::sqrt(pi), dK);
    row("dissipation per cycle, N", exact, cycle);
    EXPECT_NEAR(dissipated[0] + dissipated[1], cycle, 1e-6 * cycle);
}

/// Pressure p_0 at the middle that grows by p_1 per mm; faces slide by `shear` as far as K_II vanishes where they stop.
struct GrowingPressure {
    double p_0, p_1, shear, friction = 0.3;

    [[nodiscard]] double excess() const { return shear - friction * p_0; }
    [[nodiscard]] double strength() const { return friction * p_1; }
    /// How far the zone of slip reaches from the end under the least pressure, to at most the other one.
    [[nodiscard]] double end() const { return std::min(1.0, (4.0 * excess() / strength() + 1.0) / 3.0); }
    [[nodiscard]] double half() const { return 0.5 * (end() + 1.0); }
    [[nodiscard]] double middle() const { return end() - half(); }
    [[nodiscard]] double drive() const { return excess() - strength() * middle(); }  // in the middle of that zone
    [[nodiscard]] double K_II(double sign) const {
        return (drive() - sign * 0.5 * strength() * half()) * std::sqrt(pi * half());
    }
    [[nodiscard]] double slip(double x) const {
        const double from = x - middle(), inside = half() * half() - from * from;
        return inside <= 0.0 ? 0.0 : 4.0 / plane_modulus * std::sqrt(inside) * (drive() - 0.5 * strength() * from);
    }
};

struct GrowingPressureError {
    double K_least, K_most, slip;  // percent of the K and of the slip at the end and in the middle
};

GrowingPressureError errors_of(const GrowingPressure& exact, double size) {
    StagedBody body(closed_crack(exact.friction, size));
    const Equilibrated pushed = body.load(UniformStress{
        .along = -exact.p_0, .shear = exact.shear, .along_gradient = -exact.p_1, .origin = 0.5 * plate_width}
                                              .sections());
    EXPECT_TRUE(pushed.newton.converged) << pushed.newton.table();
    const double sign = pushed.zone.faces[pushed.zone.faces.size() / 4].slip > 0.0 ? 1.0 : -1.0;
    const auto slip = [&](double x) { return sign * exact.slip(x); };
    const double scale = exact.K_II(-1.0);
    return {100.0 * (std::abs(pushed.tips[0].K_II) / scale - 1.0),
            100.0 * (std::abs(pushed.tips[1].K_II) - exact.K_II(1.0)) / scale,
            100.0 * slip_error(pushed.zone, slip, slip)};
}

// The linear pressure of bending: full slip, and partial slip that ends inside the crack.
TEST(SlidingLoads, PressureThatGrowsAlongTheCrack) {
    const GrowingPressure full{.p_0 = 100.0, .p_1 = 90.0, .shear = 50.0},
        partial{.p_0 = 100.0, .p_1 = 90.0, .shear = 33.5};
    ASSERT_EQ(full.end(), 1.0);
    ASSERT_LT(partial.end(), 0.6);
    EXPECT_NEAR(partial.K_II(1.0), 0.0, 1e-12);
    for (const GrowingPressure& exact : {full, partial}) {
        double before = 1e300;
        for (const double size : {0.1, 0.05, 0.025}) {
            const GrowingPressureError error = errors_of(exact, size);
            std::cout << fmt::format("slip to {:.3f}, h {}: K_II {:+.3f} % and {:+.3f} %, slip within {:.3f} %\n",
                                     exact.end(), size, error.K_least, error.K_most, error.slip);
            EXPECT_LT(error.slip, before);
            before = error.slip;
            if (size > 0.025) continue;
            const double scale = exact.K_II(-1.0);
            const auto row = [&](const std::string& quantity, double reference, double off) {
                verify({.scene = fmt::format("strength that grows along the crack, slip to {:.3f} a", exact.end()),
                        .source = "Buergmann, Pollard, Martel 1994, closed form (8.2)",
                        .quantity = quantity,
                        .reference = reference,
                        .ours = reference + 0.01 * off * scale,
                        .within = 0.01,
                        .mesh = "a / 40",
                        .scale = scale});
            };
            row("K_II at the weaker end, MPa sqrt(mm)", scale, error.K_least);
            row("K_II at the stronger end, MPa sqrt(mm)", exact.K_II(1.0), error.K_most);
            EXPECT_LT(error.slip, 1.0);
        }
    }
}

/// Slip at a place, between the stations beside it, mm.
double slip_at(const coupling::StepReport& zone, double x) {
    double left = -1e300, right = 1e300, at_left = 0.0, at_right = 0.0;
    for (const coupling::FaceSample& face : zone.faces) {
        const double here = face.x - 0.5 * plate_width;
        if (here <= x && here > left) left = here, at_left = face.slip;
        if (here > x && here < right) right = here, at_right = face.slip;
    }
    return std::lerp(at_left, at_right, (x - left) / (right - left));
}

/// references 8.4: the middle of a closed crack is smooth, and slip runs from it into the rough faces on either side;
/// unloading sends a zone of slip back after it. The larger relative error of the slip where the smooth faces end.
double error_of_slip_beyond_smooth_faces(double size) {
    constexpr double pressure = 100.0, friction = 0.3, shear = 15.0, a = 0.5, bound = friction * pressure;
    const double c = a / std::cos(pi * shear / (2.0 * bound)), c_back = a / std::cos(pi * shear / (4.0 * bound));
    const double pushed = 8.0 * bound * a / (pi * plane_modulus) * std::log(c / a);
    const double left = pushed - 16.0 * bound * a / (pi * plane_modulus) * std::log(c_back / a);
    Case input = closed_crack(friction, size);
    input.cracks[0].contact->smooth = {1.0 - a, 1.0 + a};
    StagedBody body(input);
    const auto slips = [&](double now) {
        const Equilibrated reached = body.load(UniformStress{.along = -pressure, .shear = now}.sections());
        EXPECT_TRUE(reached.newton.converged) << reached.newton.table();
        return 0.5 * std::abs(slip_at(reached.zone, a) + slip_at(reached.zone, -a));
    };
    slips(0.0);
    const double there = slips(shear) / pushed - 1.0, back = slips(0.0) / left - 1.0;
    const auto row = [&](const std::string& quantity, double reference, double off) {
        verify({.scene = "slip that runs from smooth faces into rough ones",
                .source = "closed form (8.4)",
                .quantity = quantity,
                .reference = reference,
                .ours = reference * (1.0 + off),
                .within = 0.04,
                .mesh = fmt::format("a / {:.0f}", 1.0 / size)});
    };
    row("slip where the smooth faces end, mm", pushed, there);
    row("the same after unloading, mm", left, back);
    std::cout << fmt::format("8.4: h {}: slip where the smooth faces end {:+.3f} %, after unloading {:+.3f} %\n", size,
                             100.0 * there, 100.0 * back);
    return std::max(std::abs(there), std::abs(back));
}

TEST(SlidingLoads, SlipRunsFromSmoothFacesIntoRoughOnesAndBack) {
    EXPECT_LT(error_of_slip_beyond_smooth_faces(0.05), 0.04);
}

TEST(SlidingLoads, SlipBeyondSmoothFacesConvergesLong) {
    double before = 1e300;
    for (const double size : {0.05, 0.025, 0.0125}) {
        const double error = error_of_slip_beyond_smooth_faces(size);
        EXPECT_LT(error, before);
        before = error;
    }
    EXPECT_LT(before, 0.01);
}

// A zone of slip that travels: the shear that has made it falls, and another one runs after it the other way. The
// strength of that is twice the first one's (Masing), until both are as long.
TEST(SlidingLoads, AZoneOfSlipTravelsLong) {
    constexpr double pushed = 33.5;
    const GrowingPressure first{.p_0 = 100.0, .p_1 = 90.0, .shear = pushed};
    StagedBody body(closed_crack(first.friction, 0.025));
    const auto sheared = [&](double shear) {
        Equilibrated now = body.load(UniformStress{
            .along = -first.p_0, .shear = shear, .along_gradient = -first.p_1, .origin = 0.5 * plate_width}
                                         .sections());
        EXPECT_TRUE(now.newton.converged) << now.newton.table();
        return now;
    };
    sheared(0.0);
    const Equilibrated reached = sheared(pushed);
    const double sign = reached.tips[0].K_II > 0.0 ? 1.0 : -1.0;
    const double turn = reached.zone.faces[reached.zone.faces.size() / 4].slip > 0.0 ? 1.0 : -1.0;
    const double K = first.K_II(-1.0);
    const auto pushed_slip = [&](double x) { return turn * first.slip(x); };
    for (const double shear : {0.0, -18.0, -pushed}) {
        const GrowingPressure back{
            .p_0 = first.p_0, .p_1 = first.p_1, .shear = pushed - shear, .friction = 2.0 * first.friction};
        const Equilibrated now = sheared(shear);
        const double K_II = K - back.K_II(-1.0);
        const double error = slip_error(
            now.zone, [&](double x) { return turn * (first.slip(x) - back.slip(x)); }, pushed_slip);
        std::cout << fmt::format("shear {}: slides back to {:.3f} of {:.3f}, slip within {:.3f} %, K_II {:+.3f} %\n",
                                 shear, back.end(), first.end(), 100.0 * error,
                                 100.0 * (sign * now.tips[0].K_II - K_II) / K);
        EXPECT_LT(error, 0.01);
        EXPECT_NEAR(sign * now.tips[0].K_II, K_II, 0.01 * K);
    }
}

// The load at which slip comes to a tip: where the shear that grows from nothing is mu p; after a reversal, where it
// has changed by 2 mu p.
TEST(SlidingLoads, SlipBeginsWhereTheShearHasReachedItsBound) {
    constexpr double pressure = 100.0, friction = 0.3, amplitude = 50.0, bound = friction * pressure;
    Case input = closed_crack(friction, 0.2);
    input.closure.distance = 0.25;
    input.closure.profile = {0.5};
    const coarse::ClosureMeter meter(input.closure, {300.0, 300.0}, input.cracks, {1.0, 1.0});
    StagedBody body(input, meter.slip_at());
    const auto sheared = [&](double shear) { return UniformStress{.along = -pressure, .shear = shear}.sections(); };
    body.load(sheared(0.0));
    const auto first_slip = [&](double from, double to) {
        const auto solve = [&](double shear) {
            return coarse::ClosureMeter::Trial{body.attempt(sheared(shear)), shear};
        };
        const std::vector<double> locked = meter.signal(body.attempt(sheared(from)), {});
        const std::vector<double> slid = meter.signal(body.attempt(sheared(to)), locked);
        return meter.locate({from, from, locked}, {to, to, slid}, {0.1, solve});
    };
    const auto expect_all_at = [&](const std::vector<coarse::OpeningChange>& changes, double shear, double change) {
        EXPECT_EQ(changes.size(), 4U);  // two tips, two distances
        for (const coarse::OpeningChange& slip : changes) {
            EXPECT_GE(slip.signal, 2);
            EXPECT_TRUE(slip.closes);
            EXPECT_NEAR(slip.load_factor, shear, 0.01 * change);
        }
    };
    expect_all_at(first_slip(0.0, amplitude), bound, bound);
    body.load(sheared(amplitude));
    body.load(sheared(-amplitude));
    expect_all_at(first_slip(-amplitude, amplitude), -amplitude + 2.0 * bound, 2.0 * bound);
}

}  // namespace
}  // namespace stria::test
