// The exit code that goes past mpirun.
#include "app/process/told_exit.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace stria {
namespace {

TEST(ToldExit, GoesPastMpirun) {
    const ToldExit told;
    EXPECT_EQ(told.code_or(0), 0) << "nobody has told anything";
    EXPECT_EQ(tell_exit(3), 0);
    EXPECT_EQ(told.code_or(0), 3);
    EXPECT_EQ(told.code_or(4), 4) << "mpirun knows better: another component was lost";
}

TEST(ToldExit, OfSuccessNothingIsTold) {
    const ToldExit told;
    EXPECT_EQ(tell_exit(0), 0);
    EXPECT_EQ(told.code_or(0), 0);
}

TEST(ToldExit, StaysWhereNobodyListens) {
    EXPECT_EQ(tell_exit(3), 3);
    std::string file;
    {
        const ToldExit told;
        file = std::getenv("STRIA_TELL_EXIT");
        EXPECT_TRUE(std::filesystem::exists(file));
    }
    EXPECT_FALSE(std::filesystem::exists(file));
    EXPECT_EQ(tell_exit(3), 3);
    setenv("STRIA_TELL_EXIT", file.c_str(), 1);  // mpirun has started us on another machine
    EXPECT_EQ(tell_exit(3), 3);
    EXPECT_FALSE(std::filesystem::exists(file));
    unsetenv("STRIA_TELL_EXIT");
}

}  // namespace
}  // namespace stria
