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
#include "common/substructure/bundles.hpp"

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
    const double uneven = std::abs(2.0 * below / static_cast<double>(elements) - 1.0);
    return {direction, step * number, cost_of_cut(shared, uneven),
            std::countr_zero(static_cast<std::uint64_t>(std::abs(number)))};
}

double distance_along_axes(const std::vector<Vec2>& from, const Vec2& x) {
    double least = std::numeric_limits<double>::infinity();
    for (const Vec2& place : from) least = std::min(least, (x - place).lpNorm<Eigen::Infinity>());
    return least;
}

/// All elements, sorted by their coordinates in each direction. Those of a group stand together, in all directions.
class SortedElements {
public:
    struct Group {
        std::size_t begin, end;

        [[nodiscard]] std::size_t size() const { return end - begin; }
        [[nodiscard]] Group first(std::size_t count) const { return {begin, begin + count}; }
        [[nodiscard]] Group behind(std::size_t count) const { return {begin + count, end}; }
    };

    explicit SortedElements(const FrontLayout& layout) : is_first_(layout.centres.size()) {
        for (const Vec2& centre : layout.centres) {
            coordinate_[0].push_back(centre.x());
            coordinate_[1].push_back(centre.y());
            if (!layout.busy.empty())
                coordinate_[about_busy_places].push_back(distance_along_axes(layout.busy, centre));
        }
        for (std::size_t direction = 0; direction < coordinate_.size(); ++direction) {
            order_[direction].resize(coordinate_[direction].size());
            std::iota(order_[direction].begin(), order_[direction].end(), 0);
            std::ranges::sort(order_[direction], {}, [&](int element) { return coordinate_[direction][at(element)]; });
        }
    }

    [[nodiscard]] Group all() const { return {0, is_first_.size()}; }
    [[nodiscard]] bool know(int direction) const { return !order_[at(direction)].empty(); }
    [[nodiscard]] double coordinate(int direction, int element) const {
        return coordinate_[at(direction)][at(element)];
    }
    [[nodiscard]] std::span<const int> of(Group group, int direction = 0) const {
        return std::span(order_[at(direction)]).subspan(group.begin, group.size());
    }

    /// Puts those before a plane before the others. How many there are.
    std::size_t cut(Group group, const Cut& by) {
        const std::span<const int> sorted = of(group, by.direction);
        const auto is_before = [&](int element) { return coordinate(by.direction, element) < by.plane; };
        const auto first = at(std::ranges::partition_point(sorted, is_before) - sorted.begin());
        put_first(group, {sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(first)});
        return first;
    }

    /// By their places, and by their numbers where they lie at one place.
    std::size_t halve(Group group) {
        std::vector<int> elements(of(group).begin(), of(group).end());
        const std::size_t half = elements.size() / 2;
        std::ranges::nth_element(elements, elements.begin() + static_cast<std::ptrdiff_t>(half), {}, [&](int element) {
            return std::tuple(coordinate(0, element), coordinate(1, element), element);
        });
        elements.resize(half);
        put_first(group, elements);
        return half;
    }

private:
    void put_first(Group group, std::span<const int> elements) {
        for (const int element : of(group)) is_first_[at(element)] = 0;
        for (const int element : elements) is_first_[at(element)] = 1;
        for (std::vector<int>& order : order_) {
            if (order.empty()) continue;
            others_.clear();
            auto next = order.begin() + static_cast<std::ptrdiff_t>(group.begin);
            for (std::size_t k = group.begin; k < group.end; ++k) {
                if (is_first_[at(order[k])] != 0)
                    *next++ = order[k];
                else
                    others_.push_back(order[k]);
            }
            std::ranges::copy(others_, next);
        }
    }

    std::array<std::vector<double>, 3> coordinate_;  // by direction, mm
    std::array<std::vector<int>, 3> order_;
    std::vector<char> is_first_;
    std::vector<int> others_;
};

using Group = SortedElements::Group;

class Bisection {
public:
    explicit Bisection(const FrontLayout& layout)
        : layout_(layout), elements_(layout), bundles_(layout), strip_(at(layout.unknowns), -1) {
        nodes_.reserve(4 * layout.centres.size() / at(layout.leaf_elements));
    }

    std::vector<PartOfElements> nodes() && {
        split_between(elements_.all(), layout_.busy);
        return std::move(nodes_);
    }

private:
    int add(PartOfElements node) {
        nodes_.push_back(std::move(node));
        return static_cast<int>(nodes_.size()) - 1;
    }

