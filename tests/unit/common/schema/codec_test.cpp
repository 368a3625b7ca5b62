// Members of every type are written as they are read, and what is of another type is refused.
#include "common/schema/codec.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/refusal.hpp"

namespace stria::schema {
namespace {

const Place here{"case.toml", "key"};

template <class Data> Value line_1(const Data& data) {
    Value value;
    value.data = data;
    value.line = 1;
    return value;
}

template <class M> M read_as(const Value& value, const Key& key = {}) {
    M out{};
    decode(value, key, here, out);
    return out;
}

template <class M, class Data> std::string refused_as(const Data& data, const Key& key = {}) {
    return test::refusal_of([&] { return read_as<M>(line_1(data), key); });
}

template <class M> void expect_round_trip(const M& member) {
    const std::optional<Value> written = encode(member);
    ASSERT_TRUE(written);
    EXPECT_EQ(read_as<M>(*written), member) << to_toml(*written);
}

List list_of_numbers(std::initializer_list<double> numbers) {
    List list;
    for (const double number : numbers) list.push_back(line_1(number));
    return list;
}

TEST(Codec, ReadsWhatItWrites) {
    expect_round_trip(0.1);
    expect_round_trip(-3);
    expect_round_trip(true);
    expect_round_trip(std::string("a \"b\""));
    expect_round_trip(std::vector{1.0, -2.5});
    expect_round_trip(Vec2(1.0, 2.0));
    expect_round_trip(Eigen::Matrix2d{{1.0, 2.0}, {3.0, 4.0}});
    expect_round_trip(std::vector<Vec2>{{1.0, 2.0}, {3.0, 4.0}});
    expect_round_trip(std::array<std::optional<double>, 2>{std::nullopt, 4.0});
    expect_round_trip(std::optional(2.5));
}

TEST(Codec, WritesNothingOfWhatIsAbsent) {
    EXPECT_FALSE(encode(std::optional<double>()));
    EXPECT_FALSE(encode(std::array<std::optional<double>, 2>()));
}

TEST(Codec, TakesWholeNumbersForNumbersAndASinglePointForAList) {
    EXPECT_EQ(read_as<double>(line_1(std::int64_t{3})), 3.0);
    EXPECT_EQ(read_as<int>(line_1(3.0)), 3);
    EXPECT_EQ(read_as<std::vector<Vec2>>(line_1(list_of_numbers({1.0, 2.0}))), (std::vector<Vec2>{{1.0, 2.0}}));
}

TEST(Codec, ReplacesWhatWasThere) {
    std::vector numbers{7.0};
    decode(line_1(list_of_numbers({1.0, 2.0})), {}, here, numbers);
    EXPECT_EQ(numbers, (std::vector{1.0, 2.0}));
    std::vector<Vec2> points{{7.0, 7.0}};
    decode(line_1(list_of_numbers({1.0, 2.0})), {}, here, points);
    EXPECT_EQ(points, (std::vector<Vec2>{{1.0, 2.0}}));
    std::array<std::optional<double>, 2> displacement{7.0, 7.0};
    decode(*encode(std::array<std::optional<double>, 2>{std::nullopt, 4.0}), {}, here, displacement);
    EXPECT_EQ(displacement, (std::array<std::optional<double>, 2>{std::nullopt, 4.0}));
}

TEST(Codec, TakesTablesAndListsForWhatTheyAre) {
    EXPECT_EQ(list_of(line_1(list_of_numbers({1.0})), {}, here).size(), 1U);
    EXPECT_TRUE(table_of(line_1(Table{}), {}, here).empty());
    EXPECT_EQ(test::refusal_of([&] { table_of(line_1(1.0), {}, here); }),
              "case.toml:1: key = 1 must be a table { key = value, ... }");
    EXPECT_EQ(test::refusal_of([&] { list_of(line_1(1.0), {}, here); }),
              "case.toml:1: key = 1 must be a list of tables [ { ... }, ... ]");
}

TEST(Codec, RefusesWhatIsOfAnotherType) {
    EXPECT_EQ(refused_as<double>(std::string("3")), R"(case.toml:1: key = "3" must be a number)");
    EXPECT_EQ(refused_as<double>(std::numeric_limits<double>::infinity()), "case.toml:1: key = inf must be finite");
    EXPECT_EQ(refused_as<int>(2.5), "case.toml:1: key = 2.5 must be a whole number");
    EXPECT_EQ(refused_as<int>(3e9), "case.toml:1: key = 3000000000 must be a whole number");
    EXPECT_EQ(refused_as<bool>(1.0), "case.toml:1: key = 1 must be true or false");
    EXPECT_EQ(refused_as<Vec2>(list_of_numbers({1.0, 2.0, 3.0})),
              "case.toml:1: key = [1.0, 2.0, 3.0] must be two numbers [x, y]");
    EXPECT_NE(refused_as<std::vector<Vec2>>(List{}), "accepted");
    List fixed = list_of_numbers({1.0});
    fixed.push_back(line_1(std::string("fixed")));
    EXPECT_NE((refused_as<std::array<std::optional<double>, 2>>(fixed)), "accepted");
}

TEST(Codec, HoldsNumbersToTheRulesOfTheirKey) {
    Key key;
    key.positive();
    EXPECT_EQ(refused_as<double>(0.0, key), "case.toml:1: key = 0 must be > 0");
    EXPECT_EQ(refused_as<int>(-1.0, key), "case.toml:1: key = -1 must be > 0");
    EXPECT_EQ(refused_as<std::vector<double>>(list_of_numbers({1.0, 0.0}), key),
              "case.toml:1: key = [1.0, 0.0] must hold numbers > 0");
}

TEST(Codec, HoldsTextsToTheWordsOfTheirKey) {
    Key key;
    key.one_of({"strain", "stress"});
    EXPECT_EQ(read_as<std::string>(line_1(std::string("stress")), key), "stress");
    EXPECT_EQ(refused_as<std::string>(std::string("shear"), key),
              R"(case.toml:1: key = "shear" must be one of strain, stress)");
    EXPECT_EQ(refused_as<std::string>(std::string("shear"), Key().one_of({"N-mm-MPa"})),
              R"(case.toml:1: key = "shear" must be "N-mm-MPa")");
}

}  // namespace
}  // namespace stria::schema
