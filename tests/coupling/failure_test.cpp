// What happens when one side fails: the run ends in time with the exit code users know, and exceptions keep their type.
#include <gtest/gtest.h>

#include <algorithm>
#include <future>

#include "coarse/equilibrium/condensed/condensed_factory.hpp"
#include "common/error.hpp"
#include "coupling/transport/memory_transport.hpp"
#include "coupling/transport/remote_fine_scale.hpp"
#include "coupling/transport/serve.hpp"
#include "tests/support/deadline.hpp"
#include "tests/support/fails_sometimes.hpp"
#include "tests/support/plates.hpp"
#include "tests/support/program.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/sent_analysis.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/whole_tangent.hpp"

namespace stria::test {
namespace {

using std::chrono::seconds;

/// The process id of the one program of that name that a run has started.
pid_t wait_for_start(const Program& run, const std::string& name) {
    for (int k = 0; k < 2000; ++k) {
        if (const auto found = descendants(run.pid(), name); !found.empty()) return found.front();
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return -1;
}

/// Lines of a file, once there are that many of them.
bool wait_for_lines(const std::string& path, std::ptrdiff_t lines) {
    for (int k = 0; k < 4000; ++k) {
        if (std::ranges::count(text_of(path), '\n') >= lines) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
}

/// A killed component ends the run: a run that takes half a minute is shot in its first increments.
class KilledComponent : public testing::TestWithParam<const char*> {};

TEST_P(KilledComponent, EndsTheRunInTime) {
    const TemporaryFolder folder;
    Program run("stria", {"run", shipped_sent, "-o", folder / "results", "--set", "load.steps=400"}, folder / "log");
    ASSERT_TRUE(wait_for_lines(folder / "results/history.csv", 3)) << run.said();
    const pid_t victim = wait_for_start(run, GetParam());
    ASSERT_GT(victim, 0);
    ASSERT_EQ(kill(victim, SIGKILL), 0);
    EXPECT_EQ(run.wait(seconds(20)), 4) << run.said();
    EXPECT_TRUE(descendants(run.pid(), "stria-coarse").empty());
    EXPECT_TRUE(descendants(run.pid(), "stria-fine").empty());
}

INSTANTIATE_TEST_SUITE_P(Either, KilledComponent, testing::Values("stria-fine", "stria-coarse"),
                         [](const auto& test) { return std::string(test.param).substr(6); });

TEST(SeveralFineRanks, AreRefusedByTheMonolithicMode) {
    const TemporaryFolder folder;
    EXPECT_EQ(run_program("stria", {"run", shipped_sent, "--mode", "monolithic", "--fine", "2"}, folder / "log"), 2);
    EXPECT_NE(text_of(folder / "log").find("has no fine ranks"), std::string::npos);
}

/// A zone of steel that is asked for a displacement beyond all numbers.
class FailureInTheZone : public testing::Test {
protected:
    static std::string complaint(coupling::FineScale& fine, const coupling::Patch& patch) {
        fine.set_patch(patch);
        Eigen::VectorXd boundary = Eigen::VectorXd::Zero(std::ssize(patch.boundary));
        boundary[0] = 1e300;
        fine.request({.iteration = 0, .predictor = 0.0, .boundary = boundary});
        return refusal_of<NumericalFailure>([&] { return fine.collect(); });
    }
    static coupling::PatchResponse rest(coupling::FineScale& fine, const coupling::Patch& patch) {
        fine.request({.iteration = 0, .predictor = 0.0, .boundary = Eigen::VectorXd::Zero(std::ssize(patch.boundary))});
        return fine.collect();
    }
    const Deadline deadline_{seconds(20)};
};

TEST_F(FailureInTheZone, IsTheSameExceptionThroughATransport) {
    const Case input = plate_case({{0.0, 2.4}, {3.3, 2.6}});
    const coupling::Patch patch = plate_patch(plate_mesh(6, 5, input));
    auto [coarse_end, fine_end] = coupling::make_memory_transports();
    auto server = std::async(std::launch::async, [&input, end = std::move(fine_end)] {
        fine::FineModel model(input);
        coupling::serve(*end, model, 1);
    });
    fine::FineModel direct(input);
    const std::string text = complaint(direct, patch);
    EXPECT_NE(text, "accepted");
    {
        coupling::RemoteFineScale remote(*coarse_end, 1);
        EXPECT_EQ(complaint(remote, patch), text);
        remote.rollback();
        direct.rollback();
        EXPECT_EQ(whole(rest(remote, patch).tangent), whole(rest(direct, patch).tangent));  // and both work on
    }
    server.get();
}

// What holds the zone has a force once the zone has answered. The sentence on what failed asks for the displacement.
TEST(FailureOfTheFirstIterate, IsSaidWhereTheZoneIsHeld) {
    Case input = sent_case({mesh_at_tip(2.0), "fine.radius=500.0"});
    input.boundaries.back().traction.reset();
    input.boundaries.back().displacement = {0.0, 0.0};
    FailsSometimes fine(input);
    fine.fails = true;
    coarse::CondensedFactory factory(&fine, input);
    const std::string failure = refusal_of<NumericalFailure>([&] { return run_analysis(input, factory); });
    EXPECT_NE(failure.find("no increment has converged"), std::string::npos) << failure;
}

}  // namespace
}  // namespace stria::test
