// Sets of elements, nodes, unknowns or multipliers: a flag each, and a type each, so that one cannot stand for another.
#pragma once

#include <algorithm>
#include <concepts>
#include <utility>
#include <vector>

#include "common/index.hpp"

namespace stria {

template <class Kind> class IndexSet {
public:
    IndexSet() = default;

    /// Of the ids 0 ... size - 1: none of them, or all.
    explicit IndexSet(std::integral auto size, bool all = false) : flags_(at(size), all ? 1 : 0) {}

    /// From a flag each, 1 or 0.
    static IndexSet of_flags(std::vector<char> flags) {
        IndexSet set;
        set.flags_ = std::move(flags);
        return set;
    }
    [[nodiscard]] const std::vector<char>& flags() const { return flags_; }

    /// More ids: none of the new ones is in the set.
    void widen(std::integral auto size) { flags_.resize(at(size), 0); }

    /// How many ids there are, inside and outside.
    [[nodiscard]] int size() const { return static_cast<int>(flags_.size()); }

    [[nodiscard]] bool contains(std::integral auto id) const { return flags_[at(id)] != 0; }
    /// The same of any id: one that the set does not count is not in it.
    [[nodiscard]] bool holds(std::integral auto id) const { return at(id) < flags_.size() && contains(id); }
    void insert(std::integral auto id) { flags_[at(id)] = 1; }
    void erase(std::integral auto id) { flags_[at(id)] = 0; }

    [[nodiscard]] int count() const { return static_cast<int>(std::ranges::count(flags_, char{1})); }
    [[nodiscard]] bool none() const { return std::ranges::find(flags_, char{1}) == flags_.end(); }

    /// Its ids, ascending.
    [[nodiscard]] std::vector<int> members() const {
        std::vector<int> ids;
        for (int id = 0; id < size(); ++id)
            if (contains(id)) ids.push_back(id);
        return ids;
    }

    /// Adds the ids of another set of the same size.
    IndexSet& operator|=(const IndexSet& other) {
        for (int id = 0; id < size(); ++id)
            if (other.contains(id)) insert(id);
        return *this;
    }

    /// Of another set of the same size.
    [[nodiscard]] bool is_subset_of(const IndexSet& other) const {
        return std::ranges::equal(flags_, other.flags_, std::ranges::less_equal());
    }

    [[nodiscard]] IndexSet complement() const {
        IndexSet others(size(), true);
        for (int id = 0; id < size(); ++id)
            if (contains(id)) others.erase(id);
        return others;
    }

    bool operator==(const IndexSet&) const = default;

private:
    std::vector<char> flags_;
};

/// Calls visit(begin, end) for each longest run of neighbouring ids that are all in the set, or all not.
template <class Kind, class Visit> void for_each_run(const IndexSet<Kind>& set, bool inside, Visit&& visit) {
    for (int begin = 0; begin < set.size();) {
        int end = begin;
        while (end < set.size() && set.contains(end) == inside) ++end;
        if (end > begin) visit(begin, end);
        begin = end + 1;
    }
}

/// Some of the ids are in a set, of this type or of the library's.
[[nodiscard]] bool contains_any(const auto& set, const auto& ids) {
    return std::ranges::any_of(ids, [&](int id) { return set.contains(id); });
}

using ElementSet = IndexSet<struct ElementKind>;
using NodeSet = IndexSet<struct NodeKind>;
using UnknownSet = IndexSet<struct UnknownKind>;
using MultiplierSet = IndexSet<struct MultiplierOfFacesKind>;

}  // namespace stria
