#include "coarse/growth/tip_rates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "coarse/enrichment/tip_reach.hpp"
#include "coarse/growth/crack_advance.hpp"
#include "coarse/growth/growth_law.hpp"
#include "coarse/load/growth_schedule.hpp"
#include "coarse/load/load_history.hpp"
#include "coarse/load/rate_law.hpp"
#include "common/case/case_questions.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

/// Where a tip stands, at the end of a cycle.
GrownTip grown_tip(const Scene& present, std::size_t t) {
    const Tip& tip = present.enriched.tips[t];
    return {.behind_turn = behind_sharp_turn(present.input.cracks[at(tip.crack)], tip),
            .resolved = elements_behind_bend * tip_element_edge(present.enriched, tip)};
}

/// What the tips of a crack have grown, on an average, mm: by that its `a` has.
double mean_way(const std::vector<Tip>& tips, const std::vector<double>& ways, std::size_t of_tip) {
    double sum = 0.0, ends = 0.0;
    for (std::size_t t = 0; t < tips.size(); ++t)
        if (tips[t].crack == tips[of_tip].crack) sum += ways[t], ends += 1.0;
    return sum / ends;
}

}  // namespace

TipRates::TipRates(const Case& input, TipRatesMemory memory)
    : growth_(*input.growth), varies_(varies(input)), takes_mean_(takes_mean_rate(input)),
      cut_off_(cycle_cut_off(input.load)), period_(std::move(memory.period)),
      life_(memory.life, exponent_of_K(*input.growth) / 2.0), at_turn_(std::move(memory.at_turn)),
      owed_(std::move(memory.owed)), last_(memory.last) {}

bool TipRates::has_just_turned(std::size_t tip) const { return tip < at_turn_.size() && !std::isnan(at_turn_[tip]); }

bool TipRates::one_has_just_turned(std::size_t tips) const {
    for (std::size_t t = 0; t < tips; ++t)
        if (has_just_turned(t)) return true;
    return false;
}

// Cycles that differ, and openings, which swing from cycle to cycle, tell none.
bool TipRates::tell_a_trend() const { return !varies_ && !grows_by_openings(growth_); }

std::vector<double> TipRates::present() const {
    std::vector<double> rates = period_.present();
    for (std::size_t t = 0; t < rates.size(); ++t)
        if (has_just_turned(t)) rates[t] = std::fmax(rates[t], at_turn_[t]);  // what is not known is not a number
    return rates;
}

bool TipRates::drive_a_tip() const { return fastest_rate(present()) > 0.0; }

bool TipRates::are_of_a_whole_period() const { return !takes_mean_ || period_.memory().cycles >= growth_.every; }

// With the rates at its beginning a slower tip would go too far where its share falls. Beside a tip that has just
// turned they count nevertheless; and rates of two moments make no share.
std::vector<double> TipRates::shares(std::size_t tips) const {
    if (one_has_just_turned(tips)) return shares_of_advance(growth_, present(), tips);
    if (tell_a_trend()) return shares_of_advance(growth_, period_.ahead(), tips);
    std::vector<double> shares = shares_of_advance(growth_, present(), tips);
    for (std::size_t t = 0; t < std::min(tips, owed_.size()); ++t)
        if (shares[t] < 1.0) shares[t] = std::clamp(shares[t] + owed_[t] / last_, 0.0, 1.0);
    return shares;
}

void TipRates::owe(double passed) {
    const std::vector<double>&before = period_.before(), &ways = period_.grown();
    const double way = ways.empty() ? 0.0 : std::ranges::max(ways);
    if (tell_a_trend() || way == 0.0) return;
    const std::vector<double> now = present();
    const bool known = passed > 0.0 && before.size() == now.size() && !one_has_just_turned(now.size());
    owed_.resize(now.size(), 0.0);
    last_ = way;
    for (std::size_t t = 0; t < now.size(); ++t) {
        const double lacks = known ? 0.5 * (before[t] + now[t]) * passed - ways[t] : 0.0;
        owed_[t] = std::isfinite(lacks) ? owed_[t] + lacks : 0.0;
    }
}

std::vector<double> TipRates::lengthening(const std::vector<Tip>& tips) const {
    const std::vector<double> shares = this->shares(tips.size());
    std::vector<double> of_tips;
    for (std::size_t t = 0; t < tips.size(); ++t) of_tips.push_back(mean_way(tips, shares, t));
    return of_tips;
}

void TipRates::leap(const std::vector<SharpTurn>& turns) {
    const std::vector<double> before = present();
    at_turn_.resize(before.size(), not_known);
    for (const SharpTurn& turn : turns) at_turn_[turn.tip] = rate_behind_leap(growth_, before[turn.tip], turn.leap);
    const std::size_t fastest = fastest_of(present());
    if (std::ranges::find(turns, fastest, &SharpTurn::tip) != turns.end()) life_.turn(at_turn_[fastest]);
}

void TipRates::start(std::size_t tip, double rate) {
    at_turn_.resize(std::max(at_turn_.size(), tip + 1), not_known);
    at_turn_[tip] = rate;
    if (fastest_of(present()) == tip) life_.turn(rate);
}

double TipRates::uncounted() const {
    const PeriodMemory period = period_.memory();
    const bool is_under_way = takes_mean_ && period.cycles < growth_.every && !period.grown.empty();
    return uncounted_of_the_past() + (is_under_way ? std::ranges::max(period.grown) : 0.0);
}

void TipRates::count_cycles(int cycle, std::vector<CycleResult>& cycles, const Scene& present) {
    std::vector<double> grown;
    for (const CycleResult& tip : cycles) grown.push_back(tip.da);
    period_.add(growth_rates(growth_, cycles), grown, !takes_mean_ || ends_period(growth_, cycle - 1));
    if (is_prescribed(growth_) || cycles.empty()) return;  // each stands for itself
    const bool is_behind_turn = uncounted_of_the_past() > 0.0;
    for (std::size_t t = 0; t < at_turn_.size(); ++t)
        if (has_just_turned(t) && grown_tip(present, t).is_resolved()) at_turn_[t] = not_known;
    const auto is_long_enough = [&](const CycleResult& tip) { return is_as_long_as_asked(growth_, tip.a); };
    const bool ends = !takes_mean_ && std::ranges::any_of(cycles, is_long_enough);
    const double passed =
        !takes_mean_ || ends_period(growth_, cycle) ? cycles_of_period(present, cycles, cycle, ends) : 0.0;
    owe(is_behind_turn ? 0.0 : passed);
    for (CycleResult& tip : cycles) tip.dN = passed;
}

// The last cycle of a history may return to another maximum than the sequence goes on to: the mean is of another one.
double TipRates::cycles_of_period(const Scene& present, const std::vector<CycleResult>& last, int cycle, bool ends) {
    const std::vector<double>& ways = period_.grown();
    const std::size_t fastest = fastest_of(ways);
    GrownTip grown = grown_tip(present, fastest);
    grown.grown = ways[fastest];
    grown.length = last[fastest].a;
    if (grown.grown > 0.0) grown.lengthening = mean_way(present.enriched.tips, ways, fastest) / grown.grown;
    grown.ends = ends;
    const double before = period_.before().empty() ? 0.0 : period_.before()[fastest], now = this->present()[fastest];
    return life_.passed(grown, before, takes_mean_ && cycle == cut_off_ ? before : now);
}

}  // namespace stria::coarse
