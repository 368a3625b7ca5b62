// Which keys a case file may hold: unknown ones are named with their nearest neighbour, planned ones as not there yet.
#pragma once

#include "common/schema/key.hpp"

namespace stria::schema {

/// A key that the case file's language has and this version has not.
struct NotYet {
    std::string path;  // without the numbers of lists: "crack.contact.friction"; "material.*" is any key below
    std::function<bool(const Value&)> applies;  // empty: whatever the value
    std::string instead;                        // what this version has; may be empty
};

/// Both throw CaseError at the first offending key of the whole file `root`.
void check_known(const Value& root, const std::vector<Key>& keys, const std::string& file);
void check_available(const Value& root, const std::vector<NotYet>& missing, const std::string& file);

/// The known path a misspelt one most likely means; empty where none is near.
std::string nearest_key(const std::string& path, const std::vector<Key>& keys);

/// What to write instead of a path that is not known: the nearest, or else what its table has.
std::string instead_of_key(const std::string& path, const std::vector<Key>& keys);

/// "crack.0.contact" -> "crack.contact"
std::string without_numbers(const std::string& path);

/// Every path of the keys, each table before what it holds.
std::vector<std::string> all_paths(const std::vector<Key>& keys, const std::string& prefix = "");

}  // namespace stria::schema
