// Statuses that come back within an increment are led out of their circle.
#include "fine/contact/status_search.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace stria::fine
