// What a key allows, and what is said of a value that it does not.
#include "common/schema/key.hpp"

#include <gtest/gtest.h>

#include "tests/support/refusal.hpp"

namespace stria::schema {
namespace {

TEST(Keys, SayTheirRange) {
    EXPECT_EQ(Key().positive().range(), "> 0");
    EXPECT_EQ(Key().at_least(0.0).below(0.5).range(), ">= 0 and < 0.5");
    EXPECT_EQ(Key().at_most(1.0).even().range(), "<= 1 and even");
    EXPECT_EQ(Key().one_of({"strain", "stress"}).range(), "strain | stress");
    EXPECT_EQ(Key().range(), "");
}

TEST(Keys, RulesHoldUpToTheirBounds) {
    const auto holds = [](const Key& key, double number) { return key.rules.back().holds(number); };
    EXPECT_FALSE(holds(Key().positive(), 0.0));
    EXPECT_TRUE(holds(Key().at_least(2.0), 2.0));
    EXPECT_FALSE(holds(Key().below(2.0), 2.0));
    EXPECT_TRUE(holds(Key().at_most(2.0), 2.0));
    EXPECT_FALSE(holds(Key().even(), 3.0));
    for (const double power : {1.0, 2.0, 64.0}) EXPECT_TRUE(holds(Key().power_of_two(), power)) << power;
    for (const double other : {0.5, 0.0, 6.0, -2.0}) EXPECT_FALSE(holds(Key().power_of_two(), other)) << other;
}

TEST(Keys, OfARefusedValueTellPlaceValueAndUnit) {
    const Place place = Place{"case.toml", ""}.inside("material").inside("yield_stress");
    const Key key{.unit = "MPa"};
    const auto said_of = [&](const auto& data, int line) {
        Value value;
        value.data = data;
        value.line = line;
        return test::refusal_of([&] { reject(place, value, key, "must be > 0"); });
    };
    EXPECT_EQ(said_of(-350.0, 14), "case.toml:14: material.yield_stress = -350 MPa must be > 0");
    EXPECT_EQ(said_of(std::string("high"), 0), R"(--set: material.yield_stress = "high" must be > 0)");
    const std::string said = said_of(std::string(100, 'x'), 2);
    EXPECT_NE(said.find("xx... must be"), std::string::npos) << said;
    EXPECT_LT(said.size(), 120U);
}

}  // namespace
}  // namespace stria::schema
