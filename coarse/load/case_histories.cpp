#include "coarse/load/case_histories.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "common/case/case_questions.hpp"
#include "common/case/loads/load_increments.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {

constexpr double half_cycle = 180.0;  // degrees

/// Part of the way between two turns at a part of the angle between them, and back.
double way_at(LagPath path, double angle) {
    return path == LagPath::Triangle ? angle : 0.5 * (1.0 - std::cos(std::numbers::pi * angle));
}
double angle_at(LagPath path, double way) {
    return path == LagPath::Triangle ? way : std::acos(std::clamp(1.0 - 2.0 * way, -1.0, 1.0)) / std::numbers::pi;
}

/// The last cycle of each block.
std::vector<int> ends_of(const std::vector<CaseBlock>& blocks) {
    std::vector<int> ends;
    for (const CaseBlock& block : blocks) ends.push_back((ends.empty() ? 0 : ends.back()) + block.cycles);
    return ends;
}

}  // namespace

int positions_of_travel(const LoadSection& load) { return load.first_steps() + 1; }

std::vector<std::string> travel_warnings(const Case& input) {
    const int steps = input.load.first_steps(), enough = increments_of_travel(input.boundaries, 0.5);
    if (steps >= enough) return {};
    return {fmt::format("load.steps = {}: a pressure that travels goes on by more than half of its half width in an "
                        "increment, and passes over the largest K; \"auto\" takes {}",
                        steps, increments_of_travel(input.boundaries, 0.25))};
}

CaseHistories::CaseHistories(const Case& input)
    : load_(input.load), cases_(input.load_cases),
      travelling_(std::ranges::count_if(input.boundaries, [](const auto& b) { return b.travelling.has_value(); })),
      cycles_(cycle_count(input.load)), legs_(stria::coarse::legs(input.load)) {
    for (const LoadCaseSection& load_case : cases_) ends_of_blocks_.push_back(ends_of(load_case.blocks));
    const bool dead = std::ranges::any_of(cases_, [](const auto& c) { return c.constant.has_value(); });
    const bool leads = dead || travelling_ > 0;
    // To a first displacement of zero there is a way from where these, or an initial stress, have moved the boundary.
    if (input.load.control == Control::Displacement && (leads || has_initial_stress(input)) &&
        (legs_.empty() || input.load.blocks.front().max == 0.0))
        put_first({.cycle = 0, .from = 0.0, .to = 0.0, .at_maximum = true, .reversal = true});
    if (leads) put_first({.cycle = 0, .from = 0.0, .to = 0.0, .leads = true});
}

void CaseHistories::put_first(const Leg& leg) {
    legs_.insert(legs_.begin(), leg);
    ++put_first_;
}

Eigen::Index CaseHistories::count() const { return std::ssize(cases_) + travelling_ * positions_of_travel(load_); }

bool CaseHistories::have_corner(double way) const {
    const auto is_round = [](const LoadCaseSection& load_case) {
        return load_case.constant || (load_case.factor && load_case.path == LagPath::Sine);
    };
    if (lag() && std::ranges::all_of(cases_, is_round)) return false;
    return way == 1.0 || std::ranges::binary_search(turns(), way);
}

std::vector<double> CaseHistories::turns() const {
    std::vector<double> turns;
    for (const LoadCaseSection& load_case : cases_)
        if (lags(load_case))
            turns.push_back(way_at(load_case.path, std::fmod(load_case.phase, half_cycle) / half_cycle));
    std::ranges::sort(turns);
    turns.erase(std::unique(turns.begin(), turns.end()), turns.end());
    return turns;
}

double CaseHistories::at_angle(double part) const {
    const auto first = std::ranges::find_if(cases_, lags);
    return way_at(first != cases_.end() ? first->path : LagPath::Triangle, part);
}

std::vector<double> CaseHistories::at_equal_angles(int increments) const {
    std::vector<double> ways;
    for (int k = 0; k <= increments; ++k) ways.push_back(at_angle(static_cast<double>(k) / increments));
    return ways;
}

Eigen::VectorXd CaseHistories::at(const LoadPlace& place) const {
    Eigen::VectorXd factors = Eigen::VectorXd::Zero(count());
    Eigen::Index k = 0;
    for (; k < std::ssize(cases_); ++k) factors[k] = factor(stria::at(k), place);
    for (Eigen::Index t = 0; t < travelling_; ++t, k += positions_of_travel(load_)) put_travelling(place, k, factors);
    return factors;
}

Eigen::VectorXd CaseHistories::at_start() const {
    return leads() ? at({.leg = 0, .way = 1.0}) : Eigen::VectorXd::Zero(count());
}

Eigen::VectorXd CaseHistories::dead() const {
    Eigen::VectorXd factors = Eigen::VectorXd::Zero(count());
    for (std::size_t k = 0; k < cases_.size(); ++k)
        if (is_dead(k)) factors[static_cast<Eigen::Index>(k)] = *cases_[k].constant;
    return factors;
}

double CaseHistories::factor(std::size_t k, const LoadPlace& place) const {
    const LoadCaseSection& load_case = cases_[k];
    const bool leads = legs_[place.leg].leads;
    if (load_case.constant) return leads ? place.way * *load_case.constant : *load_case.constant;
    if (leads) return 0.0;
    return load_case.factor ? lagging(load_case, place) : of_blocks(k, place);
}

