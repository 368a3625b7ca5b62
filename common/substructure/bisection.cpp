#include "common/substructure/bisection.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>

#include "common/geometry/vec2.hpp"
#include "common/index.hpp"

namespace stria {
namespace {

constexpr int about_busy_places = 2;  // a direction beside x and y: the distance from the nearest, along x or y

/// Parts elements whose coordinate in a direction is less than `plane` from the others.
struct Cut {
    int direction = -1;
    double plane = 0.0;
    double cost = std::numeric_limits<double>::infinity();
    int roundness = 0;  // zeros at the end of the plane's number, in binary

    bool operator<(const Cut& other) const {
        return cost < other.cost || (cost == other.cost && roundness > other.roundness);
    }
};

/// At `number` steps, across which `shared` of the unknowns are seen from both sides, `below` of `elements` before it.
Cut cut_at(int direction, double number, double step, int shared, int below, std::size_t elements) {
    constexpr double tolerated = 0.2;  // so much may the difference of the parts be of their sum
    const double uneven = std::abs(2.0 * below / static_cast<double>(elements) - 1.0);
    return {direction, step * number, (1.0 + shared) * (1.0 + 0.5 * std::max(0.0, uneven - tolerated)),
            std::countr_zero(static_cast<std::uint64_t>(std::abs(number)))};
}

class Bisection {
public:
    explicit Bisection(const FrontLayout& layout)
        : layout_(layout), first_(at(layout.unknowns)), last_(at(layout.unknowns), -1) {
        for (const Vec2& centre : layout.centres) {
            double least = std::numeric_limits<double>::infinity();
            for (const Vec2& place : layout.busy) least = std::min(least, (centre - place).lpNorm<Eigen::Infinity>());
            coordinates_.push_back({centre.x(), centre.y(), least});
        }
    }

    /// What lies about the busy places comes first, so that the way from there to the root is short however many the
    /// others are: squares, whose rims are short.
    int split_about_busy_places(std::span<int> elements) {
        constexpr std::size_t about_each = 128;  // elements at most: docs/performance.md
        const std::size_t near = about_each * layout_.busy.size();
        if (near == 0 || elements.size() < 2 * near) return split(elements);
        const auto end = cut(elements, {about_busy_places, coordinate_of(near, elements, about_busy_places)});
        if (end == elements.begin()) return split(elements);
        PartOfElements node;
        const int others = split({end, elements.end()});
        node.children = {others, split({elements.begin(), end})};
        nodes_.push_back(std::move(node));
        return static_cast<int>(nodes_.size()) - 1;
    }

    [[nodiscard]] std::vector<PartOfElements> nodes() && { return std::move(nodes_); }

private:
    using Place = std::span<int>::iterator;

    int split(std::span<int> elements) {
        PartOfElements node;
        if (static_cast<int>(elements.size()) <= layout_.leaf_elements) {
            node.elements.assign(elements.begin(), elements.end());
            std::ranges::sort(node.elements);
        } else {
            const Place middle = part(elements);
            node.children = {split({elements.begin(), middle}), split({middle, elements.end()})};
        }
        nodes_.push_back(std::move(node));
        return static_cast<int>(nodes_.size()) - 1;
    }

    /// Puts one part before the other and returns where that begins. Where too many lie at one place, it is half.
    [[nodiscard]] Place part(std::span<int> elements) {
        Cut best;
        for (const int direction : {0, 1, about_busy_places})
            if (direction != about_busy_places || !layout_.busy.empty()) look_across(direction, elements, best);
        if (best.direction >= 0) return cut(elements, best);
        const Place half = elements.begin() + std::ssize(elements) / 2;
        std::ranges::nth_element(elements, half, {}, [&](int element) {
            const Vec2& centre = layout_.centres[at(element)];
            return std::tuple(centre.x(), centre.y(), element);
        });
        return half;
    }

    [[nodiscard]] double coordinate(int element, int direction) const {
        return coordinates_[at(element)][at(direction)];
    }

    [[nodiscard]] double coordinate_of(std::size_t which, std::span<int> elements, int direction) const {
        const auto there = elements.begin() + static_cast<std::ptrdiff_t>(which);
        std::ranges::nth_element(elements, there, {}, [&](int element) { return coordinate(element, direction); });
        return coordinate(*there, direction);
    }

    [[nodiscard]] Place cut(std::span<int> elements, const Cut& by) const {
        return std::ranges::partition(elements,
                                      [&](int element) { return coordinate(element, by.direction) < by.plane; })
            .begin();
    }

    /// A cut is cheap where the parts share few unknowns and neither is much smaller than the other. Planes at round
    /// numbers, of equal ones the roundest, mostly stay where they are when elements come and go.
    void look_across(int direction, std::span<int> elements, Cut& best) {
        const std::size_t quarter = elements.size() / 4;
        const double low = coordinate_of(quarter, elements, direction),
                     high = coordinate_of(elements.size() - 1 - quarter, elements, direction);
        if (!(low < high)) return;
        constexpr int eight_or_more = 3, digits = 50;  // planes, digits of their numbers: as powers of two
        const int finest = std::ilogb(std::max(std::abs(low), std::abs(high))) - digits;
        const double step = std::ldexp(1.0, std::max(std::ilogb(high - low) - eight_or_more, finest));
        const double before = std::floor(low / step);  // the last plane that is not looked at
        const int planes = static_cast<int>(std::floor(high / step) - before);
        const std::vector<Between> between = count_between(direction, elements, before, step, planes);
        int shared = 0, below = 0;
        for (int plane = 0; plane < planes; ++plane) {
            shared += between[at(plane)].unknowns;
            below += between[at(plane)].elements;
            best = std::min(best, cut_at(direction, before + 1.0 + plane, step, shared, below, elements.size()));
        }
    }

    struct Between {
        int elements = 0;
        int unknowns = 0;  // that are shared across the next plane and not the last one, less those the other way round
    };

    /// Of each strip before a plane, and the one behind the last.
    [[nodiscard]] std::vector<Between> count_between(int direction, std::span<const int> elements, double before,
                                                     double step, int planes) {
        std::vector<Between> between(at(planes + 1));
        for (const int element : elements) {
            const double strip = std::floor(coordinate(element, direction) / step) - before;
            const int here = static_cast<int>(std::clamp(strip, 0.0, static_cast<double>(planes)));
            ++between[at(here)].elements;
            for (const int unknown : layout_.element_unknowns[at(element)]) {
                int &first = first_[at(unknown)], &last = last_[at(unknown)];
                first = last < 0 ? here : std::min(first, here);
                last = std::max(last, here);
            }
        }
        for (const int element : elements) {
            for (const int unknown : layout_.element_unknowns[at(element)]) {
                const int last = std::exchange(last_[at(unknown)], -1);
                if (last < 0) continue;
                ++between[at(first_[at(unknown)])].unknowns;
                --between[at(last)].unknowns;
            }
        }
        return between;
    }

    const FrontLayout& layout_;
    std::vector<std::array<double, 3>> coordinates_;  // of each element, by direction
    std::vector<int> first_, last_;                   // strips that hold an unknown; -1: none so far
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

}  // namespace stria
