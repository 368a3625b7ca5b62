// Forces that hold faces that growth has opened, taken away at once or in parts.
#include "fine/growth/opening_faces.hpp"

#include <gtest/gtest.h>

namespace stria::fine {
namespace {

const Eigen::VectorXd forces{{0.0, 3.0, 0.0, -2.0}};
const std::vector<int> of_one_crack{-1, 0, -1, 0};

TEST(OpeningFaces, HoldByAShareOfTheirForces) {
    const OpeningFaces faces(forces, of_one_crack);
    Eigen::VectorXd load = Eigen::VectorXd::Ones(4);
    faces.hold(0.25, load);
    EXPECT_EQ(load, (Eigen::VectorXd{{1.0, 0.25, 1.0, 1.5}}));
    faces.hold(0.0, load);
    EXPECT_EQ(load[1], 0.25);
}

// A linear body opens in proportion to what has been taken away: the work does not depend on the parts.
TEST(OpeningFaces, ReleaseAsMuchInPartsAsAtOnce) {
    const Eigen::VectorXd whole{{7.0, 0.5, 9.0, -0.1}};  // elsewhere nothing is released
    OpeningFaces at_once(forces, of_one_crack);
    const double released = at_once.release(whole, 0.0);
    EXPECT_NEAR(released, 0.5 * (3.0 * 0.5 + 2.0 * 0.1), 1e-15);
    EXPECT_EQ(at_once.release(whole, 0.0), 0.0);
    OpeningFaces parts(forces, of_one_crack);
    const double first = parts.release(0.25 * whole, 0.75), second = parts.release(0.5 * whole, 1.0 / 3.0);
    EXPECT_NEAR(first + second + parts.release(0.25 * whole, 0.0), released, 1e-15);
    EXPECT_NEAR(first, (1.75 / 2.0) * 0.25 * 2.0 * released, 1e-15);
    EXPECT_TRUE(parts.held(4).isZero(0.0));
}

// The parabola begins with Newton's first step. Where that goes the other way, or so far that the faces would come
// back, it is not followed: no more is released than the forces do on the whole opening.
TEST(OpeningFaces, AreNotLedAstrayByAFirstStep) {
    const Eigen::VectorXd whole{{7.0, 0.5, 9.0, -0.1}};
    const double opened = forces.dot(whole);
    const auto released = [&](double step) {
        OpeningFaces faces(forces, of_one_crack);
        faces.begin(step * whole);
        return faces.release(whole, 0.0);
    };
    for (const double step : {0.0, 0.4, 1.0, 2.0})
        EXPECT_NEAR(released(step), (1.0 / 3.0 + step / 6.0) * opened, 1e-15);
    EXPECT_NEAR(released(40.0), 2.0 / 3.0 * opened, 1e-15);
    EXPECT_NEAR(released(-3.0), 1.0 / 3.0 * opened, 1e-15);
}

// Each crack has a path of its own, so that it may be with a rank of its own: bounds that the steps of all cracks keep
// together are no bounds.
TEST(OpeningFaces, OfTwoCracksReleaseWhatEachDoesAlone) {
    const Eigen::VectorXd whole{{7.0, 0.5, 9.0, -0.1}}, step{{0.0, -4.0, 0.0, -0.1}};
    const auto released = [&](const Eigen::VectorXd& held) {
        OpeningFaces faces(held, {-1, 0, -1, 1});
        faces.begin(step);
        return faces.release(whole, 0.0);
    };
    const Eigen::VectorXd first{{0.0, 3.0, 0.0, 0.0}}, second{{0.0, 0.0, 0.0, -2.0}};
    EXPECT_NEAR(released(first), 1.5 / 3.0, 1e-15);
    EXPECT_NEAR(released(second), 0.2 / 2.0, 1e-15);
    EXPECT_NEAR(released(forces), released(first) + released(second), 1e-15);
}

}  // namespace
}  // namespace stria::fine
