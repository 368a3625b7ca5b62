// Unknowns that are always together, counted at once.
#pragma once

#include <span>
#include <vector>

#include "common/index.hpp"
#include "common/substructure/front_layout.hpp"

namespace stria {

/// Unknowns that stand beside each other wherever one of them is, as those of a node do, are in the same elements:
/// they are counted as one.
class Bundles {
public:
    explicit Bundles(const FrontLayout& layout)
        : before_(at(layout.unknowns), unseen), after_(before_), size_(at(layout.unknowns)) {
        for (const std::vector<int>& unknowns : layout.element_unknowns) see(unknowns);
        first_.reserve(layout.element_unknowns.size() + 1);
        for (const std::vector<int>& unknowns : layout.element_unknowns) bundle(unknowns);
    }

    /// Of an element, each by the first of its unknowns.
    [[nodiscard]] std::span<const int> of(int element) const {
        return std::span(of_elements_).subspan(first_[at(element)], first_[at(element) + 1] - first_[at(element)]);
    }
    /// How many unknowns.
    [[nodiscard]] int size(int bundle) const { return size_[at(bundle)]; }

private:
    static constexpr int unseen = -2, changing = -1;

    void see(std::span<const int> unknowns) {
        const auto note = [](int& neighbour, int now) {
            neighbour = neighbour == unseen || neighbour == now ? now : changing;
        };
        for (std::size_t k = 0; k < unknowns.size(); ++k) {
            note(before_[at(unknowns[k])], k > 0 ? unknowns[k - 1] : changing);
            note(after_[at(unknowns[k])], k + 1 < unknowns.size() ? unknowns[k + 1] : changing);
        }
    }

    void bundle(std::span<const int> unknowns) {
        for (std::size_t k = 0, begin = 0; k < unknowns.size(); ++k) {
            const int before = before_[at(unknowns[k])];
            const bool joins = before >= 0 && after_[at(before)] == unknowns[k];
            if (!joins) {
                begin = k;
                of_elements_.push_back(unknowns[k]);
            }
            size_[at(unknowns[begin])] = static_cast<int>(k - begin) + 1;
        }
        first_.push_back(of_elements_.size());
    }

    std::vector<int> before_, after_;  // of each unknown, its neighbour in all elements
    std::vector<int> size_;
    std::vector<std::size_t> first_{0};  // of each element, and behind the last
    std::vector<int> of_elements_;
};

}  // namespace stria
