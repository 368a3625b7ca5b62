#include "common/schema/given.hpp"

#include <gtest/gtest.h>

#include "common/error.hpp"
#include "tests/support/refusal.hpp"

namespace stria::schema {
namespace {

TEST(Given, SaysWhereAndWhat) {
    const Value size{.data = 9.0, .line = 14};
    const Value entry{.data = Table{{"size", size}}, .line = 13};
    const Value root{.data = Table{{"list", {.data = List{entry}, .line = 12}}}, .line = 1};
    const Given given = Given{root, {"case.toml", ""}}.entry("list", 0);
    EXPECT_TRUE(given.has("size"));
    EXPECT_FALSE(given.has("width"));
    EXPECT_EQ(test::refusal_of([&] { given.refuse("needs width"); }), "case.toml:13: list.0 needs width");
    EXPECT_EQ(test::refusal_of([&] { given.refuse("size", "is large"); }), "case.toml:14: list.0.size is large");
    EXPECT_EQ(test::refusal_of([&] { given.refuse_value("size", "must be < 3", "mm"); }),
              "case.toml:14: list.0.size = 9 mm must be < 3");
    EXPECT_EQ(test::refusal_of([&] { given.demand(false, "size", "must be < 3"); }),
              "case.toml:14: list.0.size = 9 must be < 3");
    EXPECT_EQ(test::refusal_of([&] { given.demand(true, "width", "must be < 3"); }), "accepted");
}

}  // namespace
}  // namespace stria::schema
