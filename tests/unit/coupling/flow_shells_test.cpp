// What of the flow about a tip is its own.
#include <gtest/gtest.h>

#include "coupling/flow_shells.hpp"

namespace stria::coupling {
namespace {

FlowShell shell(double begin, double end) { return {begin, end, end - 0.25, 0.5 * end}; }

TEST(FlowShells, JoinWhereTheyOverlap) {
    const std::vector<FlowShell> all = joined({shell(3.1, 8.0), shell(1.4, 3.0), shell(0.0, 1.0), shell(0.5, 1.5)});
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(all[0].begin, 0.0);
    EXPECT_EQ(all[0].end, 3.0);
    EXPECT_EQ(all[0].reach, 2.75);
    EXPECT_EQ(all[0].axis, 1.5);
    EXPECT_EQ(all[1].reach, 7.75);
}

// Of equal elements one lies between exactly, and by rounding a little more or less.
TEST(FlowShells, AreApartWhereAnElementLiesBetween) {
    for (const double rounding : {-1e-12, 0.0, 1e-12}) {
        EXPECT_EQ(joined({shell(0.0, 2.0 + rounding), shell(2.0, 3.0)}).size(), 2U) << rounding;
        EXPECT_EQ(shell_at_tip({shell(0.4 + rounding, 1.0)}, 0.2).reach, 0.0) << rounding;
        EXPECT_EQ(shell_at_tip({shell(0.1, 2.0 + rounding), shell(2.0, 3.0)}, 0.2).reach, 1.75 + rounding);
    }
}

// However the elements are shared out among ranks.
TEST(FlowShells, AreThoseOfTheWholeInAnyParts) {
    const std::vector<FlowShell> elements{shell(0.3, 1.0), shell(0.9, 2.0), shell(1.9, 4.5), shell(5.0, 13.0),
                                          shell(20.0, 22.0)};
    for (unsigned parts = 0; parts < 32; ++parts) {
        std::vector<FlowShell> first, second;
        for (unsigned k = 0; k < 5; ++k) ((parts >> k) % 2 == 0 ? first : second).push_back(elements[k]);
        std::vector<FlowShell> both = joined(std::move(first));
        for (const FlowShell& other : joined(std::move(second))) both.push_back(other);
        const FlowShell own = shell_at_tip(joined(std::move(both)), 0.2);
        EXPECT_EQ(own.reach, 4.25) << parts;
        EXPECT_EQ(own.axis, 2.25) << parts;
    }
}

TEST(FlowShells, BeginAtMostTwoElementsFromTheirTip) {
    EXPECT_EQ(shell_at_tip({shell(0.3, 1.0)}, 0.2).reach, 0.75);
    EXPECT_EQ(shell_at_tip({shell(0.5, 1.0)}, 0.2).reach, 0.0) << "flow, but not at this tip";
    EXPECT_EQ(shell_at_tip({}, 0.2).reach, 0.0);
}

}  // namespace
}  // namespace stria::coupling
