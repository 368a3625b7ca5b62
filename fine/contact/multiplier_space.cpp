#include "fine/contact/multiplier_space.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "common/fem/centre.hpp"
#include "common/index.hpp"
#include "common/index_set.hpp"

namespace stria::fine {
namespace {

// Of an interval. Where a crack enters through a node its end is as long as the next interval, but for this.
constexpr double alike = 0.01;
// Of the next interval, what a multiplier weighs at least; of an opening, what it keeps.
constexpr double least_weight = 0.2;
// Of an element: on branches of 0.03 of one the pressure is off by some percent, on those of 0.1 it is not.
constexpr double too_short = 0.05;
// Of the edge at a mouth, what two multipliers that share a node are apart at least: the inf-sup constant is 0.37 then,
// and more, and goes to zero with that distance (verification.InfSup).
constexpr double far_enough = 0.5;
constexpr double rounding = 1e-9;
constexpr double kink_angle = 10.0 * std::numbers::pi / 180.0;

/// A notch holds an arc length, or ends there: by rounding it does so behind a node or before it. A multiplier at the
/// end of the faces would act on half of its node's share alone.
bool holds_or_ends_at(const Notch& notch, double s) {
    const double close = rounding * (1.0 + s);
    return notch.from != notch.to && s > notch.from - close && s < notch.to + close;
}

struct Stretch {
    double from, to;  // arc lengths, mm; nothing where they do not ascend
};

/// Of a stretch of a crack what lies before its notch, and behind it.
std::array<Stretch, 2> outside(const Notch& notch, const Stretch& whole) {
    if (notch.from == notch.to) return {whole, {whole.to, whole.to}};
    return {Stretch{whole.from, std::min(whole.to, notch.from)}, {std::max(whole.from, notch.to), whole.to}};
}

}  // namespace

MultiplierSpace::MultiplierSpace(const std::vector<double>& points) : nodes_(points), stable_(false) {
    constexpr double far = std::numeric_limits<double>::infinity();
    double from = -far;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const double to = k + 1 < points.size() ? 0.5 * (points[k] + points[k + 1]) : far;
        branches_.push_back({from, to, false, false, 0.0, {}, static_cast<int>(k), 1});
        from = to;
    }
}

MultiplierSpace::MultiplierSpace(const EnrichedMesh& mesh, const std::vector<int>& boundary, int crack,
                                 const Notch& notch, double origin) {
    split_into_branches(mesh, crack, notch);
    join_short_branches(origin);
    for (Branch& branch : branches_) choose_vital(mesh, boundary, origin, branch);
}

void MultiplierSpace::split_into_branches(const EnrichedMesh& mesh, int crack, const Notch& notch) {
    const auto tip_at = [&](double s) {
        return std::ranges::any_of(mesh.tips, [&](const Tip& tip) {
            return tip.crack == crack && std::abs(tip.s - s) < rounding * (1.0 + std::abs(tip.s));
        });
    };
    Vec2 last_tangent = Vec2::Zero();
    for (const CrackPiece& piece : mesh.pieces) {
        if (piece.crack != crack) continue;
        const auto& element = mesh.elements[at(piece.element)];
        const auto note = [&](double place, double s) {
            if (place < 0.0 || holds_or_ends_at(notch, s) || tip_at(s)) return;
            const auto edge = static_cast<std::size_t>(place);
            const bool at_node = place == std::floor(place);
            std::vector<int> nodes;
            for (const std::size_t corner : {edge % 4, at_node ? edge % 4 : (edge + 1) % 4})
                for (const auto& [node, share] : mesh.holders_of_jump(element[corner])) nodes.push_back(node);
            const Vec2 along = mesh.nodes[at(element[(edge + 1) % 4])] - mesh.nodes[at(element[edge % 4])];
            branches_.back().crossings.push_back({s, at_node ? 0.0 : along.norm(), std::move(nodes)});
        };
        for (std::size_t k = 0; k + 1 < piece.points.size(); ++k) {
            const Vec2 tangent = (piece.points[k + 1] - piece.points[k]).normalized();
            for (const auto& [s0, s1] : outside(notch, {piece.s[k], piece.s[k + 1]})) {
                if (s1 <= s0) continue;
                const bool gap = branches_.empty() || s0 - branches_.back().last_s > rounding * (1.0 + s0);
                const bool kink = !gap && std::acos(std::clamp(tangent.dot(last_tangent), -1.0, 1.0)) > kink_angle;
                if (gap || kink) {
                    const double size = edge_of_square(mesh, piece.element);
                    branches_.push_back({s0, s0, tip_at(s0), false, size, {}, 0, 0});
                    if (s0 == piece.s.front()) note(piece.entry, s0);
                }
                branches_.back().last_s = s1;
                branches_.back().tip_at_end = tip_at(s1);
                last_tangent = tangent;
            }
        }
        if (!branches_.empty() && branches_.back().last_s == piece.s.back()) note(piece.exit, piece.s.back());
    }
}

