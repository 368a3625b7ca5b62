// How a mode is said.
#include "app/results/run_mode.hpp"

#include <gtest/gtest.h>

#include "tests/support/refusal.hpp"

namespace stria {
namespace {

TEST(RunModes, AreReadAsTheyAreSaid) {
    for (const RunMode mode : {RunMode::Mpi, RunMode::InProcess, RunMode::Monolithic})
        EXPECT_EQ(run_mode(to_text(mode), "mode"), mode);
    EXPECT_EQ(to_text(RunMode::InProcess), "inprocess");
}

TEST(RunModes, OfAnotherNameAreRefused) {
    for (const char* word : {"", "MPI", "in process", "mono"})
        EXPECT_EQ(test::refusal_of([&] { return run_mode(word, "mode"); }),
                  std::string("mode=") + word + ": must be mpi, inprocess or monolithic");
}

}  // namespace
}  // namespace stria
