// Text of JSON values.
#include "common/io/json.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stria {
namespace {

TEST(JsonText, IsOrderedEscapedAndFinite) {
    const Json value = Json::Object{{"z", 1},
                                    {"a", Json::Array{true, Json(), std::nan(""), 0.1}},
                                    {"t", "say \"hi\"\n\\\x01"},
                                    {"none", Json::Object{}}};
    EXPECT_EQ(value.text(), "{\n  \"z\": 1,\n  \"a\": [\n    true,\n    null,\n    null,\n    0.1\n  ],\n"
                            "  \"t\": \"say \\\"hi\\\"\\n\\\\\\u0001\",\n  \"none\": {}\n}\n");
}

}  // namespace
}  // namespace stria