void MultiplierSpace::join_short_branches(double origin) {
    const auto is_short = [](const Branch& b) { return b.last_s - b.first_s < too_short * b.element_size; };
    const auto joins_next = [&](std::size_t k) {
        const Branch &branch = branches_[k], &next = branches_[k + 1];
        const bool touches = next.first_s - branch.last_s <= rounding * (1.0 + next.first_s);
        return touches && (is_short(branch) || is_short(next));
    };
    const auto join_next = [&](std::size_t k) {
        Branch &whole = branches_[k], &next = branches_[k + 1];
        whole.last_s = next.last_s;
        whole.tip_at_end = next.tip_at_end;
        whole.crossings.insert(whole.crossings.end(), next.crossings.begin(), next.crossings.end());
        branches_.erase(branches_.begin() + static_cast<std::ptrdiff_t>(k) + 1);
    };
    const auto holds_or_follows = [&](const Branch& b) { return b.last_s >= origin; };
    const auto home = at(std::ranges::find_if(branches_, holds_or_follows) - branches_.begin());
    for (std::size_t k = home; k + 1 < branches_.size();) {
        if (joins_next(k))
            join_next(k);
        else
            ++k;
    }
    for (std::size_t k = std::min(home, branches_.size() - 1); k > 0; --k)
        if (joins_next(k - 1)) join_next(k - 1);
}

void MultiplierSpace::choose_vital(const EnrichedMesh& mesh, const std::vector<int>& boundary, double origin,
                                   Branch& branch) {
    const auto has_own_jump = [&](int node) {
        for (int term = 1; term <= static_cast<int>(mesh.terms[at(node)].size()); ++term) {
            if (!mesh.follows(node, term) && !std::ranges::binary_search(boundary, mesh.unknown(node, term, 0)))
                return true;
        }
        return false;
    };
    branch.first_multiplier = size();
    std::ranges::stable_sort(branch.crossings, {}, [&](const Crossing& c) { return std::abs(c.s - origin); });
    const auto all_jump = [&](const auto& nodes) { return std::ranges::all_of(nodes, has_own_jump); };
    std::set<int> taken, beside_mouth;  // nodes: of vital crossings; of that beside the one at the mouth
    double s_beside_mouth = 0.0, apart = std::numeric_limits<double>::infinity();
    const auto stands_beside_mouth = [&](const Crossing& crossing) {
        return size() == branch.first_multiplier + 1 && std::abs(crossing.s - origin) >= apart && all_jump(taken) &&
               all_jump(crossing.nodes);
    };
    for (const Crossing& crossing : branch.crossings) {
        if (std::ranges::none_of(crossing.nodes, has_own_jump)) continue;
        if (!contains_any(taken, crossing.nodes)) {
            const bool shares = contains_any(beside_mouth, crossing.nodes);
            if (shares && (std::abs(crossing.s - s_beside_mouth) < apart || !all_jump(crossing.nodes))) continue;
            const bool is_mouth = taken.empty() && std::abs(crossing.s - origin) <= rounding * (1.0 + origin);
            if (is_mouth && crossing.edge > 0.0) apart = far_enough * crossing.edge;
            taken.insert(crossing.nodes.begin(), crossing.nodes.end());
        } else if (stands_beside_mouth(crossing)) {
            s_beside_mouth = crossing.s;
            beside_mouth.insert(crossing.nodes.begin(), crossing.nodes.end());
        } else {
            continue;
        }
        nodes_.push_back(crossing.s);
    }
    std::sort(nodes_.begin() + branch.first_multiplier, nodes_.end());
    if (size() == branch.first_multiplier) nodes_.push_back(0.5 * (branch.first_s + branch.last_s));
    branch.multipliers = size() - branch.first_multiplier;
}

