#include "tests/support/comparison.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <ctime>
#include <fstream>

namespace stria::test {
namespace {

/// CPU time since the row before it, or since the program began: the table's tests run in a program each, and a machine
/// that does other things too tells nothing by its clock.
double seconds_for_this_row() {
    static std::clock_t last = 0;
    const std::clock_t passed = std::clock() - last;
    last += passed;
    return static_cast<double>(passed) / CLOCKS_PER_SEC;
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
