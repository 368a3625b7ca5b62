#include "coarse/cycle/hidden_slip.hpp"

#include <algorithm>
#include <cmath>

namespace stria::coarse {
namespace {

using coupling::NearestContact;

constexpr double rounding_of_tractions = 1e-6;
constexpr double least_width = 0.125;  // of the precision: nearer to each other no stations are tried

bool is_same(const NearestContact& a, const NearestContact& b) { return a.behind == b.behind; }
bool rubs(const NearestContact& contact) { return std::isfinite(contact.excess); }

/// The station beyond one of two neighbours of a way, whose contact is the same; null: there is none.
const ClosureStation* beyond(const std::vector<ClosureStation>& way, std::size_t i, bool after, std::size_t k) {
    if (after ? i + 2 >= way.size() : i == 0) return nullptr;
    const ClosureStation &inner = way[after ? i + 1 : i], &outer = way[after ? i + 2 : i - 1];
    if (outer.nearest.empty()) return nullptr;  // nobody has asked
    return is_same(inner.nearest[k], outer.nearest[k]) && !outer.nearest[k].slides() ? &outer : nullptr;
}

/// The excess at a target, if it goes straight on from two stations.
double excess_at(double target, const ClosureStation& outer, const ClosureStation& inner, std::size_t k) {
    return std::lerp(outer.nearest[k].excess, inner.nearest[k].excess,
                     (target - outer.target) / (inner.target - outer.target));
}

// Tractions go straight on while nothing bends their way. Shear that is left where the pressure comes to none was more
// than mu p before: only tractions that vanish together, of elastic faces that part as they have met, slide nowhere.
bool slides_at_no_pressure(const ClosureStation& outer, const ClosureStation& inner, std::size_t k) {
    const double from = outer.nearest[k].pressure, to = inner.nearest[k].pressure;
    if (!(to < from)) return false;
    const double none = std::lerp(outer.target, inner.target, from / (from - to));
    return excess_at(none, outer, inner, k) > rounding_of_tractions * (std::abs(inner.nearest[k].excess) + to);
}

/// One of two contacts has parted, or has been made.
std::optional<Crossing> beside_a_change(const std::vector<ClosureStation>& way, std::size_t i, std::size_t k,
                                        double precision) {
    const double width = std::abs(way[i + 1].target - way[i].target);
    const bool made = way[i + 1].nearest[k].behind < way[i].nearest[k].behind;
    const ClosureStation& inner = way[made ? i + 1 : i];
    if (!rubs(inner.nearest[k])) return std::nullopt;
    if (width > precision) return Crossing{0.5, false};
    if (const ClosureStation* outer = beyond(way, i, made, k))
        return slides_at_no_pressure(*outer, inner, k) ? std::optional(Crossing{0.5, true}) : std::nullopt;
    return width > least_width * precision ? std::optional(Crossing{0.5, false}) : std::nullopt;
}

// Between bends |tau| - mu p is convex: nowhere more than at one of its ends. Where bends make it concave it is nowhere
// more than the straight line that leads on from stations beside it.
std::optional<Crossing> of_the_same(const std::vector<ClosureStation>& way, std::size_t i, std::size_t k,
                                    double precision) {
    const ClosureStation &before = way[i], &after = way[i + 1];
    if (!rubs(before.nearest[k]) || std::abs(after.target - before.target) <= precision) return std::nullopt;
    const double none =
        rounding_of_tractions * std::max(std::abs(before.nearest[k].excess), std::abs(after.nearest[k].excess));
    const ClosureStation *first = beyond(way, i, false, k), *last = beyond(way, i, true, k);
    if (first != nullptr && excess_at(after.target, *first, before, k) <= none) return std::nullopt;
    if (last != nullptr && excess_at(before.target, *last, after, k) <= none) return std::nullopt;
    return Crossing{0.5, false};
}

}  // namespace

bool may_hide_slip(const NearestContact& before, const NearestContact& after) {
    if (!rubs(before) && !rubs(after)) return false;
    return !is_same(before, after) || before.closed != after.closed || before.sliding != after.sliding;
}

std::optional<Crossing> hidden_slip(const std::vector<ClosureStation>& way, std::size_t i, std::size_t k,
                                    double precision) {
    const NearestContact &before = way[i].nearest[k], &after = way[i + 1].nearest[k];
    if (!may_hide_slip(before, after)) return std::nullopt;
    return is_same(before, after) ? of_the_same(way, i, k, precision) : beside_a_change(way, i, k, precision);
}

}  // namespace stria::coarse
