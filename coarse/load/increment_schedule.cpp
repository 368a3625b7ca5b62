#include "coarse/load/increment_schedule.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "common/index.hpp"

namespace stria::coarse {
namespace {

constexpr int least_increments = 4, most_increments = 24, most_pressing_increments = 40;  // of a leg
constexpr double usual_accuracy = 0.002;
constexpr double most_times_as_many = 4.0;  // at a smaller one
// Legs between two measurements: so many alike in a row, and most where they never are. The first comes with the
// fourth.
constexpr int measured_after = 16, in_a_row_before = 3, measured_at_last = 32;
// Of the accuracy: a cycle has two legs, and other cycles may be worse than the one that is measured. Where faces are
// pressed together what a leg is off by stays in what the tip leaves, and adds up as it grows.
constexpr double share_of_leg = 1.0 / 3.0, share_of_pressed_leg = 1.0 / 6.0;
constexpr double share_that_warns = 1.0 / 2.0;  // its part of a cycle
constexpr double least_apart = 0.02;            // of the way: where faces meet, and other ends
constexpr double closing_power = 1.3;           // with which increments grow from where faces meet
// Least numbers of them in a leg that presses faces together; before one has been measured, and where it comes back.
constexpr double pressing_increments = 8.0, first_pressing_increments = 20.0, first_returning_increments = 12.0;
constexpr double share_before_meeting = 0.4;  // of those that press

// A path whose start nobody knows is that of the ramp, virgin metal.
bool is_cycle(const OpeningPath& path) { return !path.way.empty() && path.way.front() == 0.0; }

bool knows_an_opening(const OpeningPath& path) {
    return !path.opening.empty() &&
           std::ranges::any_of(path.opening.back(), [](double mm) { return std::isfinite(mm); });
}

/// Of an opening, mm; zero where it is not known all along.
double range_of(const OpeningPath& path, std::size_t tip) {
    double most = -1e300, least = 1e300;
    for (const std::vector<double>& opening : path.opening) {
        if (!std::isfinite(opening[tip])) return 0.0;
        most = std::max(most, opening[tip]);
        least = std::min(least, opening[tip]);
    }
    return most - least;
}

/// Increments on a part of the way, without splinters.
int room_for(double way) { return std::max(static_cast<int>(way / least_apart), 1); }

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

std::optional<double> error_of_leg(const OpeningPath& path, const std::vector<TwoAsOne>& pairs) {
    std::vector<double> errors(path.opening.empty() ? 0 : path.opening.back().size());  // mm
    for (const TwoAsOne& pair : pairs) {
        const auto end = std::ranges::find(path.way, pair.to);
        const auto k = end - path.way.begin();
        if (end == path.way.end() || k < 2 || end[-2] != pair.from) return std::nullopt;
        const double first = end[-1] - end[-2], second = end[0] - end[-1];
        for (std::size_t tip = 0; tip < std::min(errors.size(), pair.opening.size()); ++tip) {
            const double apart = std::abs(pair.opening[tip] - path.opening[at(k)][tip]);
            if (std::isfinite(apart)) errors[tip] += apart * (first * first + second * second) / (2.0 * first * second);
        }
    }
    std::optional<double> largest;
    for (std::size_t tip = 0; tip < errors.size(); ++tip)
        if (const double range = range_of(path, tip); range > 0.0)
            largest = std::max(largest.value_or(0.0), errors[tip] / range);
    return largest;
}

std::vector<double> graded_ways(int increments, double grading) {
    std::vector<double> ways;
    for (int k = 0; k <= increments; ++k) ways.push_back(std::pow(static_cast<double>(k) / increments, grading));
    return ways;
}

std::vector<double> through_turns(std::vector<double> ways, const std::vector<double>& turns) {
    for (const double turn : turns) {
        const auto inner = std::span(ways).subspan(1, ways.size() - 2);
        const auto distance = [&](double way) { return std::abs(way - turn); };
        if (!inner.empty()) *std::ranges::min_element(inner, {}, distance) = turn;
    }
    return ways;
}

IncrementSchedule::IncrementSchedule(const LoadSection& load, std::vector<double> ways)
    : chooses_(false), accuracy_(load.accuracy), grading_(load.power()), rising_(ways), falling_(std::move(ways)) {}

IncrementSchedule::IncrementSchedule(const LoadSection& load)
    : chooses_(load.steps.is_auto()), accuracy_(load.accuracy), grading_(load.power()) {
    state_.rising =
        state_.falling = {.increments = load.first_steps() / 2, .unmeasured = measured_after - in_a_row_before};
    lay_out();
}

// Errors fall with the square of the number.
double IncrementSchedule::times_as_many() const { return std::sqrt(usual_accuracy / accuracy_); }

int IncrementSchedule::most() const {
    const int usual = state_.presses ? most_pressing_increments : most_increments;
    return static_cast<int>(std::ceil(usual * std::clamp(times_as_many(), 1.0, most_times_as_many)));
}

int IncrementSchedule::within_limits(double wanted) const {
    return static_cast<int>(std::clamp<double>(std::ceil(wanted), least_increments, most()));
}

// Once faces are closed no opening tells what an increment is off by. Where they meet nobody knows in the first leg.
int IncrementSchedule::increments(const Legs& legs) const {
    const bool rises = &legs == &state_.rising;
    const auto [with_load, against_load] = state_.senses;
    const bool closes = rises ? against_load : with_load, opens = rises ? with_load : against_load;
    const bool meet = closes && !state_.meetings.empty(), first = closes && !legs.taken;
    const bool to_be_measured = state_.tells && !legs.knows_pressing;
    const Legs& back = rises ? state_.falling : state_.rising;
    int least = meet ? (back.increments + 1) / 2 : 0;
    double pressing = meet ? pressing_increments : 0.0;
    if (to_be_measured && opens) pressing = first_returning_increments;
    if (to_be_measured && (meet || first)) pressing = first_pressing_increments;
    if (state_.presses && pressing > 0.0) least = std::max(least, within_limits(pressing * times_as_many()));
    return std::max(legs.increments, least);
}

// Places where faces meet are some of the increments, not more of them: what is measured leads to as many as it takes.
// Nor do they leave splinters beside other ends, which no pair could judge.
std::vector<double> IncrementSchedule::ways(const Legs& legs) const {
    if (!chooses_) return graded_ways(legs.increments, grading_);
    const int all = increments(legs);
    if (state_.meetings.empty()) return graded_ways(all, grading_);
    const double first = state_.meetings.front();
    std::vector<double> ways = ways_before(first, all);
    int behind = std::max(all - static_cast<int>(ways.size()) + 1, 1);
    if (state_.presses) behind = std::min(behind, room_for(1.0 - first));
    std::vector<double> closing = graded_ways(behind, closing_power);
    for (double& way : closing) way = std::lerp(first, 1.0, way);
    closing = through_turns(std::move(closing), std::vector(state_.meetings.begin() + 1, state_.meetings.end()));
    ways.pop_back();
    ways.insert(ways.end(), closing.begin(), closing.end());
    return ways;
}

// Before faces meet the tip flows back, and from there on they close, one place after the other, and crush what the tip
// has left. On the way into compression no opening tells of either. So each has its share of the increments however
// many there are, and those before are equal: what flows back does so along all of that way.
std::vector<double> IncrementSchedule::ways_before(double meeting, int all) const {
    std::vector<double> ways;
    if (state_.presses) {
        const int share = static_cast<int>(std::ceil(share_before_meeting * all));
        ways = graded_ways(std::min(share, room_for(meeting)), 1.0);
        for (double& way : ways) way *= meeting;
        return ways;
    }
    ways = graded_ways(all - 1, grading_);
    std::erase_if(ways, [&](double way) { return way > meeting - least_apart; });
    ways.push_back(meeting);
    return ways;
}

void IncrementSchedule::lay_out() {
    rising_ = ways(state_.rising);
    falling_ = ways(state_.falling);
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

// A measurement costs about as much as the leg: one where a block of cycles has come to itself, and one in many after
// it. Where no opening is known, as where a crack is shorter than the distance, it would tell nothing: none is used up.
bool IncrementSchedule::measures(bool rises, bool alike) const {
    const Legs& legs = rises ? state_.rising : state_.falling;
    const int in_a_row = alike ? legs.alike + 1 : 0;
    const bool due =
        legs.unmeasured >= measured_at_last || (legs.unmeasured >= measured_after && in_a_row == in_a_row_before);
    return chooses_ && due && is_cycle(state_.path) && knows_an_opening(state_.path);
}

void IncrementSchedule::add(TwoAsOne pair) {
    std::erase_if(state_.pairs, [&](const TwoAsOne& other) { return other.from == pair.from; });
    state_.pairs.push_back(std::move(pair));
}

void IncrementSchedule::learn(bool rises) {
    Legs& legs = rises ? state_.rising : state_.falling;
    legs.taken = true;
    ++legs.unmeasured;
    if (state_.pairs.empty()) return;
    legs.unmeasured = 0;
    const auto taken = std::ssize(ways(rises)) - 1;
    if (std::ssize(state_.pairs) != taken / 2) return;  // one has led nowhere
    legs.knows_pressing = legs.knows_pressing || state_.presses;
    if (const std::optional<double> error = error_of_leg(state_.path, state_.pairs)) {
        const double share = state_.presses ? share_of_pressed_leg : share_of_leg;
        legs.increments = within_limits(static_cast<double>(taken) * std::sqrt(*error / (share * accuracy_)));
        const double part = static_cast<double>(taken) / legs.increments, left = *error * part * part;
        const bool misses = legs.increments == most() && left > share_that_warns * accuracy_;
        if (misses && !std::exchange(state_.missed, true)) miss_ = left;
        lay_out();
    }
}

void IncrementSchedule::end_leg(bool rises, bool alike) {
    if (!chooses_ || state_.path.way.empty()) return;
    Legs& legs = rises ? state_.rising : state_.falling;
    legs.alike = alike && knows_an_opening(state_.path) ? legs.alike + 1 : 0;
    if (is_cycle(state_.path)) learn(rises);
    state_.pairs.clear();
    begin(std::vector<double>(state_.path.opening.back()));
}

void IncrementSchedule::meet_at(std::vector<double> ways, bool presses, SensesOfK senses) {
    if (!chooses_) return;
    state_.presses = presses;
    state_.senses = senses;
    state_.tells = knows_an_opening(state_.path);
    const auto is_near = [](double a, double b) { return b - a < least_apart; };
    std::erase_if(ways, [](double way) { return way < least_apart || way > 1.0 - least_apart; });
    std::ranges::sort(ways);
    const auto near = std::ranges::unique(ways, is_near);
    ways.erase(near.begin(), near.end());
    state_.meetings = std::move(ways);
    lay_out();
}

}  // namespace stria::coarse
