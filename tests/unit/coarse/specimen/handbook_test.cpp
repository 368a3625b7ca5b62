// Handbook formulas of the specimens against the tables of docs/references.md 2.1 to 2.3 and 3.3.
#include "coarse/specimen/handbook.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "tests/support/compact_tension.hpp"

namespace stria::coarse {
namespace {

using Table = std::vector<std::pair<double, double>>;

TEST(Handbook, StressIntensitiesMatchTheTables) {
    for (const auto& [x, F] : Table{{0.1, 1.1957},
                                    {0.2, 1.3667},
                                    {0.25, 1.4941},
                                    {0.3, 1.6551},
                                    {0.4, 2.1080},
                                    {0.5, 2.8266},
                                    {0.6, 4.0432},
                                    {0.7, 6.3755}})
        EXPECT_NEAR(sent_factor(x), F, 5.1e-5) << x;
    for (const auto& [x, F] : Table{{0.2, 1.02448}, {0.5, 1.18623}, {0.7, 1.48735}})
        EXPECT_NEAR(mt_factor(x), F, 5.1e-6) << x;
    for (const auto& [x, f] : Table{{0.3, 5.6209},
                                    {0.4, 7.2787},
                                    {0.45, 8.3396},
                                    {0.5, 9.6591},
                                    {0.55, 11.3643},
                                    {0.6, 13.6541},
                                    {0.7, 21.5518}})
        EXPECT_NEAR(ct_factor(x), f, 5.1e-5) << x;
}

TEST(Handbook, StressIntensitiesScaleWithLoadAndWidth) {
    EXPECT_NEAR(sent_K(50.0, 20.0, 150.0), sent_factor(0.4) * 3.0 * std::sqrt(std::numbers::pi * 20.0), 1e-12);
    EXPECT_NEAR(mt_K(50.0, 10.0, 150.0), mt_factor(0.4) * 3.0 * std::sqrt(std::numbers::pi * 10.0), 1e-12);
    EXPECT_NEAR(ct_K(49.0, 24.5, 14.0), 2.0 * ct_factor(0.5), 1e-12);
}

TEST(Handbook, CompliancesMatchTheTable) {
    for (const auto& [x, C] : Table{{0.3, 14.275}, {0.4, 22.881}, {0.5, 36.989}, {0.6, 63.285}, {0.7, 122.763}}) {
        EXPECT_NEAR(test::ct_crack_length_from_load_line(C), x, 6e-4);
        EXPECT_NEAR(ct_load_line_compliance(x), C, 0.01 * C) << x;
    }
    for (const auto& [x, C] : Table{{0.3, 24.891}, {0.4, 36.218}, {0.5, 54.761}, {0.6, 88.967}, {0.7, 165.487}}) {
        EXPECT_NEAR(test::ct_crack_length_from_front_face(C), x, 6e-4);
        EXPECT_NEAR(ct_front_face_compliance(x), C, 0.01 * C) << x;
    }
    for (const double x : {0.2, 0.5, 0.9}) {
        EXPECT_NEAR(test::ct_crack_length_from_load_line(ct_load_line_compliance(x)), x, 1e-10);
        EXPECT_NEAR(test::ct_crack_length_from_front_face(ct_front_face_compliance(x)), x, 1e-10);
    }
}

TEST(Handbook, ComplianceReleasesWhatTheStressIntensitySays) {  // sqrt(1/2 dC/dx) = f
    for (const double x : {0.5, 0.6, 0.7}) {
        const double slope = (ct_load_line_compliance(x + 1e-4) - ct_load_line_compliance(x - 1e-4)) / 2e-4;
        EXPECT_NEAR(std::sqrt(0.5 * slope), ct_factor(x), 0.006 * ct_factor(x)) << x;
    }
}

TEST(Handbook, LimitLoadsMatchTheTables) {
    const PlaneState strain = PlaneState::Strain, stress = PlaneState::Stress;
    for (const auto& [x, P] : Table{{0.3, .29398}, {0.4, .20016}, {0.5, .12885}, {0.6, .07655}, {0.7, .04007}})
        EXPECT_NEAR(ct_limit_load(50.0, 50.0 * x, 300.0, strain), 15000.0 * P, 15000.0 * 3.1e-5)
            << x;  // the table rounds (1 + 1.702) 1.702 to 4.599
    for (const auto& [x, P] : Table{{0.3, .19587}, {0.5, .08900}, {0.7, .02851}})
        EXPECT_NEAR(ct_limit_load(50.0, 50.0 * x, 300.0, stress), 50.0 * 300.0 * P, 15000.0 * 5.5e-6) << x;
    for (const auto& [x, P] : Table{{0.25, .79516}, {0.5, .36604}, {0.6, .20685}, {0.7, .10004}})
        EXPECT_NEAR(sent_limit_load(50.0, 50.0 * x, 300.0, strain), 50.0 * 300.0 * P, 15000.0 * 5.5e-6) << x;
    EXPECT_NEAR(mt_limit_load(50.0, 10.0, 300.0, strain), 2.0 / std::sqrt(3.0) * 9000.0, 1e-9);
    EXPECT_NEAR(mt_limit_load(50.0, 10.0, 300.0, stress), 9000.0, 1e-9);
    // EPRI: 1.072 (sqrt(1 + (a/c)^2) - a/c) c sigma_y, with a = c.
    EXPECT_NEAR(sent_limit_load(50.0, 25.0, 300.0, stress), 1.072 * (std::sqrt(2.0) - 1.0) * 25.0 * 300.0, 1e-9);
}

}  // namespace
}  // namespace stria::coarse
