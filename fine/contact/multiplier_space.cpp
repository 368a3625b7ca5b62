#include "fine/contact/multiplier_space.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stria::fine {
namespace {

constexpr double hat_spacing = 1.0;  // chords
constexpr double shortest_branch = 0.75;                               // chords
constexpr double kink_angle = 10.0 * std::numbers::pi / 180.0;

/// Chord h = min(hx/|tx|, hy/|ty|) of a displacement element along a direction (never of its sub-cells).
double chord_length(const EnrichedMesh& mesh, int element, const Vec2& tangent) {
    Vec2 low = Vec2::Constant(1e300), high = -low;
    for (const int node : mesh.elements[static_cast<std::size_t>(element)]) {
        low = low.cwiseMin(mesh.nodes[static_cast<std::size_t>(node)]);
        high = high.cwiseMax(mesh.nodes[static_cast<std::size_t>(node)]);
    }
    const Vec2 size = high - low;
    return std::min(size.x() / std::max(std::abs(tangent.x()), 1e-12), size.y() / std::max(std::abs(tangent.y()), 1e-12));
}

}  // namespace

MultiplierSpace::MultiplierSpace(const EnrichedMesh& mesh, int crack, double notch) {
    split_into_branches(mesh, crack, notch);
    join_short_branches();
    for (Branch& branch : branches_) place_hats(branch);
}

void MultiplierSpace::split_into_branches(const EnrichedMesh& mesh, int crack, double notch) {
    const auto tip_at = [&](double s) {
        return std::ranges::any_of(mesh.tips, [&](const Tip& tip) { return tip.crack == crack && std::abs(tip.s - s) < 1e-9 * (1.0 + tip.s); });
    };
    Vec2 last_tangent = Vec2::Zero();
    double last_s = -1.0;
    for (const CrackPiece& piece : mesh.pieces) {
        if (piece.crack != crack) continue;
        for (std::size_t k = 0; k + 1 < piece.points.size(); ++k) {
            const double s0 = std::max(piece.s[k], notch), s1 = piece.s[k + 1];
            if (s1 <= s0) continue;
            const Vec2 tangent = (piece.points[k + 1] - piece.points[k]).normalized();
            const bool gap = branches_.empty() || s0 - last_s > 1e-9 * (1.0 + s0);
            const bool kink = !gap && std::acos(std::clamp(tangent.dot(last_tangent), -1.0, 1.0)) > kink_angle;
            if (gap || kink) {
                branches_.push_back({});
                branches_.back().stations.push_back({s0, 0.0});
                branches_.back().tip_at_start = tip_at(s0);
            }
            auto& stations = branches_.back().stations;
            stations.push_back({s1, stations.back().measure + (s1 - s0) / chord_length(mesh, piece.element, tangent)});
            branches_.back().tip_at_end = tip_at(s1);
            last_tangent = tangent;
            last_s = s1;
        }
    }
}

void MultiplierSpace::join_short_branches() {
    for (std::size_t b = 0; b < branches_.size() && branches_.size() > 1;) {
        const bool joins_last = b > 0 && std::abs(branches_[b - 1].stations.back().s - branches_[b].stations.front().s) < 1e-9;
        const bool joins_next = b + 1 < branches_.size() && std::abs(branches_[b].stations.back().s - branches_[b + 1].stations.front().s) < 1e-9;
        if (branches_[b].chords() >= shortest_branch || (!joins_last && !joins_next)) {
            ++b;
            continue;
        }
        const std::size_t into = joins_last ? b - 1 : b, from = joins_last ? b : b + 1;
        Branch &target = branches_[into], &source = branches_[from];
        for (std::size_t k = 1; k < source.stations.size(); ++k) {
            const double step = source.stations[k].measure - source.stations[k - 1].measure;
            target.stations.push_back({source.stations[k].s, target.stations.back().measure + step});
        }
        target.tip_at_end = source.tip_at_end;
        branches_.erase(branches_.begin() + static_cast<std::ptrdiff_t>(from));
        b = into;
    }
}

double MultiplierSpace::Branch::position(double measure) const {
    for (std::size_t k = 1; k < stations.size(); ++k) {
        if (measure > stations[k].measure) continue;
        const double fraction = (measure - stations[k - 1].measure) / (stations[k].measure - stations[k - 1].measure);
        return stations[k - 1].s + fraction * (stations[k].s - stations[k - 1].s);
    }
    return stations.back().s;
}

void MultiplierSpace::place_hats(Branch& branch) {
    const double chords = branch.chords();
    int intervals = static_cast<int>(std::floor(chords / hat_spacing));
    if (intervals <= 2 && branch.tip_at_start && branch.tip_at_end) intervals = 0;
    const bool constant = intervals == 0;
    intervals = std::max(intervals, 1);
    for (int k = 0; k <= intervals; ++k) branch.hats.push_back(branch.position(chords * k / intervals));
    branch.hats.front() = branch.stations.front().s;
    branch.hats.back() = branch.stations.back().s;
    // At a tip the last hat is folded into its neighbour: constant pressure over the last interval.
    branch.first_hat = branch.tip_at_start ? 1 : 0;
    branch.last_hat = constant ? branch.first_hat : intervals - (branch.tip_at_end ? 1 : 0);
    branch.first_multiplier = size_;
    for (int hat = branch.first_hat; hat <= branch.last_hat; ++hat) {
        nodes_.push_back(constant ? 0.5 * (branch.hats.front() + branch.hats.back()) : branch.hats[static_cast<std::size_t>(hat)]);
        chords_.push_back((branch.hats.back() - branch.hats.front()) / std::max(chords, 1e-300));
    }
    size_ += branch.last_hat - branch.first_hat + 1;
}

std::array<MultiplierSpace::Value, 2> MultiplierSpace::at(double s) const {
    for (const Branch& branch : branches_) {
        if (s < branch.hats.front() || s > branch.hats.back()) continue;
        const auto after = std::ranges::upper_bound(branch.hats, s) - branch.hats.begin();
        const int right = static_cast<int>(std::clamp<std::ptrdiff_t>(after, 1, std::ssize(branch.hats) - 1));
        const double s0 = branch.hats[static_cast<std::size_t>(right - 1)], s1 = branch.hats[static_cast<std::size_t>(right)];
        const double t = (s - s0) / (s1 - s0);
        const auto multiplier = [&](int hat) {
            return branch.first_multiplier + std::clamp(hat, branch.first_hat, branch.last_hat) - branch.first_hat;
        };
        if (multiplier(right - 1) == multiplier(right)) return {Value{multiplier(right), 1.0}, Value{-1, 0.0}};
        return {Value{multiplier(right - 1), 1.0 - t}, Value{multiplier(right), t}};
    }
    return {Value{-1, 0.0}, Value{-1, 0.0}};
}

}  // namespace stria::fine
