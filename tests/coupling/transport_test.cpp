// The conversation in memory: transport, stub and server with both sides in one test. mpi_conversation.cpp has it over
// MPI.
#include <gtest/gtest.h>

#include <future>
#include <memory>
#include <utility>

#include "coupling/transport/memory_transport.hpp"
#include "coupling/transport/wire.hpp"
#include "tests/coupling/conversation.hpp"
#include "tests/support/deadline.hpp"

namespace stria::test {
namespace {

using coupling::RemoteFineScale;
using Trouble = FakeFineScale::Trouble;

/// Two ends; `other_side` runs a part in a thread with the far end, which dies with the part.
class MemoryConversation : public testing::Test {
protected:
    template <class Part> void other_side(Part part) {
        other_ = std::async(std::launch::async, [part, end = std::move(ends_.second)]() mutable {
            const auto own = std::move(end);  // the task itself lives on until its future is read
            part(*own);
        });
    }

    Transport& near_end() { return *ends_.first; }
    void hang_up() { ends_.first.reset(); }

    /// What became of the other side: throws what it threw.
    void join() { other_.get(); }

private:
    Deadline deadline_{std::chrono::seconds(20)};
    std::pair<std::unique_ptr<Transport>, std::unique_ptr<Transport>> ends_ = coupling::make_memory_transports();
    std::future<void> other_;
};

TEST_F(MemoryConversation, MessagesKeepTagBytesAndOrder) {
    other_side([](Transport& transport) {
        echo(transport);
        receive_many(transport);
    });
    hear_echo(near_end());
    send_many(near_end());
    join();
}

TEST_F(MemoryConversation, WhatWasSaidBeforeTheEndIsHeardAndThenTheEnd) {
    other_side(send_many);
    receive_many(near_end());
    expect_end(near_end());
    join();
    EXPECT_THROW(near_end().send(Tag::Done, {}), ComponentLost);
}

TEST_F(MemoryConversation, AWaitingSideHearsTheEnd) {
    other_side(expect_end);
    hang_up();
    join();
}

TEST_F(MemoryConversation, AServedFineScaleEqualsADirectOne) {
    for (const int unknowns : {0, 1, 40}) {
        auto [near, far] = coupling::make_memory_transports();
        FakeFineScale direct(0.3), served(0.3);
        auto server = std::async(std::launch::async, [&] { serve(*far, served, 7); });
        {
            RemoteFineScale remote(*near, 7);
            compare(direct, remote, unknowns);
            EXPECT_EQ(remote.traffic().messages, 16);  // Hello, patch, 3 iterations, commit, rollback, state: answered
        }
        server.get();
        EXPECT_EQ(std::pair(served.commits, served.rollbacks), std::pair(direct.commits, direct.rollbacks));
        EXPECT_EQ(served.reversals, 1);
    }
}

TEST_F(MemoryConversation, FailuresArriveAsTheyWereAndTheConversationGoesOn) {
    FakeFineScale fine, direct;
    other_side([&fine](Transport& transport) { serve(transport, fine, 1); });
    {
        RemoteFineScale remote(near_end(), 1);
        fine.trouble = Trouble::Numerical;
        expect_failure<NumericalFailure>(remote, "a spring broke");
        fine.trouble = Trouble::Case;
        expect_failure<CaseError>(remote, "case.toml:3: a spring of no steel");
        fine.trouble = Trouble::Numerical;
        EXPECT_THROW(remote.set_patch(patch_of(3)), NumericalFailure);
        remote.set_patch(patch_of(3));
        fine.trouble = Trouble::Numerical;
        remote.request(displacement_of(0, 3));
        EXPECT_THROW(remote.collect(), NumericalFailure);
        fine.trouble = Trouble::Numerical;
        EXPECT_THROW(remote.commit({}), NumericalFailure);
        compare(direct, remote, 5);
    }
    join();
}

TEST_F(MemoryConversation, APatchMayBeginBeforeAnybodyWaitsForIt) {
    FakeFineScale fine, direct;
    other_side([&fine](Transport& transport) { serve(transport, fine, 1); });
    {
        RemoteFineScale remote(near_end(), 1);
        const coupling::Patch patch = patch_of(3);
        remote.begin_set_patch(patch);
        EXPECT_EQ(remote.traffic().messages, 3);  // Hello, answered
        remote.set_patch(patch);
        EXPECT_EQ(remote.traffic().messages, 4);
        fine.trouble = Trouble::Numerical;
        remote.begin_set_patch(patch);
        EXPECT_THROW(remote.set_patch(patch), NumericalFailure);
        fine.trouble = Trouble::Numerical;
        remote.begin_set_patch(patch);
        EXPECT_NO_THROW(remote.rollback());  // nobody wants it any more
        compare(direct, remote, 5);
    }
    join();
}

TEST_F(MemoryConversation, WhatIsKeptIsThereWhenItIsAskedFor) {
    FakeFineScale fine;
    other_side([&fine](Transport& transport) { serve(transport, fine, 1); });
    {
        RemoteFineScale remote(near_end(), 1);
        remote.set_patch(patch_of(3));
        remote.keep();
        remote.request(displacement_of(0, 3));
        static_cast<void>(remote.collect());
        static_cast<void>(remote.commit({}));
        EXPECT_EQ(remote.kept().displacement, Eigen::VectorXd::Zero(3));
        EXPECT_NE(remote.snapshot().displacement, Eigen::VectorXd::Zero(3));
        fine.trouble = Trouble::Numerical;
        remote.keep();
        EXPECT_THROW(remote.rollback(), NumericalFailure);
    }
    join();
}

TEST_F(MemoryConversation, AnotherCaseIsRefusedOnBothSides) {
    FakeFineScale fine;
    other_side([&fine](Transport& transport) { serve(transport, fine, 1); });
    EXPECT_THROW(RemoteFineScale(near_end(), 2), CaseError);
    EXPECT_THROW(join(), CaseError);
}

TEST_F(MemoryConversation, AnotherProtocolIsRefusedOnBothSides) {
    FakeFineScale fine;
    other_side([&fine](Transport& transport) { serve(transport, fine, 1); });
    near_end().send(Tag::Hello, pack(coupling::Hello{coupling::protocol_version + 1, 1}));
    EXPECT_EQ(near_end().receive().tag, Tag::Hello);
    EXPECT_THROW(join(), ComponentLost);
}

TEST_F(MemoryConversation, AnotherProtocolIsRefusedByTheStub) {
    other_side([](Transport& transport) {
        transport.receive();
        transport.send(Tag::Hello, pack(coupling::Hello{coupling::protocol_version + 1, 1}));
    });
    EXPECT_THROW(RemoteFineScale(near_end(), 1), ComponentLost);
    join();
}

TEST_F(MemoryConversation, ABugOnTheOtherSideEndsTheConversation) {
    FakeFineScale fine;
    other_side([&fine](Transport& transport) { serve(transport, fine, 1); });
    RemoteFineScale remote(near_end(), 1);
    fine.trouble = Trouble::Bug;
    EXPECT_THROW(remote.set_patch(patch_of(3)), ComponentLost);
    EXPECT_THROW(join(), std::logic_error);
}

TEST_F(MemoryConversation, NonsenseEndsTheConversation) {
    FakeFineScale fine;
    other_side([&fine](Transport& transport) { serve(transport, fine, 1); });
    near_end().send(Tag::Hello, pack(coupling::Hello{coupling::protocol_version, 1}));
    near_end().receive();
    near_end().send(Tag::Patch, std::vector(5, std::byte{1}));
    expect_end(near_end());
    EXPECT_THROW(join(), ComponentLost);
}

TEST_F(MemoryConversation, AStubLeftInMidQuestionEndsInGoodOrder) {
    FakeFineScale fine;
    other_side([&fine](Transport& transport) { serve(transport, fine, 1); });
    {
        RemoteFineScale remote(near_end(), 1);
        remote.set_patch(patch_of(3));
        remote.request(displacement_of(0, 3));
    }
    join();
}

TEST_F(MemoryConversation, ALostCoarseSideEndsTheServer) {
    FakeFineScale fine;
    other_side([&fine](Transport& transport) { serve(transport, fine, 1); });
    near_end().send(Tag::Hello, pack(coupling::Hello{coupling::protocol_version, 1}));
    hang_up();
    EXPECT_THROW(join(), ComponentLost);
}

}  // namespace
}  // namespace stria::test
