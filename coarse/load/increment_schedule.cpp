#include "coarse/load/increment_schedule.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "common/index.hpp"

namespace stria::coarse {
namespace {

constexpr int least_increments = 3, most_increments = 24;  // of a leg
constexpr double clearly = 0.75;                           // of the accuracy
constexpr double touching = 0.02;                          // opening at the end, of its range

/// Of one tip.
std::optional<double> curvature_at_end(const OpeningPath& path, std::size_t tip) {
    double most = -1e300, least = 1e300;
    for (const std::vector<double>& opening : path.opening) {
        if (!std::isfinite(opening[tip])) return std::nullopt;
        most = std::max(most, opening[tip]);
        least = std::min(least, opening[tip]);
    }
    const double range = most - least;
    const std::size_t last = path.way.size() - 1;
    if (last < 2 || range <= 0.0 || path.opening[last][tip] < touching * range) return std::nullopt;
    const auto slope = [&](std::size_t k) {
        return (path.opening[k][tip] - path.opening[k - 1][tip]) / (path.way[k] - path.way[k - 1]);
    };
    return std::abs(slope(last) - slope(last - 1)) / (0.5 * (path.way[last] - path.way[last - 2]) * range);
}

}  // namespace

void OpeningPath::begin(std::vector<double> openings) {
    way = {0.0};
    opening = {std::move(openings)};
}

void OpeningPath::add(double at, std::vector<double> openings) {
    const bool goes_on = !opening.empty() && opening.back().size() == openings.size();
    if (!goes_on) *this = {};
    way.push_back(at);
    opening.push_back(std::move(openings));
}

std::optional<double> curvature_at_end(const OpeningPath& path) {
    std::optional<double> largest;
    const std::size_t tips = path.opening.empty() ? 0 : path.opening.front().size();
    for (std::size_t tip = 0; tip < tips; ++tip)
        if (const auto own = curvature_at_end(path, tip)) largest = std::max(largest.value_or(0.0), *own);
    return largest;
}

std::vector<double> graded_ways(int increments, double grading, const std::vector<double>& turns) {
    std::vector<double> ways;
    for (int k = 0; k <= increments; ++k) ways.push_back(std::pow(static_cast<double>(k) / increments, grading));
    for (const double turn : turns) {
        const auto inner = std::span(ways).subspan(1, ways.size() - 2);
        const auto distance = [&](double way) { return std::abs(way - turn); };
        if (!inner.empty()) *std::ranges::min_element(inner, {}, distance) = turn;
    }
    return ways;
}

IncrementSchedule::IncrementSchedule(const LoadSection& load, std::vector<double> turns, bool may_choose)
    : chooses_(load.steps.is_auto() && may_choose), accuracy_(load.accuracy), grading_(load.power()),
      turns_(std::move(turns)) {
    state_.rising = state_.falling = load.first_steps() / 2;
    lay_out();
}

void IncrementSchedule::lay_out() {
    rising_ = graded_ways(state_.rising, grading_, turns_);
    falling_ = graded_ways(state_.falling, grading_, turns_);
}

void IncrementSchedule::resume(const State& state) {
    state_.path = state.path;
    if (!chooses_) return;
    state_ = state;
    lay_out();
}

void IncrementSchedule::begin(std::vector<double> openings) {
    if (chooses_) state_.path.begin(std::move(openings));
}

void IncrementSchedule::add(double way, std::vector<double> openings) {
    if (chooses_) state_.path.add(way, std::move(openings));
}

double IncrementSchedule::error(double curvature, int increments) const {
    const std::vector<double> ways = graded_ways(increments, grading_);
    return curvature * std::pow(1.0 - ways[at(increments - 1)], 2) / 6.0;
}

int IncrementSchedule::enough(double curvature, int present) const {
    int increments = present;
    while (increments < most_increments && error(curvature, increments) > accuracy_) ++increments;
    const bool fewer_do = increments > least_increments && error(curvature, increments - 1) < clearly * accuracy_;
    return increments == present && fewer_do ? increments - 1 : increments;
}

// A path whose start nobody knows is that of the ramp, virgin metal, which is no cycle.
void IncrementSchedule::learn(int& present, bool rises) {
    if (state_.path.way.front() > 0.0) return;
    if (const std::optional<double> curvature = curvature_at_end(state_.path))
        present = enough(*curvature, present);
    else if (!rises)
        present = state_.rising;
    lay_out();
}

void IncrementSchedule::end_leg(bool rises) {
    if (!chooses_ || state_.path.way.empty()) return;
    learn(rises ? state_.rising : state_.falling, rises);
    begin(std::vector<double>(state_.path.opening.back()));
}

}  // namespace stria::coarse
