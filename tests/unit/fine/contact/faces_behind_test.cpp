// Which faces are behind a tip.
#include "fine/contact/faces_behind.hpp"

#include <gtest/gtest.h>

namespace stria::test {
namespace {

using fine::FacesBehind;

// A node in the middle of a crack belongs to both of its tips, and one as far behind a tip as asked for to that.
TEST(FacesBehind, HoldTheirEndsByRounding) {
    for (const double rounding : {-1e-14, 0.0, 1e-14}) {
        const FacesBehind first{.crack = 0, .tip = 0.1, .from = 0.2, .to = 2.4},
            second{.crack = 0, .tip = 4.9, .from = 0.2, .to = 2.4};
        for (const FacesBehind& part : {first, second}) EXPECT_TRUE(part.contain(0, 2.5 + rounding)) << rounding;
        EXPECT_TRUE(first.contain(0, 0.3 + rounding)) << rounding;
        EXPECT_TRUE(second.contain(0, 4.7 + rounding)) << rounding;
    }
    const FacesBehind part{.crack = 0, .tip = 0.1, .from = 0.2, .to = 2.4};
    EXPECT_FALSE(part.contain(1, 2.0)) << "of another crack";
    for (const double outside : {0.299, 2.501}) EXPECT_FALSE(part.contain(0, outside));
}

}  // namespace
}  // namespace stria::test
