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

/// An element as a point: its coordinates by direction, mm.
struct ElementPoint {
    std::array<double, 3> coordinate;
    int element;
};

using ElementPoints = std::span<ElementPoint>;

double distance_along_axes(const std::vector<Vec2>& from, const Vec2& x) {
    double least = std::numeric_limits<double>::infinity();
    for (const Vec2& place : from) least = std::min(least, (x - place).lpNorm<Eigen::Infinity>());
    return least;
}

/// That of the one which has so many before it. `sorted`: none of those before has a larger one than one behind.
double coordinate_of(std::size_t which, ElementPoints points, int direction, std::size_t sorted = 0) {
    std::ranges::nth_element(points.subspan(sorted), points.begin() + static_cast<std::ptrdiff_t>(which), {},
                             [&](const ElementPoint& point) { return point.coordinate[at(direction)]; });
    return points[which].coordinate[at(direction)];
}

/// How many come first.
std::size_t cut(ElementPoints points, const Cut& by) {
    const auto before = [&](const ElementPoint& point) { return point.coordinate[at(by.direction)] < by.plane; };
    return at(std::ranges::partition(points, before).begin() - points.begin());
}

class Bisection {
public:
    explicit Bisection(const FrontLayout& layout)
        : layout_(layout), first_(at(layout.unknowns)), last_(at(layout.unknowns), -1) {
        nodes_.reserve(4 * layout.centres.size() / at(layout.leaf_elements));
    }

    /// What lies about the busy places comes first, so that the way from there to the root is short however many the
    /// others are: squares, whose rims are short.
    int split_about_busy_places(ElementPoints points) {
        constexpr std::size_t about_each = 128;  // elements at most: docs/performance.md
        const std::size_t near = about_each * layout_.busy.size();
        if (near == 0 || points.size() < 2 * near) return split(points);
        const std::size_t first = cut(points, {about_busy_places, coordinate_of(near, points, about_busy_places)});
        if (first == 0) return split(points);
        const int others = split(points.subspan(first));
        return add({.children = {others, split(points.first(first))}, .elements = {}});
    }

    [[nodiscard]] std::vector<PartOfElements> nodes() && { return std::move(nodes_); }

private:
    int add(PartOfElements node) {
        nodes_.push_back(std::move(node));
        return static_cast<int>(nodes_.size()) - 1;
    }

    int split(ElementPoints points) {
        PartOfElements node;
        if (static_cast<int>(points.size()) <= layout_.leaf_elements) {
            node.elements.reserve(points.size());
            for (const ElementPoint& point : points) node.elements.push_back(point.element);
            std::ranges::sort(node.elements);
        } else {
            const std::size_t first = part(points);
            node.children = {split(points.first(first)), split(points.subspan(first))};
        }
        return add(std::move(node));
    }

    /// Puts one part before the other and returns how many come first. Where too many lie at one place, it is half.
    [[nodiscard]] std::size_t part(ElementPoints points) {
        Cut best;
        for (const int direction : {0, 1, about_busy_places})
            if (direction != about_busy_places || !layout_.busy.empty()) look_across(direction, points, best);
        if (best.direction >= 0) return cut(points, best);
        const std::size_t half = points.size() / 2;
        std::ranges::nth_element(points, points.begin() + static_cast<std::ptrdiff_t>(half), {},
                                 [](const ElementPoint& point) {
                                     return std::tuple(point.coordinate[0], point.coordinate[1], point.element);
                                 });
        return half;
    }

    /// A cut is cheap where the parts share few unknowns and neither is much smaller than the other. Planes at round
    /// numbers, of equal ones the roundest, mostly stay where they are when elements come and go.
    void look_across(int direction, ElementPoints points, Cut& best) {
        const std::size_t quarter = points.size() / 4;
        const double low = coordinate_of(quarter, points, direction),
                     high = coordinate_of(points.size() - 1 - quarter, points, direction, quarter);
        if (!(low < high)) return;
        constexpr int eight_or_more = 3, digits = 50;  // planes, digits of their numbers: as powers of two
        const int finest = std::ilogb(std::max(std::abs(low), std::abs(high))) - digits;
        const double step = std::ldexp(1.0, std::max(std::ilogb(high - low) - eight_or_more, finest));
        const double before = std::floor(low / step);  // the last plane that is not looked at
        const int planes = static_cast<int>(std::floor(high / step) - before);
        const std::vector<Between> between = count_between(direction, points, before, step, planes);
        int shared = 0, below = 0;
        for (int plane = 0; plane < planes; ++plane) {
            shared += between[at(plane)].unknowns;
            below += between[at(plane)].elements;
            best = std::min(best, cut_at(direction, before + 1.0 + plane, step, shared, below, points.size()));
        }
    }

    struct Between {
        int elements = 0;
        int unknowns = 0;  // that are shared across the next plane and not the last one, less those the other way round
    };

    /// Of each strip before a plane, and the one behind the last.
    [[nodiscard]] std::vector<Between> count_between(int direction, std::span<const ElementPoint> points, double before,
                                                     double step, int planes) {
        std::vector<Between> between(at(planes + 1));
        for (const ElementPoint& point : points) {
            const double strip = std::floor(point.coordinate[at(direction)] / step) - before;
            const int here = static_cast<int>(std::clamp(strip, 0.0, static_cast<double>(planes)));
            ++between[at(here)].elements;
            for (const int unknown : layout_.element_unknowns[at(point.element)]) {
                int &first = first_[at(unknown)], &last = last_[at(unknown)];
                first = last < 0 ? here : std::min(first, here);
                last = std::max(last, here);
            }
        }
        for (const ElementPoint& point : points) {
            for (const int unknown : layout_.element_unknowns[at(point.element)]) {
                const int last = std::exchange(last_[at(unknown)], -1);
                if (last < 0) continue;
                ++between[at(first_[at(unknown)])].unknowns;
                --between[at(last)].unknowns;
            }
        }
        return between;
    }

    const FrontLayout& layout_;
    std::vector<int> first_, last_;  // strips that hold an unknown; -1: none so far
    std::vector<PartOfElements> nodes_;
};

}  // namespace

std::vector<PartOfElements> bisect(const FrontLayout& layout) {
    std::vector<ElementPoint> points;
    points.reserve(layout.centres.size());
    for (int e = 0; e < std::ssize(layout.centres); ++e) {
        const Vec2& centre = layout.centres[at(e)];
        points.push_back({{centre.x(), centre.y(), distance_along_axes(layout.busy, centre)}, e});
    }
    Bisection bisection(layout);
    bisection.split_about_busy_places(points);
    return std::move(bisection).nodes();
}

}  // namespace stria
