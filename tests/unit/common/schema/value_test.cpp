// A value and its text.
#include "common/schema/value.hpp"

#include <gtest/gtest.h>

namespace stria::schema {
namespace {

template <class Data> Value value_of(const Data& data) {
    Value value;
    value.data = data;
    return value;
}

template <class Data> std::string text_of(const Data& data) { return to_toml(value_of(data)); }

template <class... Data> List list_with(const Data&... data) {
    List list;
    (list.push_back(value_of(data)), ...);
    return list;
}

Table table_with(const std::string& name, const Value& value, const std::string& second, const Value& other) {
    Table table(2);
    table[0].name = name, table[0].value = value;
    table[1].name = second, table[1].value = other;
    return table;
}

TEST(Values, AreWrittenAsTomlReadsThem) {
    EXPECT_EQ(text_of(true), "true");
    EXPECT_EQ(text_of(std::int64_t{3}), "3");
    EXPECT_EQ(text_of(3.0), "3.0") << "no whole number";
    EXPECT_EQ(text_of(0.1 + 0.2), "0.30000000000000004") << "every digit";
    EXPECT_EQ(text_of(1e300), "1e+300");
    EXPECT_EQ(text_of(list_with(1.5, std::string("free"))), R"([1.5, "free"])");
    EXPECT_EQ(text_of(Table{}), "{}");
    EXPECT_EQ(text_of(table_with("at", value_of(List()), "on", value_of(false))), "{ at = [], on = false }");
}

TEST(Values, QuoteWhatWouldEndATextOrALine) { EXPECT_EQ(quoted("a\"b\\c\n\x7f"), R"("a\"b\\c\u000a\u007f")"); }

TEST(Values, AreFoundInTablesByTheirNames) {
    const Value table = value_of(table_with("a", value_of(1.0), "b", value_of(2.0)));
    ASSERT_NE(find(table, "b"), nullptr);
    EXPECT_EQ(number_of(*find(table, "b")), 2.0);
    EXPECT_EQ(find(table, "c"), nullptr);
    EXPECT_EQ(find(value_of(1.0), "a"), nullptr) << "no table";
}

TEST(Values, AreNumbersWholeOrNot) {
    EXPECT_EQ(number_of(value_of(std::int64_t{-2})), -2.0);
    EXPECT_EQ(number_of(value_of(-2.5)), -2.5);
    EXPECT_FALSE(number_of(value_of(std::string("2"))));
    EXPECT_FALSE(number_of(value_of(true)));
}

}  // namespace
}  // namespace stria::schema
