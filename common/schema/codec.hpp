// How a value of a case file becomes a member of a struct and the other way round, for each type that members have.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "common/geometry/vec2.hpp"
#include "common/schema/key.hpp"

namespace stria::schema {

/// All throw CaseError (reject()) where the value is of another type, is not finite or breaks a rule of the key.
void decode(const Value& value, const Key& key, const Place& place, double& out);
void decode(const Value& value, const Key& key, const Place& place, int& out);
void decode(const Value& value, const Key& key, const Place& place, bool& out);
void decode(const Value& value, const Key& key, const Place& place, std::string& out);
void decode(const Value& value, const Key& key, const Place& place, std::vector<double>& out);
void decode(const Value& value, const Key& key, const Place& place, Vec2& out);
void decode(const Value& value, const Key& key, const Place& place, Eigen::Matrix2d& out);
void decode(const Value& value, const Key& key, const Place& place, std::vector<Vec2>& out);
void decode(const Value& value, const Key& key, const Place& place, std::array<std::optional<double>, 2>& out);

template <class M> void decode(const Value& value, const Key& key, const Place& place, std::optional<M>& out) {
    M read{};
    decode(value, key, place, read);
    out = read;
}

/// What decode() reads again; nothing where the key is absent.
std::optional<Value> encode(double number);
std::optional<Value> encode(int number);
std::optional<Value> encode(bool truth);
std::optional<Value> encode(const std::vector<double>& numbers);
std::optional<Value> encode(const std::string& text);
std::optional<Value> encode(const Vec2& point);
std::optional<Value> encode(const Eigen::Matrix2d& matrix);
std::optional<Value> encode(const std::vector<Vec2>& points);
std::optional<Value> encode(const std::array<std::optional<double>, 2>& displacement);

template <class M> std::optional<Value> encode(const std::optional<M>& value) {
    return value ? encode(*value) : std::nullopt;
}

/// As the reference says it.
std::string type_of(double);
std::string type_of(int);
std::string type_of(bool);
std::string type_of(const std::vector<double>&);
std::string type_of(const std::string&);
std::string type_of(const Vec2&);
std::string type_of(const Eigen::Matrix2d&);
std::string type_of(const std::vector<Vec2>&);
std::string type_of(const std::array<std::optional<double>, 2>&);

template <class M> std::string type_of(const std::optional<M>& /*absent*/) { return type_of(M{}); }

const Table& table_of(const Value& value, const Key& key, const Place& place);
const List& list_of(const Value& value, const Key& key, const Place& place);

}  // namespace stria::schema