// The main load's history, some of its angle later. Before it begins there is no load.
double CaseHistories::lagging(const LoadCaseSection& load_case, const LoadPlace& place) const {
    const std::size_t first = leads() ? 1 : 0;
    double leg = static_cast<double>(place.leg), way = place.way;
    if (load_case.phase > 0.0) {
        const double angle = leg + angle_at(load_case.path, place.way) - load_case.phase / half_cycle;
        leg = std::min(std::floor(angle), leg);
        if (leg < static_cast<double>(first)) return 0.0;
        way = way_at(load_case.path, angle - leg);
    }
    const Leg& then = legs_[static_cast<std::size_t>(leg)];
    return *load_case.factor * place.scale * (then.from + (then.to - then.from) * way);
}

LoadFactors CaseHistories::turning_back(std::size_t leg, double way, double scale) const {
    LoadFactors loads(scale * std::lerp(legs_[leg].to, legs_[leg].from, way), Eigen::VectorXd(std::ssize(cases_)));
    for (std::size_t k = 0; k < cases_.size(); ++k)
        loads.cases[static_cast<Eigen::Index>(k)] = turning_back(k, leg, way, scale);
    return loads;
}

// What it lags behind may still be on its way to the end of the leg.
double CaseHistories::turning_back(std::size_t k, std::size_t leg, double way, double scale) const {
    const LoadCaseSection& load_case = cases_[k];
    if (!load_case.factor) return factor(k, {.leg = leg, .way = 1.0 - way, .scale = scale});
    const double angle = static_cast<double>(leg) + 1.0 + angle_at(load_case.path, way) - load_case.phase / half_cycle;
    const double whole = std::floor(angle);
    if (whole < (leads() ? 1.0 : 0.0)) return 0.0;
    const bool has_turned = whole > static_cast<double>(leg);
    const Leg& then = legs_[has_turned ? leg : static_cast<std::size_t>(whole)];
    const double part = way_at(load_case.path, angle - whole);
    return *load_case.factor * scale * std::lerp(then.from, then.to, has_turned ? 1.0 - part : part);
}

double CaseHistories::of_blocks(std::size_t k, const LoadPlace& place) const {
    const bool first = place.leg == 0 || legs_[place.leg - 1].leads;
    const double from = first ? 0.0 : at_end_of(k, place.leg - 1), to = at_end_of(k, place.leg);
    return from + (to - from) * place.way;
}

bool CaseHistories::ends_leg_at(std::size_t leg, const Eigen::VectorXd& factors) const {
    constexpr double rounding = 1e-9;
    for (std::size_t k = 0; k < cases_.size(); ++k) {
        if (cases_[k].blocks.empty()) continue;
        const double end = at_end_of(k, leg), factor = factors[static_cast<Eigen::Index>(k)];
        if (std::abs(end - factor) > rounding * (1.0 + std::abs(end))) return false;
    }
    return true;
}

// A leg to a maximum belongs to the cycle before; the last maximum is that of the last cycle.
double CaseHistories::at_end_of(std::size_t k, std::size_t leg) const {
    if (legs_[leg].at_minimum) return block_of_cycle(k, legs_[leg].cycle).at_min;
    return block_of_cycle(k, std::min(legs_[leg].cycle + 1, cycles_)).at_max;
}

// Of the repeated sequence, from 1. A spectrum has a block for each cycle.
const CaseBlock& CaseHistories::block_of_cycle(std::size_t k, int cycle) const {
    const std::vector<int>& ends = ends_of_blocks_[k];
    const int within = (cycle - 1) % ends.back() + 1;
    return cases_[k].blocks[stria::at(std::ranges::lower_bound(ends, within) - ends.begin())];
}

// From one whole increment to the next the load at one position gives way to that at the next; so does the last
// position of a cycle to the first ones of the next cycle.
void CaseHistories::put_travelling(const LoadPlace& place, Eigen::Index first, Eigen::VectorXd& factors) const {
    const Leg& leg = legs_[place.leg];
    if (leg.leads || leg.cycle == 0) {
        factors[first] = leg.leads ? place.way : 1.0;
        return;
    }
    const bool goes_down = place.leg == 0 || legs_[place.leg - 1].cycle != leg.cycle;
    const Eigen::Index to = place.increment + (goes_down ? 0 : load_.first_steps() / 2);
    const Eigen::Index from = to == 1 && leg.cycle > 1 ? load_.first_steps() : to - 1;
    factors[first + from] += 1.0 - place.share;
    factors[first + to] += place.share;
}

// A dead load is there before any other, and stays. All others begin from nothing.
std::pair<double, double> CaseHistories::extremes(const LoadCaseSection& load_case, double scale) const {
    if (load_case.constant) return {*load_case.constant, *load_case.constant};
    std::vector<double> factors{0.0};
    for (const LoadBlock& block : load_.blocks)
        for (const double value : {block.max, block.min})
            factors.push_back(load_case.factor.value_or(0.0) * scale * load_.scale * value);
    for (const CaseBlock& block : load_case.blocks)
        for (const double value : {block.at_max, block.at_min}) factors.push_back(value);
    const auto [least, most] = std::ranges::minmax(factors);
    return {least, most};
}

double CaseHistories::largest_sum(const std::vector<double>& of_unit, double scale) const {
    double sum = 0.0;
    std::size_t k = 0;
    for (const LoadCaseSection& load_case : cases_) {
        const auto [least, most] = extremes(load_case, scale);
        const double unit = of_unit[k++];
        sum += std::max(most * unit, least * unit);
    }
    for (Eigen::Index t = 0; t < travelling_; ++t) {
        const auto positions = of_unit.begin() + static_cast<std::ptrdiff_t>(k);
        sum += std::max(0.0, *std::max_element(positions, positions + positions_of_travel(load_)));
        k += static_cast<std::size_t>(positions_of_travel(load_));
    }
    return sum;
}

}  // namespace stria::coarse
