// A value as a case file gives it, and its text.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace stria::schema {

struct Value;
struct Member;
using List = std::vector<Value>;
using Table = std::vector<Member>;  // in the order of the file

/// A value as the file gives it, with its line, so that every complaint can point at it.
struct Value {
    std::variant<std::monostate, bool, std::int64_t, double, std::string, List, Table> data;
    int line = 0;  // 0: set on the command line
};

struct Member {
    std::string name;
    Value value;
};

/// The TOML text of a value; numbers keep every digit.
std::string to_toml(const Value& value);
const Value* find(const Value& table, std::string_view name);

/// A text as TOML has it.
std::string quoted(const std::string& text);

/// Nothing where it is none.
std::optional<double> number_of(const Value& value);

}  // namespace stria::schema
