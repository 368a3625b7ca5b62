#include "common/schema/known_keys.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <numeric>

namespace stria::schema {

namespace {

/// Levenshtein's distance: single letters put in, left out or exchanged.
std::size_t edit_distance(std::string_view one, std::string_view other) {
    std::vector<std::size_t> row(other.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (const char letter : one) {
        std::size_t diagonal = row[0]++;
        for (std::size_t j = 0; j < other.size(); ++j) {
            const std::size_t exchanged = diagonal + (letter == other[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({exchanged, row[j] + 1, diagonal + 1});
        }
    }
    return row.back();
}

std::pair<std::string, std::string> parent_and_leaf(const std::string& path) {
    const std::size_t dot = path.rfind('.');
    if (dot == std::string::npos) return {"", path};
    return {path.substr(0, dot), path.substr(dot + 1)};
}

/// Calls visit(path, value) for every entry below `value`, outermost first.
template <class Visit> void walk(const Value& value, const Place& place, Visit visit) {
    if (const auto* table = std::get_if<Table>(&value.data))
        for (const auto& [name, entry] : *table) {
            visit(place.inside(name), entry);
            walk(entry, place.inside(name), visit);
        }
    if (const auto* list = std::get_if<List>(&value.data))
        for (std::size_t index = 0; index < list->size(); ++index)
            walk((*list)[index], place.inside(std::to_string(index)), visit);
}

}  // namespace

std::string without_numbers(const std::string& path) {
    std::string out;
    for (std::size_t start = 0; start <= path.size();) {
        const std::size_t end = std::min(path.find('.', start), path.size());
        const std::string part = path.substr(start, end - start);
        const bool number = !part.empty() && part.find_first_not_of("0123456789") == std::string::npos;
        if (!number) out += (out.empty() ? "" : ".") + part;
        start = end + 1;
    }
    return out;
}

std::vector<std::string> all_paths(const std::vector<Key>& keys, const std::string& prefix) {
    std::vector<std::string> paths;
    for (const Key& key : keys) {
        paths.push_back(prefix + key.name);
        const std::vector<std::string> below = all_paths(key.keys, prefix + key.name + ".");
        paths.insert(paths.end(), below.begin(), below.end());
    }
    return paths;
}

std::string nearest_key(const std::string& path, const std::vector<Key>& keys) {
    const auto [parent, leaf] = parent_and_leaf(path);
    std::string nearest;
    std::size_t least = std::max<std::size_t>(2, leaf.size() / 3) + 1;  // farther is no likeness
    for (const std::string& known : all_paths(keys)) {
        const auto [known_parent, known_leaf] = parent_and_leaf(known);
        // A slip of the pen within the table is likelier than the right word in a wrong table.
        const bool begins = leaf.size() >= 3 && known_leaf.starts_with(leaf);
        const std::size_t distance = known_parent == parent ? (begins ? 1 : edit_distance(leaf, known_leaf))
                                     : known_leaf == leaf   ? 2
                                                            : std::numeric_limits<std::size_t>::max();
        if (distance >= least) continue;
        least = distance;
        nearest = known;
    }
    return nearest;
}

std::string instead_of_key(const std::string& path, const std::vector<Key>& keys) {
    if (const std::string nearest = nearest_key(path, keys); !nearest.empty()) return "did you mean " + nearest + "?";
    const std::string table = parent_and_leaf(path).first;
    std::string has;
    for (const std::string& known : all_paths(keys)) {
        const auto [parent, leaf] = parent_and_leaf(known);
        if (!table.empty() && parent == table) has += (has.empty() ? "" : ", ") + leaf;
    }
    return has.empty() ? "`stria explain` lists all keys" : fmt::format("{} has {}", table, has);
}

void check_known(const Value& root, const std::vector<Key>& keys, const std::string& file) {
    const std::vector<std::string> known = all_paths(keys);
    walk(root, {file, ""}, [&](const Place& place, const Value& value) {
        const std::string path = without_numbers(place.path);
        if (std::ranges::count(known, path) > 0) return;
        reject(place, value.line, "is not a known key; " + instead_of_key(path, keys));
    });
}

void check_available(const Value& root, const std::vector<NotYet>& missing, const std::string& file) {
    walk(root, {file, ""}, [&](const Place& place, const Value& value) {
        const std::string path = without_numbers(place.path);
        for (const NotYet& entry : missing) {
            const bool named = entry.path == path || entry.path == parent_and_leaf(path).first + ".*";
            if (!named || (entry.applies && !entry.applies(value))) continue;
            const std::string instead = entry.instead.empty() ? "" : "; " + entry.instead;
            reject(place, value.line, "is not available in this version" + instead);
        }
    });
}

}  // namespace stria::schema
