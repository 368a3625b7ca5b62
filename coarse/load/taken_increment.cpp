#include "coarse/load/taken_increment.hpp"

#include <algorithm>
#include <cmath>

namespace stria::coarse {
namespace {

/// What an increment has of another one: of loads that change in different proportion, along it.
double in_proportion(const TakenIncrement& next, const TakenIncrement& taken) {
    const double way = taken.to - taken.from;
    const Eigen::VectorXd cases = taken.cases_to - taken.cases_from;
    const double length = way * way + cases.squaredNorm();
    if (length == 0.0) return 0.0;
    return (way * (next.to - next.from) + cases.dot(next.cases_to - next.cases_from)) / length;
}

}  // namespace

// Where increments are chosen anew, or K is controlled and a crack grows, a cycle has nearly the increments of the one
// before.
Predictor predictor_from(const std::vector<TakenIncrement>& before, const TakenIncrement& next) {
    constexpr double nearly = 0.1;  // of the increment
    const double increment = next.to - next.from;
    const Eigen::VectorXd more = next.cases_to - next.cases_from;
    const double size = std::abs(increment) + more.norm();
    const auto off = [&](const TakenIncrement& taken) {
        return std::max(std::abs(taken.from - next.from) + (taken.cases_from - next.cases_from).norm(),
                        std::abs(taken.to - next.to) + (taken.cases_to - next.cases_to).norm());
    };
    // The ramp is no cycle: virgin material flows where it will later unload and reload without.
    const auto is_twin = [&](const TakenIncrement& taken) {
        return taken.cycle > 0 && taken.cycle < next.cycle && off(taken) <= nearly * size;
    };
    const auto twin = std::ranges::find_if(before, is_twin);
    if (twin != before.end()) return {in_proportion(next, *twin), static_cast<int>(twin - before.begin()) + 1};
    return before.empty() ? Predictor() : Predictor(std::max(in_proportion(next, before.front()), 0.0));
}

}  // namespace stria::coarse
