// Lengths of the flow about a tip.
#include "coarse/fracture/plastic_zone.hpp"

#include <gtest/gtest.h>

namespace stria::coarse {
namespace {

TEST(PlasticZone, RadiusIsEquation3) {
    constexpr double K_for_radius_1 = 300.0 * 1.595769121605731;  // beta = 2: R = (2 pi/16) (K/300)^2
    EXPECT_NEAR(subdivision_radius(2.0, 850.0, 300.0), 2.0 * 3.14159265358979 / 16.0 * 850.0 * 850.0 / 9e4, 1e-12);
    EXPECT_NEAR(subdivision_radius(2.0, K_for_radius_1, 300.0), 1.0, 1e-12);
}

TEST(PlasticZone, ClosureIsLookedAtATenthOfItBehindOrWhereTheCaseSays) {
    const std::vector<double> K{300.0, 600.0}, yield_stress{300.0, 300.0};
    const std::vector<double> chosen = closure_distances({}, K, yield_stress);
    EXPECT_NEAR(chosen[0], 0.1 * 3.14159265358979 / 16.0, 1e-12);
    EXPECT_NEAR(chosen[1], 4.0 * chosen[0], 1e-12);
    ClosureSection closure;
    closure.distance = 0.3;
    EXPECT_EQ(closure_distances(closure, K, yield_stress), (std::vector<double>{0.3, 0.3}));
}

// 300 MPa sqrt(mm) at 300 MPa.
TEST(PlasticZone, ForwardZoneIsLongestToTheSidesInPlaneStrain) {
    EXPECT_NEAR(forward_zone(300.0, 300.0, PlaneState::Stress), 0.3183099, 1e-7);
    EXPECT_NEAR(forward_zone(300.0, 300.0, PlaneState::Strain), 0.157, 1e-7);
    EXPECT_EQ(forward_zone(-300.0, 300.0, PlaneState::Strain), 0.0);
    EXPECT_NEAR(forward_zone_ahead(300.0, 300.0, PlaneState::Stress), 0.3183099, 1e-7);
    EXPECT_NEAR(forward_zone_ahead(300.0, 300.0, PlaneState::Strain), 0.04, 1e-7);
    EXPECT_EQ(forward_zone_ahead(-300.0, 300.0, PlaneState::Strain), 0.0);
    EXPECT_NEAR(elastic_zone_ahead(300.0, 300.0, PlaneState::Stress), 0.3183099, 1e-7);
    EXPECT_NEAR(elastic_zone_ahead(300.0, 300.0, PlaneState::Strain), 0.07379, 1e-7);
    EXPECT_EQ(elastic_zone_ahead(-300.0, 300.0, PlaneState::Stress), 0.0);
}

}  // namespace
}  // namespace stria::coarse
