// What a checkpoint holds of the growth of the cracks (checkpoint_members.hpp).
#pragma once

#include "coarse/analysis/analysis_state.hpp"
#include "coarse/results/load_members.hpp"

namespace stria::coarse {

void members(auto& archive, Is<PeriodMemory> auto& m) {
    auto& [sum, cycles, grown, before, at_growth] = m;
    archive("sum", sum);
    archive("cycles", cycles);
    archive("grown", grown);
    archive("before", before);
    archive("at_growth", at_growth);
}

void members(auto& archive, Is<RateAtLength> auto& m) {
    auto& [length, rate] = m;
    archive("length", length);
    archive("rate", rate);
}

void members(auto& archive, Is<CountedGrowth> auto& m) {
    auto& [grown, from, to, doubt] = m;
    archive("grown", grown);
    archive("from", from);
    archive("to", to);
    archive("doubt", doubt);
}

void members(auto& archive, Is<LifeMemory> auto& m) {
    auto& [uncounted, rate_at_turn, doubt, last] = m;
    archive("uncounted", uncounted);
    archive("rate_at_turn", rate_at_turn);
    archive("doubt", doubt);
    archive("last", last);
}

void members(auto& archive, Is<TipRatesMemory> auto& m) {
    auto& [period, life, at_turn, owed, last] = m;
    archive("period", period);
    archive("life", life);
    archive("at_turn", at_turn);
    archive("owed", owed);
    archive("last", last);
}

void members(auto& archive, Is<GrowthPoint> auto& m) {
    auto& [a, per_mm, closure] = m;
    archive("a", a);
    archive("per_mm", per_mm);
    archive("closure", closure);
}

void members(auto& archive, Is<ForwardZone> auto& m) {
    auto& [ahead, anywhere] = m;
    archive("ahead", ahead);
    archive("anywhere", anywhere);
}

void members(auto& archive, Is<GrowthIncrementMemory> auto& m) {
    auto& [increment, points, zones] = m;
    archive("increment", increment);
    archive("points", points);
    archive("zones", zones);
}

void members(auto& archive, Is<FaceTractions> auto& m) {
    auto& [crack, s, pressure, shear, in_wake] = m;
    archive("crack", crack);
    archive("s", s);
    archive("pressure", pressure);
    archive("shear", shear);
    archive("in_wake", in_wake);
}

void members(auto& archive, Is<ReachedExtremes> auto& m) {
    auto& [maximum, minimum, tips, faces] = m;
    archive("maximum", maximum);
    archive("minimum", minimum);
    archive("tips", tips);
    archive("faces", faces);
}

void members(auto& archive, Is<LengthAndK> auto& m) {
    auto& [a, K] = m;
    archive("a", a);
    archive("K", K);
}

void members(auto& archive, Is<ReachedK> auto& m) {
    auto& [of_break, K_I] = m;
    archive("of_break", of_break);
    archive("K_I", K_I);
}

void members(auto& archive, Is<ModesOfTip> auto& m) {
    auto& [K_I, K_II] = m;
    archive("K_I", K_I);
    archive("K_II", K_II);
}

void members(auto& archive, Is<TurningModes> auto& m) {
    auto& [minimum, cycles] = m;
    archive("minimum", minimum);
    archive("cycles", cycles);
}

void members(auto& archive, Is<GrowthMemory> auto& m) {
    auto& [ended, increment, rates, K_reached, before, extremes, turning, turns_late] = m;
    archive("ended", ended);
    archive("increment", increment);
    archive("rates", rates);
    archive("K_reached", K_reached);
    archive("before", before);
    archive("extremes", extremes);
    archive("turning", turning);
    archive("turns_late", turns_late);
}

void members(auto& archive, Is<DueGrowth> auto& m) {
    auto& [due, cycle, moment] = m;
    archive("due", due);
    archive("cycle", cycle);
    archive("moment", moment);
}

void members(auto& archive, Is<FaceRelease> auto& m) {
    auto& [cycle, moment, held, part, cuts] = m;
    archive("cycle", cycle);
    archive("moment", moment);
    archive("held", held);
    archive("part", part);
    archive("cuts", cuts);
}

}  // namespace stria::coarse
