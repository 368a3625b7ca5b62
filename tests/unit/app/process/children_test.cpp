// Child processes: how they end, what they share, and how commands are written down for a shell.
#include "app/process/children.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <ctime>
#include <map>
#include <unistd.h>

#include "app/process/exit_code.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria {
namespace {

TEST(Children, EachTellsHowItHasEnded) {
    const test::TemporaryFolder folder;
    std::map<pid_t, int> wanted;
    for (const int code : {0, 3, 9})
        wanted[start_child({"sh", "-c", "exit " + std::to_string(code)}, {.log = folder / "log"})] = code;
    const pid_t killed = start_child({"sh", "-c", "kill -9 $$"}, {.log = folder / "log"});
    wanted[killed] = 137;
    while (!wanted.empty()) {
        const EndedChild ended = wait_for_child();
        ASSERT_TRUE(wanted.contains(ended.process));
        EXPECT_EQ(ended.code, wanted[ended.process]);
        EXPECT_EQ(ended.ours, ended.code == Done || ended.code == NumbersFailed) << ended.code;
        wanted.erase(ended.process);
    }
    EXPECT_FALSE(asked_to_end());
}

TEST(Children, RunOnTheirShareOfTheCores) {
    const test::TemporaryFolder folder;
    const std::vector<int> last = {own_cores().back()};
    start_child({"sh", "-c", "grep Cpus_allowed_list /proc/self/status"}, {.log = folder / "log", .cores = last});
    EXPECT_EQ(wait_for_child().code, Done);
    EXPECT_EQ(test::text_of(folder / "log"), "Cpus_allowed_list:\t" + std::to_string(last.front()) + "\n");
}

TEST(Children, CoresAreSharedOutEvenly) {
    using Cores = std::vector<int>;
    const Cores five = {0, 1, 4, 5, 6};
    EXPECT_EQ(share_of(five, 0, 2), (Cores{0, 1}));
    EXPECT_EQ(share_of(five, 1, 2), (Cores{4, 5, 6}));
    EXPECT_EQ(share_of(five, 0, 1), five);
    for (int part = 0; part < 5; ++part) EXPECT_EQ(share_of(five, part, 5), Cores{five[static_cast<unsigned>(part)]});
    EXPECT_EQ(share_of(five, 3, 6), five);
}

TEST(Children, AShellReadsTheWordsBack) {
    const test::TemporaryFolder folder;
    const std::vector<std::string> words = {"a=[{b=1, c='d'}]", "", "$HOME `ls` \"x\" \\", "plain-1.5/x", "it's"};
    std::string wanted;
    for (const std::string& word : words) wanted += word + '\n';
    start_child({"sh", "-c", "printf '%s\\n' " + quoted(words)}, {.log = folder / "log"});
    EXPECT_EQ(wait_for_child().code, Done);
    EXPECT_EQ(test::text_of(folder / "log"), wanted);
    EXPECT_EQ(quoted("--set"), "--set");
}

/// How a child ends that would sleep for five seconds where the user asks to end so many microseconds after it is asked
/// for; -1: before. Signals are listened to from the first child on.
int code_of_sleeper(const std::string& log, int microseconds) {
    start_child({"true"}, {.log = log});
    wait_for_child();
    if (microseconds < 0) raise(SIGTERM);
    sigevent end{};
    end.sigev_notify = SIGEV_SIGNAL;
    end.sigev_signo = SIGTERM;
    timer_t timer{};
    timer_create(CLOCK_MONOTONIC, &end, &timer);
    const itimerspec then{.it_interval = {}, .it_value = {.tv_sec = 0, .tv_nsec = 1000L * microseconds}};
    if (microseconds > 0) timer_settime(timer, 0, &then, nullptr);
    start_child({"sleep", "5"}, {.log = log});
    return wait_for_child().code;
}

// The signal comes before there is a child, between its birth and the moment at which we know of it, before it has
// become its program, or later.
TEST(ChildrenDeathTest, StartingOnesAreToldOfAnInterruption) {
    const test::TemporaryFolder folder;
    for (const int microseconds : {-1, 10, 30, 60, 100, 150, 200, 300, 400, 500, 600, 800, 1000, 1500, 2000})
        EXPECT_EXIT(_exit(code_of_sleeper(folder / "log", microseconds)), testing::ExitedWithCode(Interrupted), "")
            << microseconds;
}

}  // namespace
}  // namespace stria
