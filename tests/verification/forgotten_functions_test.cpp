// A body of which nothing may yield has no memory but that of its rough faces: cracks that have come to a place are
// those that have been there from the start, whatever stood at their tips on the way.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/sent_analysis.hpp"
#include "tests/support/specimens.hpp"

namespace stria::test {
namespace {

/// Large elements, under tension and compression by turns; a slanted crack turns at once.
Case pulled_and_pressed(Enrichment enrichment, double growth, double slant) {
    Case input = specimen("sent", 20.0, {{0.0, 9.2 - slant}, {4.0, 9.2 + slant}});
    input.mesh.width = 10.0;
    input.cracks[0].contact = ContactSection{};
    input.boundaries = {at_end("top", End::Pulled, 1.0), at_end("bottom", End::Pulled, -1.0)};
    input.load = {.steps = 8, .blocks = {{.cycles = 4, .max = 30.0, .min = -30.0}}};
    input.solver.tolerance = 1e-11;
    input.fine.enrichment = enrichment;
    input.growth = GrowthSection{.increment = growth};
    return input;
}

/// In the place of the first points, with what has grown on.
Case begun_with(Case input, const std::vector<Vec2>& crack) {
    input.growth.reset();
    input.cracks[0].points = crack;
    return input;
}

/// The crack of the increments that follow the last but one growth, and their tips up to the last one.
struct LastCycle {
    std::vector<Vec2> crack;
    std::vector<Followed> increments;

    LastCycle(const Case& input, const RunHistory& run) : crack(input.cracks[0].points) {
        const double a = run.increments.at(run.increments.size() - 2).tips[0].a;
        for (const Followed& now : run.increments) {
            if (now.tips[0].a > a * (1.0 + 1e-9)) break;
            const Vec2 tip(now.tips[0].x, now.tips[0].y);
            if ((tip - crack.back()).norm() > 1e-9) crack.push_back(tip);
            if (now.tips[0].a >= a && !now.step.releases) increments.push_back(now);
        }
    }
};

class ForgottenFunctions : public testing::TestWithParam<Enrichment> {};

TEST_P(ForgottenFunctions, LeaveNoTrace) {
    for (const auto& [growth, slant] : {std::pair{0.031, 0.0}, {0.031, -0.6}, {0.4, 0.3}, {1.0, 0.5}}) {
        const Case input = pulled_and_pressed(GetParam(), growth, slant);
        const LastCycle grown(input, run_direct(input));
        const RunHistory there = run_direct(begun_with(input, grown.crack));
        const double K = there.increments.back().tips[0].K_I, J = there.increments.back().tips[0].J;
        int closed = 0;
        ASSERT_EQ(grown.crack.size(), 5U);
        ASSERT_EQ(grown.increments.size(), 8U);
        for (const Followed& now : grown.increments) {
            const auto same = std::ranges::find_if(there.increments, [&](const Followed& other) {
                return other.step.cycle > 1 && std::abs(other.load_factor - now.load_factor) < 1e-9;
            });
            ASSERT_NE(same, there.increments.end());
            EXPECT_NEAR(now.tips[0].K_I, same->tips[0].K_I, 1e-4 * K) << growth << ", load " << now.load_factor;
            EXPECT_NEAR(now.tips[0].K_II, same->tips[0].K_II, 1e-4 * K) << growth << ", load " << now.load_factor;
            EXPECT_EQ(std::isnan(same->tips[0].J), std::isnan(now.tips[0].J));
            EXPECT_FALSE(std::isnan(J) && slant == 0.0) << "only behind a sharp bend it is not told";
            if (!std::isnan(J)) {
                EXPECT_NEAR(now.tips[0].J, same->tips[0].J, 1e-6 * J) << growth << ", load " << now.load_factor;
            }
            EXPECT_NEAR(now.tips[0].CMOD, same->tips[0].CMOD, 1e-8 * there.increments.back().tips[0].CMOD);
            if (now.tips[0].contact_length > 0.0) ++closed;
        }
        EXPECT_GE(closed, 3);
    }
}

INSTANTIATE_TEST_SUITE_P(All, ForgottenFunctions,
                         testing::Values(Enrichment::Auto, Enrichment::None, Enrichment::Single));

// All of a slanted crack slides in one direction while the load that presses it grows: what it has rubbed off is of its
// past, the tractions of its faces are not. A growth releases what K_II tells, and no more is rubbed off in it than
// that leaves: faces slide on from where they were.
TEST(ForgottenSlip, IsThatOfTheFacesAndNotOfTheFunctions) {
    for (const double growth : {0.1, 0.5}) {
        Case input = specimen("plate", 40.0, {{13.03, 13.37}, {23.03, 23.37}});
        input.mesh.width = 40.0;
        input.cracks[0].contact = ContactSection{.friction = 0.3};
        input.boundaries = {at_end("top", End::Pulled, -1.0), at_end("bottom", End::Pulled, 1.0)};
        input.load = {.steps = 4, .blocks = {{.cycles = 3, .max = 100.0, .min = 0.0}}};
        input.solver.tolerance = 1e-11;
        input.growth = GrowthSection{.increment = growth, .direction = GrowthDirection::Straight};
        const RunHistory grown = run_direct(input);
        const std::vector<coarse::TipResult>& tips = grown.increments.back().tips;
        const RunHistory there = run_direct(begun_with(input, {{tips[0].x, tips[0].y}, {tips[1].x, tips[1].y}}));
        for (std::size_t t = 0; t < 2; ++t) {
            const coarse::TipResult& same = there.at_maximum().tips[t];
            EXPECT_NEAR(tips[t].K_II, same.K_II, 1e-5 * std::abs(same.K_II));
            EXPECT_NEAR(tips[t].K_I, same.K_I, 1e-5 * std::abs(same.K_II));
        }
        double by_K = 0.0, released = 0.0;
        for (std::size_t i = 1; i < grown.increments.size(); ++i) {
            const Followed &before = grown.increments[i - 1], &now = grown.increments[i];
            if (!now.step.releases) continue;
            for (std::size_t t = 0; t < 2; ++t) {
                const double K = 0.5 * (before.tips[t].K_II + now.tips[t].K_II);
                by_K += K * K / plane_modulus * growth;
            }
            released += now.work.released - before.work.released;
            EXPECT_GT(now.work.by_friction, before.work.by_friction);
        }
        // Pressure comes to new faces as they slide, and they rub less off than it tells.
        EXPECT_NEAR(released, by_K, 0.12 * growth * by_K);
    }
}

}  // namespace
}  // namespace stria::test
