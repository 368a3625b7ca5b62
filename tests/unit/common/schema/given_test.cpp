#include "common/schema/given.hpp"

#include <gtest/gtest.h>

#include "common/error.hpp"

namespace stria::schema {
namespace {

std::string text_of_error(auto act) {
    try {
        act();
    } catch (const CaseError& error) {
        return error.what();
    }
    return "none";
}

TEST(Given, SaysWhereAndWhat) {
    const Value size{.data = 9.0, .line = 14};
    const Value entry{.data = Table{{"size", size}}, .line = 13};
    const Value root{.data = Table{{"list", {.data = List{entry}, .line = 12}}}, .line = 1};
    const Given given = Given{root, {"case.toml", ""}}.entry("list", 0);
    EXPECT_TRUE(given.has("size"));
    EXPECT_FALSE(given.has("width"));
    EXPECT_EQ(text_of_error([&] { given.refuse("needs width"); }), "case.toml:13: list.0 needs width");
    EXPECT_EQ(text_of_error([&] { given.refuse("size", "is large"); }), "case.toml:14: list.0.size is large");
    EXPECT_EQ(text_of_error([&] { given.refuse_value("size", "must be < 3", "mm"); }),
              "case.toml:14: list.0.size = 9 mm must be < 3");
    EXPECT_EQ(text_of_error([&] { given.demand(false, "size", "must be < 3"); }),
              "case.toml:14: list.0.size = 9 must be < 3");
    EXPECT_EQ(text_of_error([&] { given.demand(true, "width", "must be < 3"); }), "none");
}

}  // namespace
}  // namespace stria::schema
