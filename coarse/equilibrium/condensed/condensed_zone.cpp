#include "coarse/equilibrium/condensed/condensed_zone.hpp"

#include <utility>

#include "common/stopwatch.hpp"

namespace stria::coarse {

void CondensedZone::begin(const Predictor& predictor, double held) {
    request_ = {.predictor = predictor, .put_aside = std::exchange(put_aside_, false), .held = held, .boundary = {}};
}

void CondensedZone::settle_below(double factor_serves, double may_be_last) {
    request_.settled_below = factor_serves;
    request_.last_below = may_be_last;
}

void CondensedZone::move(double part, bool further) {
    request_.step = part;
    request_.further = further;
    ++request_.iteration;
}

void CondensedZone::ask(const GammaState& state, const std::function<void()>& meanwhile) {
    const Stopwatch watch(effort_.exchange_s);
    request_.load_factor = state.load_factor;
    request_.cases = state.cases;
    request_.boundary = state.displacement;
    fine_->request(request_);
    request_.check_rest = false;
    meanwhile();
    answer_ = fine_->collect();
    if (coupling_.state == StateCrosses::EachIterate)
        (void)fine_->state();  // the user pays for seeing every iterate cross
    if (answer_.same_tangent) return;
    tangent_ = std::move(answer_.tangent);
    new_tangent_ = true;
}

void CondensedZone::begin_commit(const coupling::Commit& what) {
    if (exists()) fine_->begin_commit(what);
}

coupling::StepReport CondensedZone::commit(const coupling::Commit& what) {
    if (!exists()) return {};
    const Stopwatch watch(effort_.exchange_s);
    coupling::StepReport report = fine_->commit(what);
    if (coupling_.state == StateCrosses::WhereWanted)
        ++effort_.work.states_not_sent;
    else
        (void)fine_->state();
    return report;
}

void CondensedZone::rollback() {
    if (exists()) fine_->rollback();
}

}  // namespace stria::coarse
