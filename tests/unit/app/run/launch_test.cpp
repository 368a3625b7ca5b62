// The command that starts the components.
#include "app/run/launch.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace stria {
namespace {

using Words = std::vector<std::string>;

/// Two programs, each with its number: that of the structure alone where the case needs no zone.
Words started(int fine_ranks, bool with_fine = true) {
    RunOptions options;
    options.case_path = "case.toml";
    options.output_directory = "out";
    options.fine_ranks = fine_ranks;
    return launch_command(options, "bin", with_fine);
}

TEST(LaunchCommand, StartsTheStructureAloneWhereNoZoneIsNeeded) {
    EXPECT_EQ(started(3, false), (Words{"bin/stria-coarse", "case.toml", "-o", "out", "--no-report"}));
}

TEST(LaunchCommand, StartsTwoProgramsForOneFineRank) {
    EXPECT_EQ(started(1),
              (Words{"mpirun", "--quiet", "-n", "1", "bin/stria-coarse", "case.toml", "-o", "out", "--no-report", ":",
                     "-n", "1", "bin/stria-fine", "case.toml", "-o", "out", "--no-report"}));
}

// One of several lives with the structure: as many programs as ranks.
TEST(LaunchCommand, StartsAsManyProgramsAsFineRanks) {
    const Words three = started(3);
    const auto colon = std::ranges::find(three, ":");
    ASSERT_NE(colon, three.end());
    EXPECT_EQ(Words(colon - 2, colon), (Words{"--no-report", "--own-rank"}));
    EXPECT_EQ(Words(colon + 1, colon + 4), (Words{"-n", "2", "bin/stria-fine"}));
    EXPECT_EQ(std::ranges::count(three, "--own-rank"), 1);
}

// Open MPI takes 4 MiB of shared memory for each process, and the bells of the components a page or two.
TEST(WayOfMessages, IsTheLoopbackInterfaceWhereSharedMemoryIsShort) {
    constexpr std::uint64_t MiB = 1 << 20;
    EXPECT_EQ(way_of_messages(2, 64 * MiB), WayOfMessages::Memory);
    EXPECT_EQ(way_of_messages(16, 64 * MiB), WayOfMessages::Loopback);
    EXPECT_EQ(way_of_messages(2, 4 * MiB), WayOfMessages::Loopback);
    EXPECT_EQ(way_of_messages(2, 16384), WayOfMessages::Loopback);
    EXPECT_EQ(way_of_messages(2, 4096), WayOfMessages::None);
}

TEST(PartsOfARun, AreAsManyAsItsModeHas) {
    const auto counted = [](RunMode mode, int fine_ranks, bool with_fine = true) {
        RunOptions options;
        options.mode = mode;
        options.fine_ranks = fine_ranks;
        const RunParts parts = parts_of(options, with_fine);
        return std::pair(parts.fine_ranks, parts.processes);
    };
    EXPECT_EQ(counted(RunMode::Mpi, 1), std::pair(1, 2));
    EXPECT_EQ(counted(RunMode::Mpi, 3), std::pair(3, 3));
    EXPECT_EQ(counted(RunMode::Mpi, 3, false), std::pair(0, 1));
    EXPECT_EQ(counted(RunMode::InProcess, 3), std::pair(3, 1));
    EXPECT_EQ(counted(RunMode::Monolithic, 1), std::pair(0, 1));
}

}  // namespace
}  // namespace stria
