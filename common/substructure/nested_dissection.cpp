#include "common/substructure/nested_dissection.hpp"

#include <algorithm>
#include <limits>
#include <span>

#include "common/error.hpp"
#include "common/index.hpp"
#include "common/substructure/element_place.hpp"

namespace stria {
namespace {

constexpr std::ptrdiff_t leaf_elements = 2;

/// Sorts places into the order of the leaves of a median bisection along the longer direction.
void bisect(std::span<ElementPlace> places) {
    if (std::ssize(places) <= leaf_elements) return;
    const auto half = places.begin() + std::ssize(places) / 2;
    std::nth_element(places.begin(), half, places.end(), BeforeAlong{longer_direction(places)});
    bisect({places.begin(), half});
    bisect({half, places.end()});
}

/// The first and the last of an unknown's elements in the order of the leaves.
struct ElementReach {
    int first = std::numeric_limits<int>::max();
    int last = -1;
};

void sort_by_halves(int begin, int half, int end, const std::vector<ElementReach>& reach, std::span<int> unknowns);

void sort_by_parts(int begin, int end, const std::vector<ElementReach>& reach, std::span<int> unknowns) {
    if (end - begin <= leaf_elements || unknowns.size() < 2) {
        std::ranges::sort(unknowns);
        return;
    }
    sort_by_halves(begin, begin + (end - begin) / 2, end, reach, unknowns);
}

/// Sorts the unknowns of the part [begin, end): those of each half alone, then those that the halves share.
void sort_by_halves(int begin, int half, int end, const std::vector<ElementReach>& reach, std::span<int> unknowns) {
    const auto right = std::ranges::partition(unknowns, [&](int i) { return reach[at(i)].last < half; });
    const auto shared = std::ranges::partition(right, [&](int i) { return reach[at(i)].first >= half; });
    sort_by_parts(begin, half, reach, {unknowns.begin(), right.begin()});
    sort_by_parts(half, end, reach, {right.begin(), shared.begin()});
    std::ranges::sort(shared);
}

/// The elements in the order of the leaves, late ones after all others: the first cut is between the two.
struct Leaves {
    std::vector<ElementPlace> places;
    int early = 0;
};

Leaves bisected(const std::vector<Vec2>& centres, const std::vector<char>& late) {
    Leaves leaves;
    leaves.places.reserve(centres.size());
    for (std::size_t e = 0; e < centres.size(); ++e) leaves.places.push_back({centres[e], static_cast<int>(e)});
    const auto first_late = std::ranges::stable_partition(
        leaves.places, [&](const ElementPlace& place) { return late.empty() || late[at(place.element)] == 0; });
    leaves.early = static_cast<int>(first_late.begin() - leaves.places.begin());
    bisect({leaves.places.begin(), first_late.begin()});
    bisect(first_late);
    return leaves;
}

}  // namespace

std::vector<int> nested_dissection(const IndexLists& element_unknowns, const std::vector<Vec2>& centres, int unknowns,
                                   const std::vector<int>& kept, const std::vector<char>& late) {
    require(centres.size() == element_unknowns.size(), "nested dissection: one centre an element");
    require(late.empty() || late.size() == centres.size(), "nested dissection: late or not, one an element");
    const auto [places, early] = bisected(centres, late);
    std::vector<ElementReach> reach(at(unknowns));
    for (int position = 0; position < static_cast<int>(places.size()); ++position) {
        for (const int unknown : element_unknowns[at(places[at(position)].element)]) {
            if (unknown < 0) continue;
            reach[at(unknown)].first = std::min(reach[at(unknown)].first, position);
            reach[at(unknown)].last = position;
        }
    }
    for (const int unknown : kept) reach[at(unknown)].last = -1;
    std::vector<int> order;
    order.reserve(at(unknowns));
    for (int unknown = 0; unknown < unknowns; ++unknown)
        if (reach[at(unknown)].last >= 0) order.push_back(unknown);
    sort_by_halves(0, early, static_cast<int>(places.size()), reach, order);
    order.insert(order.end(), kept.begin(), kept.end());
    return order;
}

}  // namespace stria
