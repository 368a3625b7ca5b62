// Text of JSON values.
#include "common/io/json.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stria {
namespace {

TEST(JsonText, IsOrderedEscapedAndFinite) {
    const Json value{
        {"z", 1}, {"a", {true, nullptr, std::nan(""), 0.1}}, {"t", "say \"hi\"\n\\\x01\xff"}, {"none", Json::object()}};
    EXPECT_EQ(text_of(value), "{\n  \"z\": 1,\n  \"a\": [\n    true,\n    null,\n    null,\n    0.1\n  ],\n"
                              "  \"t\": \"say \\\"hi\\\"\\n\\\\\\u0001\xef\xbf\xbd\",\n  \"none\": {}\n}\n");
}

}  // namespace
}  // namespace stria
