// The few lines of JSON that results need.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace stria {

/// A JSON value to be written; objects keep the order of their members. Numbers that are not finite become null.
class Json {
public:
    struct Member;
    using Array = std::vector<Json>;
    using Object = std::vector<Member>;

    Json() = default;  // null
    Json(bool value) : value_(value) {}
    Json(int value) : value_(std::int64_t{value}) {}
    Json(std::int64_t value) : value_(value) {}
    Json(double value) : value_(value) {}
    Json(const char* value) : value_(std::string(value)) {}
    Json(std::string value) : value_(std::move(value)) {}
    Json(Array values) : value_(std::move(values)) {}
    Json(Object members) : value_(std::move(members)) {}

    /// Text with an indent of two spaces, one member per line, ended by a line break.
    [[nodiscard]] std::string text() const;

private:
    void append_to(std::string& text, const std::string& indent) const;

    std::variant<std::monostate, bool, std::int64_t, double, std::string, Array, Object> value_;
};

struct Json::Member {
    std::string key;
    Json value;
};

/// The file is written whole or not at all.
void write_json(const std::filesystem::path& path, const Json& value);

}  // namespace stria