    /// Planes between busy places part all elements first: what changes about one of them passes by no other on its way
    /// to the root.
    int split_between(Group group, const std::vector<Vec2>& busy) {
        Cut best;
        for (const int direction : {0, 1}) {
            std::vector<double> coordinates;
            for (const Vec2& place : busy) coordinates.push_back(place[direction]);
            std::ranges::sort(coordinates);
            for (std::size_t next = 1; next < coordinates.size(); ++next)
                look_between(direction, group, coordinates[next - 1], coordinates[next], best);
        }
        if (best.direction < 0) return split_about(group);
        const std::size_t first = elements_.cut(group, best);
        std::array<std::vector<Vec2>, 2> sides;
        for (const Vec2& place : busy) sides[place[best.direction] < best.plane ? 0 : 1].push_back(place);
        const int below = split_between(group.first(first), sides[0]);
        const int above = split_between(group.behind(first), sides[1]);
        return add({.children = {below, above}, .elements = {}});
    }

    /// What lies about a busy place comes first, so that the way from there to the root is short however many the
    /// others are: a square, whose rim is short.
    int split_about(Group group) {
        constexpr std::size_t near = 128;  // elements at most: docs/performance.md
        const std::size_t first =
            elements_.know(about_busy_places) && group.size() >= 2 * near
                ? elements_.cut(group, {about_busy_places, coordinate_of(near, group, about_busy_places)})
                : 0;
        const int others = split(group.behind(first));
        return first > 0 ? add({.children = {others, split(group.first(first))}, .elements = {}}) : others;
    }

    int split(Group group) {
        PartOfElements node;
        if (static_cast<int>(group.size()) <= layout_.leaf_elements) {
            const std::span<const int> elements = elements_.of(group);
            node.elements.assign(elements.begin(), elements.end());
            std::ranges::sort(node.elements);
        } else {
            const std::size_t first = part(group);
            node.children = {split(group.first(first)), split(group.behind(first))};
        }
        return add(std::move(node));
    }

    /// Puts one part before the other and returns how many come first. Where too many lie at one place, it is half.
    [[nodiscard]] std::size_t part(Group group) {
        Cut best;
        for (const int direction : {0, 1, about_busy_places})
            if (elements_.know(direction)) look_across(direction, group, best);
        return best.direction >= 0 ? elements_.cut(group, best) : elements_.halve(group);
    }

    [[nodiscard]] double coordinate_of(std::size_t which, Group group, int direction) const {
        return elements_.coordinate(direction, elements_.of(group, direction)[which]);
    }

    void look_across(int direction, Group group, Cut& best) {
        const std::size_t quarter = group.size() / 4;
        look_between(direction, group, coordinate_of(quarter, group, direction),
                     coordinate_of(group.size() - 1 - quarter, group, direction), best);
    }

    /// Planes at round numbers, of equal ones the roundest, mostly stay where they are when elements come and go.
    void look_between(int direction, Group group, double low, double high, Cut& best) {
        if (!(low < high)) return;
        constexpr int eight_or_more = 3, digits = 50;  // planes, digits of their numbers: as powers of two
        const int finest = std::ilogb(std::max(std::abs(low), std::abs(high))) - digits;
        const double step = std::ldexp(1.0, std::max(std::ilogb(high - low) - eight_or_more, finest));
        const double before = std::floor(low / step);  // the last plane that is not looked at
        const int planes = static_cast<int>(std::floor(high / step) - before);
        count_between(direction, group, before, step, planes);
        int shared = 0, below = 0;
        for (int plane = 0; plane < planes; ++plane) {
            shared += between_[at(plane)].unknowns;
            below += between_[at(plane)].elements;
            if (below == 0 || at(below) == group.size()) continue;
            best = std::min(best, cut_at(direction, before + 1.0 + plane, step, shared, below, group.size()));
        }
    }

    struct Between {
        int elements = 0;
        int unknowns = 0;  // that are shared across the next plane and not the last one, less those the other way round
    };

    /// Of each strip before a plane, and the one behind the last. A bundle is shared across the planes between the last
    /// strip that held it and the next one that does.
    void count_between(int direction, Group group, double before, double step, int planes) {
        between_.assign(at(planes + 1), {});
        int here = 0;
        for (const int element : elements_.of(group, direction)) {
            while (here < planes && elements_.coordinate(direction, element) >= step * (before + 1.0 + here)) ++here;
            ++between_[at(here)].elements;
            for (const int bundle : bundles_.of(element)) {
                const int last = std::exchange(strip_[at(bundle)], strips_ + here) - strips_;
                if (last < 0 || last == here) continue;
                between_[at(last)].unknowns += bundles_.size(bundle);
                between_[at(here)].unknowns -= bundles_.size(bundle);
            }
        }
        strips_ += planes + 1;
    }

    const FrontLayout& layout_;
    SortedElements elements_;
    Bundles bundles_;
    std::vector<int> strip_;  // that was last seen to hold a bundle, of all strips so far
    int strips_ = 0;          // before those at hand
    std::vector<Between> between_;
    std::vector<PartOfElements> nodes_;
};

}  // namespace

std::vector<PartOfElements> bisect(const FrontLayout& layout) { return Bisection(layout).nodes(); }

}  // namespace stria
