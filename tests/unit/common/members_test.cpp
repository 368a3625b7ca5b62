// The members of a struct, visited by name.
#include "common/members.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace stria::test {

struct Tally {
    int many = 0;
    double much = 0.0;
    int last = 0;
};
STRIA_MEMBERS(Tally, many, much, last)

namespace {

TEST(Members, AreVisitedInOrderByTheirNames) {
    const Tally tally{3, 0.5, 7};
    std::vector<std::string> names;
    std::vector<double> values;
    for_each_member(tally, [&](std::string_view name, auto value) {
        names.emplace_back(name);
        values.push_back(value);
    });
    EXPECT_EQ(names, (std::vector<std::string>{"many", "much", "last"}));
    EXPECT_EQ(values, (std::vector<double>{3.0, 0.5, 7.0}));
}

TEST(Members, AreWrittenToAndAddedUpOneByOne) {
    Tally sum{1, 0.25, 2};
    add_members(sum, {10, 1.0, 20});
    EXPECT_EQ(sum.many, 11);
    EXPECT_EQ(sum.much, 1.25);
    EXPECT_EQ(sum.last, 22);
    for_each_member(sum, [](std::string_view name, auto& value) { value = name == "last" ? 5 : 0; });
    EXPECT_EQ(sum.many, 0);
    EXPECT_EQ(sum.last, 5);
}

}  // namespace
}  // namespace stria::test
