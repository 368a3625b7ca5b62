// Statuses that come back within an increment are led out of their circle.
#include "fine/contact/status_search.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

namespace stria::fine {
namespace {

using enum FaceStatus;
using Statuses = std::vector<FaceStatus>;

TEST(StatusSearch, DoesWhatTheLawWantsWhileNothingComesBack) {
    StatusSearch search;
    EXPECT_EQ(search.next({Open, Open}, {Stick, Open}, 0), (Statuses{Stick, Open}));
    EXPECT_EQ(search.next({Stick, Open}, {Stick, Stick}, 1), (Statuses{Stick, Stick}));
    EXPECT_FALSE(search.one_at_a_time());
}

TEST(StatusSearch, ChangesTheWorstAloneWhereFacesThatDoNotSlideComeBack) {
    StatusSearch search;
    static_cast<void>(search.next({Open, Open}, {Stick, Open}, 0));
    static_cast<void>(search.next({Stick, Open}, {Open, Stick}, 0));
    EXPECT_EQ(search.next({Open, Stick}, {Stick, Open}, 1), (Statuses{Open, Open}));
    EXPECT_TRUE(search.one_at_a_time());
    EXPECT_EQ(search.next({Open, Open}, {Stick, Stick}, 0), (Statuses{Stick, Open})) << "from then on";
    search.begin();
    EXPECT_EQ(search.next({Open, Open}, {Stick, Stick}, 0), (Statuses{Stick, Stick})) << "in the next increment anew";
}

// Once: then the worst alone.
TEST(StatusSearch, LetsAllThatSlidesStickForAStepWhereItComesBack) {
    StatusSearch search;
    const Statuses on{SlipForward, Open}, back{SlipBack, Open};
    static_cast<void>(search.next(back, on, 0));
    static_cast<void>(search.next(on, back, 0));
    EXPECT_EQ(search.next(back, on, 0), (Statuses{Stick, Open}));
    EXPECT_FALSE(search.one_at_a_time());
    EXPECT_EQ(search.next({Stick, Open}, on, 0), on) << "what was before it counts no more";
    EXPECT_EQ(search.next(on, {SlipForward, Stick}, 1), (Statuses{SlipForward, Stick}));
    EXPECT_EQ(search.next({SlipForward, Stick}, on, 1), on);
    EXPECT_TRUE(search.one_at_a_time());
}

// One multiplier that would press less by twelve times what it would brake less, were it to slide: if it holds it has
// more shear than its bound, and if it slides on it slides back. It opens, and neither the law at what holds nor that
// at what slides says so.
TEST(StatusSearch, TriesWhatAPlaceHasNotBeenWhereItGoesToAndFroAlone) {
    const CoulombContact coulomb{.friction = 0.2, .c = 1.0};
    const Eigen::Vector2d held(190.0, 55.0);                                               // pressure and shear, MPa
    const Eigen::Matrix2d K = (Eigen::Matrix2d() << 160.0, -12.6, -12.6, 1.0).finished();  // by gap and slip, MPa/mm
    const auto solved = [&](FaceStatus status) {
        FaceState state;
        const double ratio = signed_friction(status, coulomb.friction);
        if (status == Open) {
            const Eigen::Vector2d jump = K.inverse() * Eigen::Vector2d(-held[0], held[1]);
            state.gap = jump[0];
            state.slip = jump[1];
            return state;
        }
        if (slides(status)) state.slip = (held[1] - ratio * held[0]) / (K(1, 1) + ratio * K(0, 1));
        state.pressure = held[0] + K(0, 1) * state.slip;
        state.shear = held[1] - K(1, 1) * state.slip;
        return state;
    };
    StatusSearch search;
    search.begin();
    Statuses present{Stick};
    int steps = 0;
    for (; steps < 12; ++steps) {
        const FaceStatus wanted = coulomb.status(solved(present[0]));
        if (wanted == present[0]) break;
        present = search.next(present, {wanted}, 0);
    }
    EXPECT_EQ(present, Statuses{Open});
    EXPECT_LT(steps, 12);
    EXPECT_GT(solved(Open).gap, 0.0);
}

TEST(StatusSearch, LeavesFacesWithoutFrictionToOpenAndTouch) {
    StatusSearch search;
    Statuses present{Stick};
    for (int step = 0; step < 8; ++step) {
        present = search.next(present, {present[0] == Stick ? Open : Stick}, 0);
        EXPECT_FALSE(slides(present[0]));
    }
}

}  // namespace
}  // namespace stria::fine