double MultiplierSpace::middle(int multiplier) const {
    const auto is_of_it_alone = [&](const Branch& b) { return b.first_multiplier == multiplier && b.multipliers == 1; };
    const auto alone = std::ranges::find_if(branches_, is_of_it_alone);
    return stable_ && alone != branches_.end() ? 0.5 * (alone->first_s + alone->last_s) : nodes_[at(multiplier)];
}

int MultiplierSpace::branch(double s) const {
    const auto holds = [&](const Branch& b) { return s >= b.first_s && s <= b.last_s; };
    const auto found = std::ranges::find_if(branches_, holds);
    return found != branches_.end() ? static_cast<int>(found - branches_.begin()) : -1;
}

// What the second multiplier loses to the end it gets back from what follows, if anything does: of a uniform opening,
// and of one that grows from nothing at the other end, or faces that gape there would count as touching. Where the
// second multiplier is the one at a tip, too, faces beside it may be all but closed and gape from the next one on: what
// it would get back is not to be counted on.
bool MultiplierSpace::goes_straight_on(const Branch& branch, int outer, int inwards) const {
    const int second = outer + inwards, third = second + inwards;
    const bool is_last = third < branch.first_multiplier || third >= branch.first_multiplier + branch.multipliers;
    if (is_last && (inwards > 0 ? branch.tip_at_end : branch.tip_at_start)) return false;
    const double here = nodes_[at(outer)], interval = std::abs(nodes_[at(second)] - here),
                 end = inwards > 0 ? here - branch.first_s : branch.last_s - here,
                 other_end = inwards > 0 ? branch.last_s - nodes_[at(second)] : nodes_[at(second)] - branch.first_s,
                 next = is_last ? 0.0 : std::abs(nodes_[at(third)] - nodes_[at(second)]),
                 opening = other_end + interval;
    // Integrals of the multiplier's function over the end, the interval and what follows; those of function by opening.
    const double loses = 0.5 * end * end / interval, has = 0.5 * interval, gets = is_last ? other_end : 0.5 * next;
    const double loses_opening = (0.5 * opening * end * end + end * end * end / 3.0) / interval,
                 has_opening = 0.5 * opening * interval - interval * interval / 3.0,
                 gets_opening = is_last ? 0.5 * other_end * other_end : 0.5 * other_end * next - next * next / 6.0;
    return end <= (1.0 + alike) * interval && has - loses + gets >= least_weight * interval &&
           loses_opening <= (1.0 - least_weight) * (has_opening + gets_opening);
}

std::array<MultiplierSpace::Value, 2> MultiplierSpace::acting_at(double s) const {
    const int index = branch(s);
    if (index < 0) return {Value{-1, 0.0}, Value{-1, 0.0}};
    const Branch& b = branches_[at(index)];
    const int first = b.first_multiplier, last = first + b.multipliers - 1;
    const auto node = [&](int k) { return nodes_[at(k)]; };
    const bool constant_at_start = b.tip_at_start || first == last || !goes_straight_on(b, first, 1),
               constant_at_end = b.tip_at_end || first == last || !goes_straight_on(b, last, -1);
    if (constant_at_start && s <= node(first)) return {Value{first, 1.0}, Value{-1, 0.0}};
    if (constant_at_end && s >= node(last)) return {Value{last, 1.0}, Value{-1, 0.0}};
    const auto second = nodes_.begin() + first + 1;
    const int left = first + static_cast<int>(std::upper_bound(second, nodes_.begin() + last, s) - second);
    const double t = (s - node(left)) / (node(left + 1) - node(left));
    return {Value{left, 1.0 - t}, Value{left + 1, t}};
}

}  // namespace stria::fine
