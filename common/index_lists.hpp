// Lists of whole numbers of different lengths, one after another: no heap block a list.
#pragma once

#include <span>
#include <utility>
#include <vector>

namespace stria {

class IndexLists {
public:
    IndexLists() = default;

    /// `entries`: of all lists. `first`: place of the first one of each list, then their number.
    IndexLists(std::vector<std::size_t> first, std::vector<int> entries)
        : first_(std::move(first)), entries_(std::move(entries)) {}

    void append(std::span<const int> list) {
        entries_.insert(entries_.end(), list.begin(), list.end());
        first_.push_back(entries_.size());
    }
    [[nodiscard]] std::size_t size() const { return first_.size() - 1; }
    [[nodiscard]] std::span<const int> operator[](std::size_t list) const {
        return {entries_.data() + first_[list], first_[list + 1] - first_[list]};
    }
    /// Replaces each entry by image(entry).
    template <class Image> void map(Image&& image) {
        for (int& entry : entries_) entry = image(entry);
    }

private:
    std::vector<std::size_t> first_{0};
    std::vector<int> entries_;
};

}  // namespace stria
