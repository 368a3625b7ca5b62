#include "coarse/load/load_controller.hpp"

#include <algorithm>
#include <cmath>

#include "common/error.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {

/// Where loads lag or travel legs are no straight ways, and the load is not slow where that of [load] turns.
IncrementSchedule schedule_of(const LoadSection& load, const CaseHistories& cases) {
    if (!cases.peak_between_ends()) return IncrementSchedule(load);
    const std::vector<double> turns = cases.turns();
    const int increments = load.first_steps() / 2;
    const bool by_angle = !load.grading && !turns.empty();
    return {load,
            through_turns(by_angle ? cases.at_equal_angles(increments) : graded_ways(increments, load.power()), turns)};
}

}  // namespace

LoadController::LoadController(const LoadSection& load, const SolverSection& solver, CaseHistories cases)
    : control_(load.control == Control::Displacement ? Control::Displacement : Control::Load), cases_(std::move(cases)),
      legs_(cases_.legs().empty() ? legs(load) : cases_.legs()), schedule_(schedule_of(load, cases_)),
      remembered_(remembered_increments(load.steps)), max_cuts_(solver.max_cuts) {
    position_.cases = Eigen::VectorXd::Zero(cases_.count());
}

LoadPosition LoadController::position() const {
    LoadPosition position = position_;
    position.schedule = schedule_.state();
    return position;
}

void LoadController::resume(const LoadPosition& position) {
    position_ = position;
    schedule_.resume(position.schedule);
    // A history that had ended knew of no next leg.
    if (begins_leg() && position_.leg > 0 && !cases_.ends_leg_at(position_.leg - 1, position_.cases))
        throw CaseError("cannot go on from this checkpoint: the history ended there, and in the longer one a load case "
                        "rises to another factor in that cycle");
}

double LoadController::end_of_leg() const { return scale_ * legs_[position_.leg].to; }

// A way of no length ends at the extreme that is asked for.
bool LoadController::turns_at_end() const {
    const std::size_t next = position_.leg + 1;
    if (!begins_where_boundary_stands() || next == legs_.size()) return legs_[position_.leg].reversal;
    return (end_of_leg() - position_.leg_start) * (legs_[next].to - legs_[next].from) <= 0.0;
}

// Near a turn of [load] a load case that lags changes by much where [load] hardly does.
double LoadController::part_of_loads() const {
    const LoadStep step = *next();
    const double largest = std::max(std::abs(position_.leg_start), std::abs(end_of_leg()));
    double part = std::abs(step.target.value - position_.reached) / largest;
    if (cases_.count() == 0) return part;
    const Eigen::ArrayXd changes = (step.target.cases - position_.cases).array().abs(), most = largest_cases();
    for (Eigen::Index k = 0; k < changes.size(); ++k)
        if (changes[k] > 0.0) part = std::max(part, changes[k] / std::max(most[k], changes[k]));
    return part;
}

Eigen::ArrayXd LoadController::largest_cases() const {
    Eigen::ArrayXd largest = Eigen::ArrayXd::Zero(cases_.count());
    for (int k = 0; k <= increments(); ++k) largest = largest.max(cases_at_stop(k).array().abs());
    return largest;
}

double LoadController::stop(int increment) const {
    if (increment == 0) return position_.leg_start;
    if (increment == increments()) return end_of_leg();  // exact: later legs start from the same number
    return position_.leg_start + (end_of_leg() - position_.leg_start) * ways()[at(increment)];
}

int LoadController::stop_nearest_to_zero() const {
    int nearest = 1;
    for (int k = 2; k <= increments(); ++k)
        if (std::abs(stop(k)) < std::abs(stop(nearest))) nearest = k;
    return nearest;
}

LoadController::Way LoadController::next_way() const {
    const double from = ways()[at(position_.increments)], to = ways()[at(position_.increments + 1)];
    const double part = position_.fraction * (to - from);
    const bool arrives = to - position_.way <= part * (1.0 + 1e-9);
    return {arrives ? to : position_.way + part, arrives};
}

