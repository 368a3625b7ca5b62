// Legs of a load history whose increments are off by a known error, as a schedule measures them.
#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "coarse/load/increment_schedule.hpp"

namespace stria::coarse {

/// What an increment of a leg comes to whose openings are off by c w^2 for each increment over w.
struct OffByTheSquare {
    std::vector<double> ways;
    double c;

    [[nodiscard]] double off(std::size_t k) const { return c * std::pow(ways[k] - ways[k - 1], 2); }
    /// Straight but for what the increments so far are off by.
    [[nodiscard]] OpeningPath path() const {
        OpeningPath path;
        path.begin({1.0});
        double opening = 1.0;
        for (std::size_t k = 1; k < ways.size(); ++k) path.add(ways[k], {opening += ways[k] - ways[k - 1] + off(k)});
        return path;
    }
    /// By twos from its end.
    [[nodiscard]] std::vector<TwoAsOne> pairs() const {
        std::vector<TwoAsOne> pairs;
        const OpeningPath taken = path();
        for (std::size_t k = 2 - ways.size() % 2; k + 2 < ways.size() + 1; k += 2) {
            const double as_one = c * std::pow(ways[k + 1] - ways[k - 1], 2) - off(k) - off(k + 1);
            pairs.push_back({ways[k - 1], ways[k + 1], {taken.opening[k + 1][0] + as_one}});
        }
        return pairs;
    }
};

/// Increments of a leg that loads, after some of cycles that are off by c w^2 for each increment. `again`: the first of
/// a pair is made again, and the pair tried before.
inline int after(const LoadSection& load, double c, bool presses = false, bool again = false) {
    IncrementSchedule schedule(load);
    schedule.meet_at({}, presses);
    const OffByTheSquare leg{schedule.ways(true), c};
    const OpeningPath path = leg.path();
    const std::vector<double> falling = schedule.ways(false);
    for (int legs = 0; legs < 4; ++legs) {
        EXPECT_EQ(schedule.ways(true), leg.ways) << "until one is measured";
        schedule.begin(std::vector<double>(path.opening.front()));
        if (schedule.measures(true, true))
            for (const TwoAsOne& pair : leg.pairs()) {
                if (again) schedule.add({pair.from, pair.to, {0.0}});
                schedule.add(pair);
            }
        for (std::size_t k = 1; k < leg.ways.size(); ++k) schedule.add(leg.ways[k], path.opening[k]);
        schedule.end_leg(true, legs > 0);
    }
    EXPECT_EQ(schedule.ways(false), falling) << "legs of the other direction";
    return static_cast<int>(schedule.ways(true).size()) - 1;
}

}  // namespace stria::coarse
