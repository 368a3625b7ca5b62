#include "common/substructure/bisection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "common/index.hpp"
#include "common/substructure/element_place.hpp"

namespace stria {
namespace {

class Bisection {
public:
    explicit Bisection(const FrontLayout& layout) : layout_(layout) {
        nodes_.reserve(4 * layout.centres.size() / at(layout.leaf_elements));
    }

    /// What lies about the busy places comes first, so that the way from there to the root is short however many the
    /// others are.
    int split_about_busy_places(std::span<ElementPlace> places) {
        constexpr std::size_t about_each = 128;  // elements: docs/performance.md
        const std::size_t near = about_each * layout_.busy.size();
        if (near == 0 || places.size() < 2 * near) return split(places);
        std::vector<double> distance;  // of each element
        for (const Vec2& centre : layout_.centres) {
            distance.push_back(std::numeric_limits<double>::infinity());
            for (const Vec2& busy : layout_.busy)
                distance.back() = std::min(distance.back(), (centre - busy).squaredNorm());
        }
        const auto nearer = [&](const ElementPlace& a, const ElementPlace& b) {
            return std::pair(distance[at(a.element)], a.element) < std::pair(distance[at(b.element)], b.element);
        };
        const auto end = places.begin() + static_cast<std::ptrdiff_t>(near);
        std::ranges::nth_element(places, end, nearer);
        PartOfElements node;
        const int others = split({end, places.end()});
        node.children = {others, split({places.begin(), end})};
        nodes_.push_back(std::move(node));
        return static_cast<int>(nodes_.size()) - 1;
    }

    [[nodiscard]] std::vector<PartOfElements> nodes() && { return std::move(nodes_); }

private:
    int split(std::span<ElementPlace> places) {
        PartOfElements node;
        if (static_cast<int>(places.size()) <= layout_.leaf_elements) {
            node.elements.reserve(places.size());
            for (const ElementPlace& place : places) node.elements.push_back(place.element);
            std::ranges::sort(node.elements);
        } else {
            const auto middle = places.begin() + part(places);
            node.children = {split({places.begin(), middle}), split({middle, places.end()})};
        }
        nodes_.push_back(std::move(node));
        return static_cast<int>(nodes_.size()) - 1;
    }

    /// Puts one part before the other: at a round number near the middle of the longer direction, which stays where it
    /// is when elements come and go. Returns how many come first, a third at least and two at most. Where too many lie
    /// at one coordinate, it is half of them.
    [[nodiscard]] static std::ptrdiff_t part(std::span<ElementPlace> places) {
        const int axis = longer_direction(places);
        const std::ptrdiff_t third = std::ssize(places) / 3, half = std::ssize(places) / 2;
        // `sorted`: none of those before has a larger coordinate than one behind.
        const auto coordinate_of = [&](std::ptrdiff_t which, std::ptrdiff_t sorted) {
            std::nth_element(places.begin() + sorted, places.begin() + which, places.end(), BeforeAlong{axis});
            return places[at(which)].centre[axis];
        };
        const double low = coordinate_of(third, 0), high = coordinate_of(std::ssize(places) - 1 - third, third);
        if (!(low < high)) return static_cast<void>(coordinate_of(half, third)), half;
        const double plane = roundest_between(low, high);
        const auto lies_before = [&](const ElementPlace& place) { return place.centre[axis] < plane; };
        return std::ranges::partition(places, lies_before).begin() - places.begin();
    }

    const FrontLayout& layout_;
    std::vector<PartOfElements> nodes_;
};

}  // namespace

std::vector<PartOfElements> bisect(const FrontLayout& layout) {
    std::vector<ElementPlace> places;
    places.reserve(layout.centres.size());
    for (int e = 0; e < std::ssize(layout.centres); ++e) places.push_back({layout.centres[at(e)], e});
    Bisection bisection(layout);
    bisection.split_about_busy_places(places);
    return std::move(bisection).nodes();
}

double roundest_between(double low, double high) {
    for (double step = std::ldexp(1.0, 1 + std::ilogb(std::max(std::abs(low), std::abs(high))));; step /= 2.0) {
        const double candidate = std::floor(high / step) * step;
        if (candidate > low) return candidate;
    }
}

}  // namespace stria