double LoadController::size_of_next(const Way& taken) const {
    const double from = ways()[at(position_.increments)], whole = ways()[at(position_.increments + 1)] - from;
    const double size = (taken.end - position_.way) / whole, then = fraction_of_next();
    return (taken.arrives ? then : std::min(then, 1.0 - (taken.end - from) / whole)) / size;
}

double LoadController::fraction_of_next() const {
    return position_.consecutive_cuts > 0 ? std::min(1.0, 2.0 * position_.fraction) : position_.fraction;
}

Eigen::VectorXd LoadController::cases_at(double way) const {
    const double from = ways()[at(position_.increments)], to = ways()[at(position_.increments + 1)];
    return cases_.at({.leg = position_.leg,
                      .way = way,
                      .increment = position_.increments + 1,
                      .share = (way - from) / (to - from),
                      .scale = scale_});
}

Eigen::VectorXd LoadController::cases_at_stop(std::size_t leg, int increment) const {
    return cases_.at({.leg = leg,
                      .way = schedule_.ways(rises(leg))[at(increment)],
                      .increment = std::max(increment, 1),
                      .share = increment > 0 ? 1.0 : 0.0,
                      .scale = scale_});
}

std::optional<LoadStep> LoadController::next() const {
    if (position_.leg >= legs_.size()) return std::nullopt;
    const Leg& leg = legs_[position_.leg];
    const int increment = position_.increments + 1;
    const auto [way, arrives] = next_way();
    const double part = position_.fraction * (stop(increment) - stop(increment - 1));
    LoadStep step;
    step.cycle = leg.cycle;
    step.moment = leg.cycle - (leg.at_minimum || leg.leads ? 0.5 : 0.0) - 0.5 * (1.0 - way);
    step.target = {control(), arrives ? stop(increment) : position_.reached + part};
    if (cases_.count() > 0) step.target.cases = cases_at(way);
    step.predictor = predictor_from(position_.taken, taken_by(step));
    step.next_over_this = size_of_next({way, arrives});
    step.bends = arrives && (leg.leads ? way == 1.0 : cases_.have_corner(way));
    if (arrives && increment == increments()) {
        step.reversal = turns_at_end();
        step.at_maximum = leg.at_maximum;
        step.at_minimum = leg.at_minimum;
        step.ends_cycle = leg.ends_cycle;
    }
    step.at_zero = arrives && position_.leg_start * end_of_leg() < 0.0 && increment == stop_nearest_to_zero();
    return step;
}

std::vector<LoadFactors> LoadController::next_quarter() const {
    constexpr int parts = 64;
    constexpr double quarter = 0.5, farther = 1e-4;  // of the half cycle
    if (!looks_ahead()) return {};
    std::vector<double> ways = cases_.at_equal_angles(2 * parts);
    ways.resize(parts + 1);
    ways.push_back(cases_.at_angle(quarter + farther));  // what turns where the quarter ends falls
    for (const double turn : cases_.turns())             // a sharp one may be the peak
        if (const auto after = std::ranges::lower_bound(ways, turn); after != ways.end() && *after != turn)
            ways.insert(after, turn);
    std::vector<LoadFactors> loads;
    for (const double way : ways) loads.push_back(cases_.turning_back(position_.leg, way, scale_));
    return loads;
}

// By twos from the end of the leg: where their number is odd, the first one is the elastic stretch behind a reversal.
std::optional<LoadStep> LoadController::two_as_one() const {
    const int left = position_.leg < legs_.size() ? increments() - position_.increments : 0;
    if (left < 2 || left % 2 != 0 || position_.fraction < 1.0 || !schedule_.measures(rises(), is_alike()))
        return std::nullopt;
    LoadStep step = *next();
    const double first = step.target.value - position_.reached;
    step.target.value = stop(position_.increments + 2);
    step.target.cases = cases_at_stop(position_.increments + 2);
    step.predictor.factor *= (step.target.value - position_.reached) / first;
    return step;
}

void LoadController::tried_as_one(std::vector<double> openings) {
    const double from = ways()[at(position_.increments)], to = ways()[at(position_.increments + 2)];
    schedule_.add(TwoAsOne{from, to, std::move(openings)});
}

