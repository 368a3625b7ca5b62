// What is known of one key of a case file, and how a value of it is refused.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "common/schema/value.hpp"

namespace stria::schema {

/// The file and the dotted path of a value: "crack.0.contact".
struct Place {
    std::string file;
    std::string path;

    [[nodiscard]] Place inside(std::string_view name) const;
};

struct Rule {
    std::function<bool(double)> holds;
    std::string text;  // completes "must be ..."
};

/// All that is known of one key. The builders are chained in its declaration.
struct Key {
    std::string name = {};
    std::string type = {};
    std::string fallback = {};  // the default as text
    std::string unit = {};
    std::string sentence = {};
    bool required = false;
    bool repeated = false;  // a list of tables
    std::vector<Rule> rules = {};
    std::vector<std::string> words = {};  // empty: any text
    std::vector<Key> keys = {};           // of a table or of each table of a list

    Key& in(std::string its_unit);
    Key& positive();
    Key& at_least(double bound);
    Key& below(double bound);
    Key& at_most(double bound);
    Key& even();
    Key& power_of_two();
    Key& one_of(std::vector<std::string> allowed);
    Key& must_be_given();
    Key& or_else(std::string default_text);  // where the default follows from something else
    Key& says(std::string its_sentence);

    /// "> 0", ">= 0 and < 0.5", "strain | stress"; empty where anything goes.
    [[nodiscard]] std::string range() const;
};

/// Throw CaseError: "case.toml:14: material.yield_stress = -350 MPa must be > 0", or the path and a sentence of one's
/// own.
[[noreturn]] void reject(const Place& place, const Value& value, const Key& key, const std::string& demand);
[[noreturn]] void reject(const Place& place, int line, const std::string& sentence);

}  // namespace stria::schema
