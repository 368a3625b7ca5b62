// Which of the loads at which contact comes and goes are the K_op and K_cl of a cycle.
#include "coarse/cycle/signal_of_cycle.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stria::coarse {
namespace {

TEST(SignalOfCycle, TheLargestKOfACycleTellsWhichRiseOpensIt) {
    SignalOfCycle signal;
    signal.note_change(false, 30.0, 1.0);
    signal.note_state(true, 100.0, 1.0);
    signal.reach_largest();
    signal.note_change(true, 25.0, -1.0);
    signal.note_state(false, 0.0, -1.0);
    signal.note_change(false, 40.0, 1.0);  // a rise that goes less far
    signal.note_state(true, 60.0, 1.0);
    EXPECT_EQ(signal.loads(0.0).K_op, 30.0);
    EXPECT_EQ(signal.loads(0.0).K_cl, 25.0);
    signal.note_state(true, 120.0, 1.0);
    signal.reach_largest();
    EXPECT_EQ(signal.loads(0.0).K_op, 40.0);
}

TEST(SignalOfCycle, ARiseThatTheCycleBeforeHadBegunStandsForOneThatIsToCome) {
    SignalOfCycle signal;
    signal.note_change(false, 50.0, 1.0);
    signal.note_state(true, 100.0, 1.0);
    signal.reach_largest_of_rest();
    signal.note_change(true, 45.0, -1.0);
    signal.note_state(false, -100.0, -1.0);
    signal.note_state(false, 20.0, 1.0);  // not yet open as the cycle ends
    signal.reach_largest();
    EXPECT_TRUE(std::isnan(signal.loads(-100.0).K_op));
    signal.take_rest();
    EXPECT_EQ(signal.loads(-100.0).K_op, 50.0);
    EXPECT_EQ(signal.loads(-100.0).K_cl, 45.0);
}

TEST(SignalOfCycle, WhatItKnowsStandsBeforeTheRest) {
    SignalOfCycle known, lost;
    for (SignalOfCycle* signal : {&known, &lost}) {
        signal->note_change(false, 50.0, 1.0);
        signal->reach_largest_of_rest();
        signal->note_change(true, 45.0, -1.0);
    }
    known.note_change(false, 30.0, 1.0);
    lost.note_change(false, NAN, 1.0);
    for (SignalOfCycle* signal : {&known, &lost}) {
        signal->reach_largest();
        signal->take_rest();
    }
    EXPECT_EQ(known.loads(0.0).K_op, 30.0);
    EXPECT_TRUE(std::isnan(lost.loads(0.0).K_op));
    EXPECT_TRUE(lost.loads(0.0).lost);
}

TEST(SignalOfCycle, ARiseGoesOnIntoAnotherCycle) {
    SignalOfCycle signal;
    signal.note_change(true, 0.0, -1.0);
    signal.note_change(false, 20.0, 1.0);
    signal.begin_cycle();
    signal.note_state(true, 100.0, 1.0);
    signal.reach_largest();
    EXPECT_EQ(signal.loads(-100.0).K_op, -100.0);  // it might be open all cycle
    signal.note_state(false, -100.0, -1.0);        // closes at its least K
    signal.note_state(false, -50.0, 1.0);
    EXPECT_EQ(signal.loads(-100.0).K_op, 20.0);
    EXPECT_EQ(signal.loads(-100.0).K_cl, -100.0);
    signal.begin_cycle();
    signal.note_state(false, 100.0, 1.0);
    signal.reach_largest();
    EXPECT_TRUE(std::isnan(signal.loads(-100.0).K_op));  // closed all the way up
}

// K_op of the cycle before stood for it: new faces of a crack that grows touch, and its next cycle never opens them.
TEST(SignalOfCycle, WhatOpenedAShorterCrackOpensNoLongerOne) {
    for (const double rise : {0.0, 1.0}) {  // it touches as the crack grows, or as K rises
        SignalOfCycle signal;
        signal.note_change(true, 60.0, -1.0);
        signal.note_state(false, 0.0, -1.0);
        signal.note_change(false, 90.0, 1.0);
        signal.note_state(true, 100.0, 1.0);
        signal.reach_largest();
        EXPECT_EQ(signal.loads(0.0).K_op, 90.0);
        if (rise > 0.0) signal.note_change(true, 100.0, rise);
        signal.note_state(false, 100.0, rise);
        signal.begin_cycle();
        signal.note_state(false, 0.0, -1.0);
        signal.note_state(false, 100.0, 1.0);
        signal.reach_largest();
        EXPECT_TRUE(std::isnan(signal.loads(0.0).K_op));
        EXPECT_FALSE(signal.loads(0.0).lost);
    }
}

// K_op was empty, as if it had been closed all the way, and the crack was arrested.
TEST(SignalOfCycle, ARiseThatACycleBeforeBeganMayBeOpenAllTheWay) {
    SignalOfCycle signal;
    signal.note_state(true, -20.0, -1.0);
    signal.note_state(true, 40.0, 1.0);
    signal.begin_cycle();
    signal.note_state(true, 100.0, 1.0);
    signal.reach_largest();
    signal.note_change(true, 10.0, -1.0);
    signal.note_state(false, -20.0, -1.0);
    EXPECT_EQ(signal.loads(-20.0).K_op, -20.0);
    EXPECT_EQ(signal.loads(-20.0).K_cl, 10.0);
}

TEST(SignalOfCycle, OpensInTheNextRiseWhateverWasLostInTheLast) {
    SignalOfCycle signal;
    signal.note_change(false, NAN, 1.0);
    signal.note_state(true, 100.0, 1.0);
    signal.note_state(true, 20.0, -1.0);
    signal.note_state(true, 110.0, 1.0);
    signal.reach_largest();
    EXPECT_EQ(signal.loads(20.0).K_op, 20.0);
    EXPECT_FALSE(signal.loads(20.0).lost);
}

TEST(SignalOfCycle, ARestThatIsNotOfItsKindLeavesItsOpeningUntold) {
    SignalOfCycle open, closed;
    open.note_change(false, 50.0, 1.0);
    for (SignalOfCycle* signal : {&open, &closed}) {
        signal->note_state(signal == &open, 100.0, 1.0);
        signal->reach_largest();
        signal->miss_rest();
    }
    EXPECT_EQ(open.loads(0.0).K_op, 50.0);
    EXPECT_FALSE(open.loads(0.0).lost);
    EXPECT_TRUE(closed.loads(0.0).lost);
}

TEST(SignalOfCycle, IsOpenFromTheLeastKWhereItNeverCloses) {
    SignalOfCycle signal;
    signal.note_state(true, 10.0, -1.0);
    signal.note_state(true, 100.0, 1.0);
    signal.reach_largest();
    EXPECT_EQ(signal.loads(10.0).K_op, 10.0);
    EXPECT_EQ(signal.loads(10.0).K_cl, 10.0);
}

}  // namespace
}  // namespace stria::coarse