bool LoadController::is_alike() const {
    if (position_.leg < 2) return false;
    const std::size_t now = position_.leg, before = now - 2;
    const Leg &leg = legs_[now], &other = legs_[before];
    const int all = increments();
    return other.cycle > 0 && leg.from == other.from && leg.to == other.to &&
           cases_at_stop(now, 0) == cases_at_stop(before, 0) && cases_at_stop(now, all) == cases_at_stop(before, all);
}

TakenIncrement LoadController::taken_by(const LoadStep& step) const {
    return {step.cycle, position_.reached / scale_, step.target.value / scale_, position_.cases, step.target.cases};
}

void LoadController::remember(const TakenIncrement& last) {
    std::vector<TakenIncrement>& taken = position_.taken;
    taken.insert(taken.begin(), last);
    if (taken.size() > remembered_) taken.pop_back();
}

void LoadController::judge_predictor(bool misled) {
    position_.misled = misled ? position_.misled + 1 : 0;
    if (position_.misled < 2) return;
    forget_increments();
    position_.misled = 0;
}

void LoadController::committed_besides(int cycle, std::vector<double> openings) {
    schedule_.begin(std::move(openings));
    const double here = position_.reached / scale_;
    remember({cycle, here, here, position_.cases, position_.cases});
}

// A way that rounding alone is the length of is none: what follows would be predicted from it.
void LoadController::stands_at(double displacement) {
    constexpr double rounding = 1e-9;  // of the largest displacement asked for
    if (!begins_leg() || !begins_where_boundary_stands()) return;
    const auto size = [](const Leg& leg) { return std::abs(leg.to); };
    const double largest = size(std::ranges::max(legs_, {}, size));
    const bool is_there = std::abs(end_of_leg() - displacement) <= rounding * largest;
    position_.leg_start = position_.reached = is_there ? end_of_leg() : displacement;
}

std::optional<LegEnds> LoadController::leg_that_begins(const UnitDisplacement& unit) const {
    if (!begins_leg()) return std::nullopt;
    LegEnds leg{.from = {position_.leg_start}, .to = {end_of_leg()}, .course = end_of_leg() - position_.leg_start};
    if (cases_.count() > 0) {
        leg.from.cases = cases_at_stop(0);
        leg.to.cases = cases_at_stop(increments());
    }
    if (control() != Control::Displacement) return leg;
    leg.from.main = begins_where_boundary_stands() ? 0.0 : unit.load_factor_at(leg.from.main, leg.from.cases);
    leg.to.main = unit.load_factor_at(leg.to.main, leg.to.cases);
    return leg;
}

void LoadController::expect(const LegOutlook& outlook) {
    const double from = position_.leg_start, to = end_of_leg();
    std::vector<double> ways;
    for (const double load : outlook.met)
        if (const double way = (scale_ * load - from) / (to - from); way > 0.0 && way < 1.0) ways.push_back(way);
    schedule_.meet_at(std::move(ways), outlook.presses, outlook.senses);
}

// What dead loads do as they come on is no cycle's.
void LoadController::accepted(std::vector<double> openings) {
    const LoadStep step = *next();
    const bool leads = legs_[position_.leg].leads;
    const auto [way, arrives] = next_way();
    remember(taken_by(step));
    position_.reached = step.target.value;
    position_.cases = step.target.cases;
    position_.way = way;
    if (!leads) schedule_.add(way, std::move(openings));
    if (arrives) ++position_.increments;
    if (position_.increments == increments()) {
        if (!leads) schedule_.end_leg(rises(), is_alike());
        ++position_.leg;
        position_.increments = 0;
        position_.leg_start = position_.reached;
        position_.way = 0.0;
    }
    position_.fraction = fraction_of_next();
    position_.consecutive_cuts = std::max(position_.consecutive_cuts - 1, 0);
}

bool LoadController::cut() {
    if (position_.consecutive_cuts >= max_cuts_) return false;
    ++position_.consecutive_cuts;
    ++position_.cuts;
    position_.fraction /= 2.0;
    return true;
}

}  // namespace stria::coarse
