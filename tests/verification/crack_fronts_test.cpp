// Where a crack without tip functions seems to end that crosses the lines of a mesh at any place and angle, by its K
// (docs/references.md 2.1 tells dK/da).
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "coarse/enrichment/crack_front.hpp"
#include "coarse/specimen/handbook.hpp"
#include "coarse/zone/refined_scene.hpp"
#include "tests/support/specimens.hpp"
#include "tests/support/turned_mesh.hpp"

namespace stria::test {
namespace {

constexpr double wide = 50.0, element_at_tip = 0.2;

Case crossed_plate() {
    Case input = edge_crack(20.0, 200.0, End::Pulled);
    input.mesh.width = wide;
    input.mesh.size = 1.6;
    input.fine.refine = 8;
    input.fine.radius = 1.0;
    input.fine.enrichment = Enrichment::None;
    return input;
}

/// By how many elements it seems to be longer than it is, but for what elements of that size do to K.
double excess(double a, double K) {
    const auto K_of = [](double length) { return coarse::sent_K(wide, length, wide); };
    constexpr double step = 0.1;
    return (K - K_of(a)) * 2.0 * step / (K_of(a + step) - K_of(a - step)) / element_at_tip;
}

// A crack that ends just where it crosses an edge has its front there.
TEST(CrackFronts, SeemToEndEarlierByTheirLag) {
    double largest_lag = 0.0;
    for (const double degrees : {0.0, 10.0, 20.0, 30.0, 45.0}) {
        const TemporaryFolder folder;
        Case input = on_turned_mesh(crossed_plate(), degrees, folder);
        std::vector<Vec2> places;
        for (const CrackPiece& piece : coarse::refined_scene(input).enriched.pieces)
            if (const Vec2& end = piece.points.back(); end.x() > 19.0 && end.x() < 20.0) places.push_back(end);
        std::vector<double> off;
        for (const Vec2& place : places) {
            input.cracks[0].points.back() = place + Vec2(1e-8, 0.0);  // not before it, to rounding
            const ElasticSolution solution(input);
            const EnrichedMesh& mesh = solution.scene.enriched;
            if (std::abs(mesh.tips[0].beyond) > 1e-7) continue;  // about this tip the small elements are others
            const double lag = coarse::lag(solution.scene.mesh, mesh.pieces) / element_at_tip;
            off.push_back(excess(place.x(), solution.tips[0].K_I) + lag);
            std::cout << fmt::format("{:2} degrees, {:.3f} mm: lag {:+.2f} elements, seems to be {:+.2f} longer\n",
                                     degrees, place.x(), lag, off.back() - lag);
            largest_lag = std::max(largest_lag, lag);
        }
        ASSERT_GE(off.size(), 5U);
        const auto [least, most] = std::ranges::minmax(off);
        EXPECT_LT(most - least, 0.15) << degrees;
    }
    EXPECT_GT(largest_lag, 0.5);  // or there was nothing to tell
}

}  // namespace
}  // namespace stria::test
