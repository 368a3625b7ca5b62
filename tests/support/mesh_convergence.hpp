// What is left of an error as elements are halved, for rows whose distance from a reference is asked to be no more.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace stria::test {

/// Of the finest of three meshes, each with elements half as large as those of the one before, as a share of its value:
/// 1.25 times the rest of the geometric series that their changes begin (P. J. Roache's grid convergence index).
/// Bilinear elements are of second order: where changes fall faster than to a quarter they will not go on so. Fails
/// where they do not fall to three quarters at least: these meshes tell no limit. Three times the last change where
/// they go to and fro.
[[nodiscard]] inline double error_of_finest(const std::array<double, 3>& on) {
    const double change = on[2] - on[1], ratio = change / (on[1] - on[0]);
    EXPECT_LT(std::abs(ratio), 0.75) << on[0] << ' ' << on[1] << ' ' << on[2];
    const double slower = std::max(ratio, 0.25), rest = ratio > 0.0 ? 1.25 * slower / (1.0 - slower) : 3.0;
    return std::abs(rest * change / on[2]);
}

}  // namespace stria::test
