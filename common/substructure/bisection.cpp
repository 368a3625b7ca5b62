#include "common/substructure/bisection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>

#include "common/geometry/vec2.hpp"
#include "common/index.hpp"

namespace stria {
namespace {

class Bisection {
public:
    explicit Bisection(const FrontLayout& layout) : layout_(layout) {}

    /// What lies about the busy places comes first, so that the way from there to the root is short however many the
    /// others are.
    int split_about_busy_places(std::span<int> elements) {
        constexpr std::size_t about_each = 128;  // elements: docs/performance.md
        const std::size_t near = about_each * layout_.busy.size();
        if (near == 0 || elements.size() < 2 * near) return split(elements);
        const auto distance = [&](int element) {
            double least = std::numeric_limits<double>::infinity();
            for (const Vec2& place : layout_.busy)
                least = std::min(least, (layout_.centres[at(element)] - place).squaredNorm());
            return std::tuple(least, element);
        };
        const auto end = elements.begin() + static_cast<std::ptrdiff_t>(near);
        std::ranges::nth_element(elements, end, {}, distance);
        PartOfElements node;
        const int others = split({end, elements.end()});
        node.children = {others, split({elements.begin(), end})};
        nodes_.push_back(std::move(node));
        return static_cast<int>(nodes_.size()) - 1;
    }

    [[nodiscard]] std::vector<PartOfElements> nodes() && { return std::move(nodes_); }

private:
    int split(std::span<int> elements) {
        PartOfElements node;
        if (static_cast<int>(elements.size()) <= layout_.leaf_elements) {
            node.elements.assign(elements.begin(), elements.end());
            std::ranges::sort(node.elements);
        } else {
            const auto middle = elements.begin() + part(elements);
            node.children = {split({elements.begin(), middle}), split({middle, elements.end()})};
        }
        nodes_.push_back(std::move(node));
        return static_cast<int>(nodes_.size()) - 1;
    }

    /// Puts one part before the other: at a round number near the middle of the longer direction, which stays where it
    /// is when elements come and go. Returns how many come first, a third at least and two at most. Where too many lie
    /// at one coordinate, it is half of them.
    [[nodiscard]] std::ptrdiff_t part(std::span<int> elements) const {
        const int axis = longer_direction(elements);
        const auto place = [&](int element) {
            const Vec2& centre = layout_.centres[at(element)];
            return std::tuple(centre[axis], centre[1 - axis], element);
        };
        const auto coordinate_of = [&](std::size_t which) {
            const auto at_place = elements.begin() + static_cast<std::ptrdiff_t>(which);
            std::ranges::nth_element(elements, at_place, {}, place);
            return layout_.centres[at(*at_place)][axis];
        };
        const std::size_t third = elements.size() / 3, half = elements.size() / 2;
        const double low = coordinate_of(third), high = coordinate_of(elements.size() - 1 - third);
        if (!(low < high)) return static_cast<void>(coordinate_of(half)), static_cast<std::ptrdiff_t>(half);
        const double plane = roundest_between(low, high);
        const auto lies_before = [&](int element) { return layout_.centres[at(element)][axis] < plane; };
        return std::ranges::partition(elements, lies_before).begin() - elements.begin();
    }

    [[nodiscard]] int longer_direction(std::span<const int> elements) const {
        Eigen::Array2d low = layout_.centres[at(elements.front())], high = low;
        for (const int element : elements) {
            low = low.min(layout_.centres[at(element)].array());
            high = high.max(layout_.centres[at(element)].array());
        }
        return high.y() - low.y() > high.x() - low.x() ? 1 : 0;
    }

    const FrontLayout& layout_;
    std::vector<PartOfElements> nodes_;
};

}  // namespace

std::vector<PartOfElements> bisect(const FrontLayout& layout) {
    std::vector<int> elements(layout.element_unknowns.size());
    std::iota(elements.begin(), elements.end(), 0);
    Bisection bisection(layout);
    bisection.split_about_busy_places(elements);
    return std::move(bisection).nodes();
}

double roundest_between(double low, double high) {
    for (double step = std::ldexp(1.0, 1 + std::ilogb(std::max(std::abs(low), std::abs(high))));; step /= 2.0) {
        const double candidate = std::floor(high / step) * step;
        if (candidate > low) return candidate;
    }
}

}  // namespace stria
