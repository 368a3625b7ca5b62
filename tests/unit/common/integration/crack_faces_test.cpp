// The opening where it equals twice the distance to the tip.
#include "common/integration/crack_faces.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/cracked_mesh.hpp"

namespace stria::test {
namespace {

// k sqrt(r) = 2 r at r = k^2 / 4.
TEST(CrackFaces, NinetyDegreesMeetARootOfTheDistance) {
    const EnrichedMesh mesh = cracked(square_mesh(8), {{-1.0, 0.47}, {0.55, 0.47}});
    const Tip& tip = mesh.tips.at(0);
    for (const double k : {1e-3, 0.02, 0.4}) {
        const double ctod = opening_at_intercept(
            mesh, tip, [&](const FaceStation& station) { return k * std::sqrt(std::abs(station.s - tip.s)); });
        EXPECT_NEAR(ctod, 0.5 * k * k, 1e-9 * k * k);
    }
}

TEST(CrackFaces, NinetyDegreesMeetNoFacesThatPartInASlenderWedgeOrTooFarAway) {
    const EnrichedMesh mesh = cracked(square_mesh(8), {{-1.0, 0.47}, {0.55, 0.47}});
    const Tip& tip = mesh.tips.at(0);
    const auto wedge = [&](const FaceStation& station) { return 1.9 * std::abs(station.s - tip.s); };
    EXPECT_EQ(opening_at_intercept(mesh, tip, wedge), 0.0);
    EXPECT_LT(opening_at_intercept(mesh, tip, [](const FaceStation&) { return 1.2; }), 0.0);  // 2 r is 1.1 at the mouth
}

}  // namespace
}  // namespace stria::test
