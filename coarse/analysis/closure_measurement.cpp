#include "coarse/analysis/closure_measurement.hpp"

#include <algorithm>

namespace stria::coarse {
namespace {

constexpr double precision = 0.002;  // of the larger load of a half cycle

}  // namespace

bool ClosureMeasurement::has_changed(const LoadStep& step, const NewtonReport& report) const {
    const std::vector<double> now = meter_.signal(report, signal_);
    const auto same_sign = [](double a, double b) { return (a > 0.0) == (b > 0.0); };
    return step.cycle > 0 && signal_.size() == now.size() && !std::ranges::equal(signal_, now, same_sign);
}

std::vector<OpeningChange> ClosureMeasurement::changes(const LoadStep& step, const NewtonReport& report,
                                                       const End& from, const End& to, double extreme,
                                                       const Solve& solve) const {
    const double start = from.target.value, end = to.target.value;
    return meter_.locate({start, from.load_factor, signal_}, {end, to.load_factor, meter_.signal(report, signal_)},
                         precision * extreme, [&](double target) {
                             const double share = (target - start) / (end - start);
                             LoadStep part = step;
                             part.target.value = target;
                             part.target.cases = from.target.cases + share * (to.target.cases - from.target.cases);
                             part.predictor = {share, 0};
                             return solve(part);
                         });
}

std::vector<double> ClosureMeasurement::commit(const LoadStep& step, const NewtonReport& report) {
    std::vector<double> now = signal_ = meter_.signal(report, signal_);
    if (step.reversal) meter_.forget_slip(signal_);
    return now;
}

}  // namespace stria::coarse
