#include "fine/material/hardening_curve.hpp"

#include <gtest/gtest.h>

namespace stria::fine {
namespace {

MaterialSection with(IsotropicHardening isotropic) {
    return {.young = 200e3, .poisson = 0.3, .yield_stress = 300.0, .isotropic = std::move(isotropic), .kinematic = {}};
}

const HardeningCurve power = with({.law = HardeningLaw::Power, .n = 6.0, .alpha = 0.7, .reference = 350.0});
const HardeningCurve lines =
    with({.law = HardeningLaw::Table, .plastic_strain = {0.0, 0.01, 0.04}, .stress = {300.0, 330.0, 340.0}});
const std::vector<HardeningCurve> curves{with({.law = HardeningLaw::Linear, .modulus = 1500.0}),
                                         with({.law = HardeningLaw::Voce, .Q = 90.0, .b = 12.0}), power, lines};

TEST(HardeningCurve, StartsAtNothing) {
    for (const HardeningCurve& curve : curves) {
        EXPECT_NEAR(curve.value(0.0), 0.0, 1e-12);
        EXPECT_EQ(curve.stored(0.0), 0.0);
    }
}

TEST(HardeningCurve, SlopeAndStoredWorkBelongToIt) {
    const double h = 1e-6;
    for (const HardeningCurve& curve : curves) {
        for (const double p : {0.003, 0.02, 0.035, 0.07}) {
            EXPECT_NEAR(curve.slope(p), (curve.value(p + h) - curve.value(p - h)) / (2.0 * h),
                        1e-4 * (1.0 + curve.slope(p)));
            EXPECT_NEAR(curve.value(p), (curve.stored(p + h) - curve.stored(p - h)) / (2.0 * h), 1e-4);
        }
    }
}

// Ramberg and Osgood: p = alpha reference / E (sigma / reference)^n, less its value at the yield stress.
TEST(HardeningCurve, PowerIsTheCurveOfRambergAndOsgoodFromTheYieldStressOn) {
    const auto strain = [](double stress) { return 0.7 * 350.0 / 200e3 * std::pow(stress / 350.0, 6.0); };
    for (const double stress : {310.0, 350.0, 420.0})
        EXPECT_NEAR(power.value(strain(stress) - strain(300.0)), stress - 300.0, 1e-10);
}

TEST(HardeningCurve, TableIsMadeOfStraightLinesAndEndsLevel) {
    EXPECT_NEAR(lines.value(0.005), 15.0, 1e-12);
    EXPECT_NEAR(lines.value(0.025), 35.0, 1e-12);
    EXPECT_NEAR(lines.value(0.5), 40.0, 1e-12);
}

}  // namespace
}  // namespace stria::fine
