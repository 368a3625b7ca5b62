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

double distance_along_axes(const std::vector<Vec2>& from, const Vec2& x) {
    double least = std::numeric_limits<double>::infinity();
    for (const Vec2& place : from) least = std::min(least, (x - place).lpNorm<Eigen::Infinity>());
    return least;
}

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

    /// What lies about the busy places comes first, so that the way from there to the root is short however many the
    /// others are: squares, whose rims are short.
    std::vector<PartOfElements> nodes() && {
        constexpr std::size_t about_each = 128;  // elements at most: docs/performance.md
        const Group all = elements_.all();
        const std::size_t near = about_each * layout_.busy.size();
        const std::size_t first =
            near > 0 && all.size() >= 2 * near
                ? elements_.cut(all, {about_busy_places, coordinate_of(near, all, about_busy_places)})
                : 0;
        const int others = split(all.behind(first));
        if (first > 0) add({.children = {others, split(all.first(first))}, .elements = {}});
        return std::move(nodes_);
    }

private:
    int add(PartOfElements node) {
        nodes_.push_back(std::move(node));
        return static_cast<int>(nodes_.size()) - 1;
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

    /// A cut is cheap where the parts share few unknowns and neither is much smaller than the other. Planes at round
    /// numbers, of equal ones the roundest, mostly stay where they are when elements come and go.
    void look_across(int direction, Group group, Cut& best) {
        const std::size_t quarter = group.size() / 4;
        const double low = coordinate_of(quarter, group, direction),
                     high = coordinate_of(group.size() - 1 - quarter, group, direction);
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
