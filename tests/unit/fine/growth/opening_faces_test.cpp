// Forces that hold faces that growth has opened, taken away at once or in parts.
#include "fine/growth/opening_faces.hpp"

#include <gtest/gtest.h>

#include "common/index.hpp"
#include "common/integration/element_operator.hpp"
#include "tests/support/cracked_mesh.hpp"
#include "tests/support/plates.hpp"

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

// The jumps of the second mesh are new. What has come out of balance counts where something has changed alone, and what
// was held is held on.
TEST(OpeningFaces, HoldWhatChangesOfFunctionsUnbalance) {
    const Mesh body = test::square_mesh(8);
    const EnrichedMesh before = test::cracked(body, {{-1.0, 0.47}, {0.3, 0.47}}, 1),
                       next = test::cracked(body, {{-1.0, 0.47}, {0.7, 0.47}}, 1);
    const std::vector<int> old = same_unknowns(next, before);
    Eigen::VectorXd still = Eigen::VectorXd::Zero(before.unknowns), force = still,
                    now = Eigen::VectorXd::Zero(next.unknowns);
    UnknownSet changed(next.unknowns);
    const auto kept = [&](int i) { return old[at(i)] >= 0; };
    int first = 0, second = 0, jump = 0;  // two that stay, and one that is new
    while (!kept(first)) ++first;
    second = first + 2;
    while (!kept(second)) ++second;
    while (kept(jump)) ++jump;
    still[old[at(first)]] = 5.0;
    force[old[at(first)]] = 7.0;
    force[old[at(second)]] = 11.0;
    now[first] = 4.0;
    now[second] = 10.0;
    now[jump] = -3.0;
    changed.insert(first);
    changed.insert(jump);
    OpeningFaces faces(still, cracks_of_unknowns(before));
    faces.hold_changes(before, force, next, now, changed);
    Eigen::VectorXd held = Eigen::VectorXd::Zero(next.unknowns);
    held[first] = 5.0 + 7.0 - 4.0;
    held[jump] = 3.0;
    EXPECT_EQ(faces.held(next.unknowns), held);
}

}  // namespace
}  // namespace stria::fine
