#include "tests/support/comparison.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>

namespace stria::test {
namespace {

using Clock = std::chrono::system_clock;

/// Since the row before it, or since its test began.
double seconds_for_this_row() {
    static const testing::TestInfo* last_test = nullptr;
    static Clock::time_point last;
    const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
    if (test != last_test) last = Clock::time_point(std::chrono::milliseconds(test->result()->start_timestamp()));
    last_test = test;
    const Clock::time_point now = Clock::now();
    const std::chrono::duration<double> passed = now - last;
    last = now;
    return passed.count();
}

std::string test_name() {
    const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
    return fmt::format("{}.{}", test->test_suite_name(), test->name());
}

}  // namespace

void verify(const Comparison& c) {
    const double scale = c.scale > 0.0 ? c.scale : std::abs(c.reference);
    EXPECT_NEAR(c.ours, c.reference, c.within * scale) << c.scene << ", " << c.quantity;
    const char* file = std::getenv("STRIA_VERIFICATION");
    if (file == nullptr) return;
    const double error = (c.ours - c.reference) / scale;
    const bool passes = std::abs(error) <= c.within;
    // One piece, so that tests that run at a time do not mix their rows.
    const std::string row = fmt::format("\"{}\",\"{}\",\"{}\",{:.12g},{:.12g},{:.6g},{:.6g},\"{}\",{:.2f},{},{}\n",
                                        c.scene, c.source, c.quantity, c.reference, c.ours, error, c.within, c.mesh,
                                        seconds_for_this_row(), passes ? "passes" : "FAILS", test_name());
    std::ofstream(file, std::ios::app) << row;
}

}  // namespace stria::test
