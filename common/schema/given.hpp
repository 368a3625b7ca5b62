// A table of the case file as it is given, with its place: what is wrong with it is said with the line of the file.
#pragma once

#include <string>
#include <string_view>

#include "common/schema/key.hpp"

namespace stria::schema {

/// The table of an entry of a list of tables, from 0. The list must be given and have one.
[[nodiscard]] const Value& entry_of(const Value& table, std::string_view list, std::size_t k);
/// Its place.
[[nodiscard]] Place place_of(const Place& table, std::string_view list, std::size_t k);

/// All that throw throw CaseError. A key that is refused must be given.
struct Given {
    const Value& table;
    Place place;

    [[nodiscard]] bool has(std::string_view key) const { return find(table, key) != nullptr; }
    /// A table in this one, which must be given, and an entry of a list of tables.
    [[nodiscard]] Given inside(std::string_view key) const { return {*find(table, key), place.inside(key)}; }
    [[nodiscard]] Given entry(std::string_view list, std::size_t k) const;

    /// "case.toml:14: mesh needs specimen or file"
    [[noreturn]] void refuse(const std::string& sentence) const;
    /// "case.toml:14: mesh.width belongs to a specimen"
    [[noreturn]] void refuse(std::string_view key, const std::string& sentence) const;
    /// "case.toml:14: mesh.size = 9 mm must not exceed width and height"
    [[noreturn]] void refuse_value(std::string_view key, const std::string& demand, const std::string& unit = "") const;

    /// Refuses its value where it is not met; the key need not be given where it is.
    void demand(bool met, std::string_view key, const std::string& what) const;
};

}  // namespace stria::schema
