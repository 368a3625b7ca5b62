#include "common/schema/given.hpp"

namespace stria::schema {

const Value& entry_of(const Value& table, std::string_view list, std::size_t k) {
    return std::get<List>(find(table, list)->data)[k];
}

Place place_of(const Place& table, std::string_view list, std::size_t k) {
    return table.inside(list).inside(std::to_string(k));
}

Given Given::entry(std::string_view list, std::size_t k) const {
    return {entry_of(table, list, k), place_of(place, list, k)};
}

void Given::refuse(const std::string& sentence) const { reject(place, table.line, sentence); }

void Given::refuse(std::string_view key, const std::string& sentence) const {
    reject(place.inside(key), find(table, key)->line, sentence);
}

void Given::refuse_value(std::string_view key, const std::string& demand, const std::string& unit) const {
    reject(place.inside(key), *find(table, key), {.unit = unit}, demand);
}

void Given::demand(bool met, std::string_view key, const std::string& what) const {
    if (!met) refuse_value(key, what);
}

}  // namespace stria::schema
