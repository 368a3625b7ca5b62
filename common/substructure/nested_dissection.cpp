#include "common/substructure/nested_dissection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "common/error.hpp"
#include "common/geometry/vec2.hpp"
#include "common/index.hpp"
#include "common/substructure/bisection.hpp"

namespace stria {
namespace {

constexpr std::ptrdiff_t leaf_elements = 2;

struct Place {
    Vec2 centre;
    int element;
};

/// Ties are broken by the other coordinate and the number, so that the order is the same on every machine.
auto along(int axis) {
    return [axis](const Place& a, const Place& b) {
        if (a.centre[axis] != b.centre[axis]) return a.centre[axis] < b.centre[axis];
        if (a.centre[1 - axis] != b.centre[1 - axis]) return a.centre[1 - axis] < b.centre[1 - axis];
        return a.element < b.element;
    };
}

/// Two parts of some places, the first `first` of them and the others. Each part has its own, none where it is a leaf.
struct Halves {
    std::ptrdiff_t first = 0;
    int below = -1, above = -1;
};

/// Sorts places into the order of the leaves of a bisection.
class PlaceBisection {
public:
    PlaceBisection(const IndexLists& element_unknowns, int unknowns)
        : element_unknowns_(element_unknowns), last_place_(at(unknowns), 0), group_(at(unknowns), 0) {}

    /// The number of the halves of these places.
    int bisect(std::span<Place> places) {
        const std::ptrdiff_t count = std::ssize(places);
        if (count <= leaf_elements) return -1;
        const int index = static_cast<int>(halves_.size());
        halves_.emplace_back();
        const std::ptrdiff_t first =
            count < many_elements ? halve_the_longer(places) : part_where_few_are_shared(places);
        const int below = bisect(places.first(at(first))), above = bisect(places.subspan(at(first)));
        halves_[at(index)] = {first, below, above};
        return index;
    }

    [[nodiscard]] const std::vector<Halves>& halves() const { return halves_; }

private:
    static constexpr std::ptrdiff_t many_elements = 64;  // in fewer the longer direction tells as much

    static std::ptrdiff_t halve_the_longer(std::span<Place> places) {
        Eigen::Array2d low = places.front().centre, high = low;
        for (const Place& place : places) {
            low = low.min(place.centre.array());
            high = high.max(place.centre.array());
        }
        const int axis = high.y() - low.y() > high.x() - low.x() ? 1 : 0;
        std::ranges::nth_element(places, places.begin() + std::ssize(places) / 2, along(axis));
        return std::ssize(places) / 2;
    }

    struct Cut {
        int axis = 0;
        std::ptrdiff_t first = 0;
        double cost = std::numeric_limits<double>::infinity();
        double uneven = 0.0;

        bool operator<(const Cut& other) const {
            return cost < other.cost || (cost == other.cost && uneven < other.uneven);
        }
    };

    std::ptrdiff_t part_where_few_are_shared(std::span<Place> places) {
        Cut best;
        for (const int axis : {0, 1}) {
            std::ranges::sort(places, along(axis));
            look_along(axis, places, best);
        }
        if (best.axis == 0) std::ranges::sort(places, along(0));
        return best.first;
    }

    void look_along(int axis, std::span<const Place> places, Cut& best) {
        const std::ptrdiff_t count = std::ssize(places);
        ++groups_;
        change_.assign(at(count) + 1, 0);
        for (std::ptrdiff_t k = 0; k < count; ++k) {
            for (const int unknown : element_unknowns_[at(places[at(k)].element)]) {
                if (unknown < 0) continue;
                if (group_[at(unknown)] == groups_) {
                    ++change_[at(last_place_[at(unknown)]) + 1];
                    --change_[at(k) + 1];
                }
                group_[at(unknown)] = groups_;
                last_place_[at(unknown)] = static_cast<int>(k);
            }
        }
        int shared = 0;
        for (std::ptrdiff_t first = 0; first < count; ++first) {
            shared += change_[at(first)];
            if (4 * first < count || 4 * first > 3 * count) continue;
            const double uneven = std::abs(2.0 * static_cast<double>(first) / static_cast<double>(count) - 1.0);
            best = std::min(best, Cut{axis, first, cost_of_cut(shared, uneven), uneven});
        }
    }

    const IndexLists& element_unknowns_;
    std::vector<int> last_place_;  // of the elements so far that hold an unknown
    std::vector<int> group_;       // that was last seen to hold it
    int groups_ = 0;
    std::vector<int> change_;  // of the unknowns shared, from one cut to the next
    std::vector<Halves> halves_;
};

/// The first and the last of an unknown's elements in the order of the leaves.
struct ElementReach {
    int first = std::numeric_limits<int>::max();
    int last = -1;
};

/// Sorts the unknowns of elements from `begin` on: those of each part alone, then those that the parts share.
void sort_by_parts(int begin, const Halves& own, const std::vector<Halves>& halves,
                   const std::vector<ElementReach>& reach, std::span<int> unknowns) {
    const int half = begin + static_cast<int>(own.first);
    const auto right = std::ranges::partition(unknowns, [&](int i) { return reach[at(i)].last < half; });
    const auto shared = std::ranges::partition(right, [&](int i) { return reach[at(i)].first >= half; });
    const auto sort_part = [&](int first, int part, std::span<int> of_part) {
        if (part < 0 || of_part.size() < 2)
            std::ranges::sort(of_part);
        else
            sort_by_parts(first, halves[at(part)], halves, reach, of_part);
    };
    sort_part(begin, own.below, {unknowns.begin(), right.begin()});
    sort_part(half, own.above, {right.begin(), shared.begin()});
    std::ranges::sort(shared);
}

}  // namespace

std::vector<int> nested_dissection(const IndexLists& element_unknowns, const std::vector<Vec2>& centres, int unknowns,
                                   const std::vector<int>& kept, const std::vector<char>& late) {
    require(centres.size() == element_unknowns.size(), "nested dissection: one centre an element");
    require(late.empty() || late.size() == centres.size(), "nested dissection: late or not, one an element");
    std::vector<Place> places;
    places.reserve(centres.size());
    for (std::size_t e = 0; e < centres.size(); ++e) places.push_back({centres[e], static_cast<int>(e)});
    const auto first_late = std::ranges::stable_partition(
        places, [&](const Place& place) { return late.empty() || late[at(place.element)] == 0; });
    PlaceBisection bisection(element_unknowns, unknowns);
    const Halves root{.first = first_late.begin() - places.begin(),
                      .below = bisection.bisect({places.begin(), first_late.begin()}),
                      .above = bisection.bisect(first_late)};
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
    sort_by_parts(0, root, bisection.halves(), reach, order);
    order.insert(order.end(), kept.begin(), kept.end());
    return order;
}

}  // namespace stria
