#include "coarse/analysis/growth/crack_advance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace stria::coarse {
namespace {

TEST(CrackAdvance, MovesTheEndOfAStraightCrackAndBendsAtACorner) {
    CrackSection crack{.points = {{0.0, 1.0}, {2.0, 1.0}}, .contact = {}};
    const Tip tip{.crack = 0, .position = {2.0, 1.0}, .direction = {1.0, 0.0}, .s = 2.0, .upper = 1};
    advance(crack, tip, {1.0, 0.0}, 0.25);
    ASSERT_EQ(crack.points.size(), 2U);
    EXPECT_EQ(crack.points[1], Vec2(2.25, 1.0));
    const Tip grown{.crack = 0, .position = {2.25, 1.0}, .direction = {1.0, 0.0}, .s = 2.25, .upper = 1};
    advance(crack, grown, {0.6, 0.8}, 0.5);
    ASSERT_EQ(crack.points.size(), 3U);
    EXPECT_LT((crack.points[2] - Vec2(2.55, 1.4)).norm(), 1e-15);
}

TEST(CrackAdvance, MovesTheFirstPointOfACrackThatStartsAtATip) {
    CrackSection crack{.points = {{1.0, 1.0}, {2.0, 1.0}}, .contact = {}};
    advance(crack, {.crack = 0, .position = {1.0, 1.0}, .direction = {-1.0, 0.0}, .s = 0.0, .upper = -1}, {-1.0, 0.0},
            0.25);
    EXPECT_EQ(crack.points.front(), Vec2(0.75, 1.0));
}

// docs/references.md 2.4: an inclined crack at b to the load, K_I : K_II = sin b : cos b.
TEST(CrackAdvance, TurnsToTheLargestHoopStress) {
    constexpr double degree = std::numbers::pi / 180.0;
    for (const auto& [b, angle] : {std::pair{30.0, -60.0}, {45.0, -53.1301}, {60.0, -43.2213}}) {
        const double K_I = std::sin(b * degree), K_II = std::cos(b * degree);
        EXPECT_NEAR(hoop_stress_angle(K_I, K_II) / degree, angle, 1e-4);
        EXPECT_NEAR(hoop_stress_angle(K_I, -K_II) / degree, -angle, 1e-4);
    }
    EXPECT_NEAR(hoop_stress_angle(0.0, 1.0) / degree, -70.5288, 1e-4);
    EXPECT_EQ(hoop_stress_angle(1.0, 0.004), 0.0);
    EXPECT_EQ(hoop_stress_angle(0.0, 0.0), 0.0);  // no ring has seen a field
}

TEST(CrackAdvance, CracksWithFrictionThatTouchGoWhereTheSolutionReachedSays) {
    const std::vector<CrackSection> cracks{{.points = {}, .contact = ContactSection{0.0}},
                                           {.points = {}, .contact = ContactSection{0.3}}};
    std::vector<Tip> tips(2);
    tips[0].crack = 0;
    tips[1].crack = 1;
    const std::vector<TipResult> nominal{{.K_I = 1.0, .K_II = 2.0}, {.K_I = 1.0, .K_II = 2.0}};
    std::vector<TipResult> reached{{.K_I = 5.0, .K_II = 6.0}, {.K_I = -1e-9, .K_II = 0.5}};
    EXPECT_EQ(directing(cracks, tips, nominal, reached)[1].K_II, 2.0);  // open from end to end
    reached[0].contact_length = reached[1].contact_length = 0.1;
    const std::vector<TipResult> chosen = directing(cracks, tips, nominal, reached);
    EXPECT_EQ(chosen[0].K_I, 1.0);
    EXPECT_EQ(chosen[0].K_II, 2.0);
    EXPECT_EQ(chosen[1].K_I, 0.0);
    EXPECT_EQ(chosen[1].K_II, 0.5);
    std::vector<TipResult> flowed = reached;
    flowed[1].rings_flow = true;
    EXPECT_EQ(directing(cracks, tips, nominal, flowed)[1].K_II, 2.0);
    reached[1].K_II = -1e-12;  // rounding
    EXPECT_EQ(directing(cracks, tips, nominal, reached)[1].K_II, 2.0);
}

}  // namespace
}  // namespace stria::coarse
