// What a checkpoint holds of the load and of how far it has come (checkpoint_members.hpp).
#pragma once

#include <type_traits>

#include "coarse/load/load_controller.hpp"

namespace stria {

template <class M, class T>
concept Is = std::is_same_v<std::remove_const_t<M>, T>;

void members(auto& archive, Is<LoadBlock> auto& m) {
    auto& [cycles, max, min] = m;
    archive("cycles", cycles);
    archive("max", max);
    archive("min", min);
}

}  // namespace stria

namespace stria::coarse {

void members(auto& archive, Is<LoadFactors> auto& m) {
    auto& [main, cases] = m;
    archive("main", main);
    archive("cases", cases);
}

void members(auto& archive, Is<LoadPosition::Taken> auto& m) {
    auto& [cycle, from, to, cases_from, cases_to] = m;
    archive("cycle", cycle);
    archive("from", from);
    archive("to", to);
    archive("cases_from", cases_from);
    archive("cases_to", cases_to);
}

void members(auto& archive, Is<OpeningPath> auto& m) {
    auto& [way, opening] = m;
    archive("way", way);
    archive("opening", opening);
}

void members(auto& archive, Is<IncrementSchedule::Legs> auto& m) {
    auto& [increments, alike, unmeasured, taken, knows_pressing] = m;
    archive("increments", increments);
    archive("alike", alike);
    archive("unmeasured", unmeasured);
    archive("taken", taken);
    archive("knows_pressing", knows_pressing);
}

void members(auto& archive, Is<TwoAsOne> auto& m) {
    auto& [from, to, opening] = m;
    archive("from", from);
    archive("to", to);
    archive("opening", opening);
}

void members(auto& archive, Is<SensesOfK> auto& m) {
    auto& [with_load, against_load] = m;
    archive("with_load", with_load);
    archive("against_load", against_load);
}

void members(auto& archive, Is<IncrementSchedule::State> auto& m) {
    auto& [rising, falling, path, pairs, meetings, presses, senses, tells, missed] = m;
    archive("rising", rising);
    archive("falling", falling);
    archive("path", path);
    archive("pairs", pairs);
    archive("meetings", meetings);
    archive("presses", presses);
    archive("senses", senses);
    archive("tells", tells);
    archive("missed", missed);
}

void members(auto& archive, Is<LoadPosition> auto& m) {
    auto& [leg, increments, leg_start, reached, way, cases, fraction, consecutive_cuts, cuts, taken, misled, schedule] =
        m;
    archive("leg", leg);
    archive("increments", increments);
    archive("leg_start", leg_start);
    archive("reached", reached);
    archive("way", way);
    archive("cases", cases);
    archive("fraction", fraction);
    archive("consecutive_cuts", consecutive_cuts);
    archive("cuts", cuts);
    archive("taken", taken);
    archive("misled", misled);
    archive("schedule", schedule);
}

}  // namespace stria::coarse
