#include "common/schema/codec.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <initializer_list>
#include <limits>

#include "common/index.hpp"

namespace stria::schema {
namespace {

double finite_number(const Value& value, const Key& key, const Place& place, const char* demand) {
    const std::optional<double> number = number_of(value);
    if (!number) reject(place, value, key, demand);
    if (!std::isfinite(*number)) reject(place, value, key, "must be finite");
    return *number;
}

const List& list_of_length(const Value& value, std::size_t length, const Key& key, const Place& place,
                           const char* demand) {
    const auto* list = std::get_if<List>(&value.data);
    if (list == nullptr || list->size() != length) reject(place, value, key, demand);
    return *list;
}

Vec2 pair_of_numbers(const Value& value, const Key& key, const Place& place, const char* demand) {
    const List& list = list_of_length(value, 2, key, place, demand);
    return {finite_number(list[0], key, place, demand), finite_number(list[1], key, place, demand)};
}

List numbers(std::initializer_list<double> all) {
    List list;
    for (const double number : all) list.emplace_back().data = number;
    return list;
}

}  // namespace

void decode(const Value& value, const Key& key, const Place& place, double& out) {
    out = finite_number(value, key, place, "must be a number");
    for (const Rule& rule : key.rules)
        if (!rule.holds(out)) reject(place, value, key, "must be " + rule.text);
}

void decode(const Value& value, const Key& key, const Place& place, int& out) {
    const double number = finite_number(value, key, place, "must be a whole number");
    if (number != std::floor(number) || std::abs(number) > std::numeric_limits<int>::max())
        reject(place, value, key, "must be a whole number");
    for (const Rule& rule : key.rules)
        if (!rule.holds(number)) reject(place, value, key, "must be " + rule.text);
    out = static_cast<int>(number);
}

void decode(const Value& value, const Key& key, const Place& place, bool& out) {
    const auto* truth = std::get_if<bool>(&value.data);
    if (truth == nullptr) reject(place, value, key, "must be true or false");
    out = *truth;
}

void decode(const Value& value, const Key& key, const Place& place, std::vector<double>& out) {
    constexpr auto demand = "must be a list of numbers [a, b, ...]";
    const auto* list = std::get_if<List>(&value.data);
    if (list == nullptr) reject(place, value, key, demand);
    out.clear();
    for (const Value& entry : *list) {
        out.push_back(finite_number(entry, key, place, demand));
        for (const Rule& rule : key.rules)
            if (!rule.holds(out.back())) reject(place, value, key, "must hold numbers " + rule.text);
    }
}

void decode(const Value& value, const Key& key, const Place& place, std::string& out) {
    const auto* text = std::get_if<std::string>(&value.data);
    const bool listed = text != nullptr && (key.words.empty() || std::ranges::count(key.words, *text) > 0);
    if (!listed && key.words.size() == 1) reject(place, value, key, "must be " + quoted(key.words.front()));
    if (!listed && !key.words.empty())
        reject(place, value, key, fmt::format("must be one of {}", fmt::join(key.words, ", ")));
    if (!listed) reject(place, value, key, "must be a text in quotes");
    out = *text;
}

void decode(const Value& value, const Key& key, const Place& place, Vec2& out) {
    out = pair_of_numbers(value, key, place, "must be two numbers [x, y]");
}

void decode(const Value& value, const Key& key, const Place& place, Eigen::Matrix2d& out) {
    constexpr auto demand = "must be a matrix [[xx, xy], [yx, yy]]";
    const List& rows = list_of_length(value, 2, key, place, demand);
    for (int row = 0; row < 2; ++row) out.row(row) = pair_of_numbers(rows[at(row)], key, place, demand);
}

void decode(const Value& value, const Key& key, const Place& place, std::vector<Vec2>& out) {
    constexpr auto demand = "must be a list of points [[x, y], ...]";
    const auto* list = std::get_if<List>(&value.data);
    if (list == nullptr || list->empty()) reject(place, value, key, demand);
    out.clear();
    if (number_of(list->front())) {  // a single point may go without the outer brackets
        out.push_back(pair_of_numbers(value, key, place, demand));
        return;
    }
    for (const Value& point : *list) out.push_back(pair_of_numbers(point, key, place, demand));
}

void decode(const Value& value, const Key& key, const Place& place, std::array<std::optional<double>, 2>& out) {
    constexpr auto demand = "must be two entries, each a number or \"free\"";
    const List& list = list_of_length(value, 2, key, place, demand);
    for (std::size_t axis = 0; axis < 2; ++axis) {
        out[axis].reset();
        const auto* word = std::get_if<std::string>(&list[axis].data);
        if (word == nullptr || *word != "free") out[axis] = finite_number(list[axis], key, place, demand);
    }
}

const Table& table_of(const Value& value, const Key& key, const Place& place) {
    const auto* table = std::get_if<Table>(&value.data);
    if (table == nullptr) reject(place, value, key, "must be a table { key = value, ... }");
    return *table;
}

const List& list_of(const Value& value, const Key& key, const Place& place) {
    const auto* list = std::get_if<List>(&value.data);
    if (list == nullptr) reject(place, value, key, "must be a list of tables [ { ... }, ... ]");
    return *list;
}

std::optional<Value> encode(double number) { return Value{.data = number}; }
std::optional<Value> encode(int number) { return Value{.data = std::int64_t{number}}; }
std::optional<Value> encode(bool truth) { return Value{.data = truth}; }
std::optional<Value> encode(const std::string& text) { return Value{.data = text}; }
std::optional<Value> encode(const Vec2& point) { return Value{.data = numbers({point.x(), point.y()})}; }

std::optional<Value> encode(const std::vector<double>& all) {
    List list;
    for (const double number : all) list.emplace_back().data = number;
    return Value{.data = std::move(list)};
}

std::optional<Value> encode(const Eigen::Matrix2d& matrix) {
    List rows;
    for (const int row : {0, 1}) rows.emplace_back().data = numbers({matrix(row, 0), matrix(row, 1)});
    return Value{.data = std::move(rows)};
}

std::optional<Value> encode(const std::vector<Vec2>& points) {
    List list;
    for (const Vec2& point : points) list.push_back(*encode(point));
    return Value{.data = std::move(list)};
}

std::optional<Value> encode(const std::array<std::optional<double>, 2>& displacement) {
    if (!displacement[0] && !displacement[1]) return std::nullopt;
    List list;
    for (const std::optional<double>& component : displacement)
        list.push_back(component ? *encode(*component) : *encode(std::string("free")));
    return Value{.data = std::move(list)};
}

std::string type_of(double) { return "number"; }
std::string type_of(int) { return "whole number"; }
std::string type_of(bool) { return "true or false"; }
std::string type_of(const std::vector<double>&) { return "[a, b, ...]"; }
std::string type_of(const std::string&) { return "text"; }
std::string type_of(const Vec2&) { return "[x, y]"; }
std::string type_of(const Eigen::Matrix2d&) { return "[[xx, xy], [yx, yy]]"; }
std::string type_of(const std::vector<Vec2>&) { return "[[x, y], ...]"; }
std::string type_of(const std::array<std::optional<double>, 2>&) { return "[x, y], each a number or \"free\""; }

}  // namespace stria::schema
