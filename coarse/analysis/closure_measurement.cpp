#include "coarse/analysis/closure_measurement.hpp"

namespace stria::coarse {
namespace {

constexpr double precision = 0.002;  // of the larger load of a half cycle

}  // namespace

bool ClosureMeasurement::has_changed(const LoadStep& step, const NewtonReport& report, double from) const {
    const std::vector<char> now = reached(step, report, from);
    return step.cycle > 0 && closed_.size() == now.size() && now != closed_;
}

std::vector<OpeningChange> ClosureMeasurement::changes(const LoadStep& step, const NewtonReport& report, double from,
                                                       double extreme, const Solve& solve) const {
    const double to = step.target.value;
    return meter_.locate(closed_, reached(step, report, from), from, to, precision * extreme, [&](double target) {
        LoadStep part = step;
        part.target.value = target;
        part.predictor.factor *= (target - from) / (to - from);
        return solve(part);
    });
}

std::vector<char> ClosureMeasurement::commit(const LoadStep& step, const NewtonReport& report, double from) {
    std::vector<char> now = closed_ = reached(step, report, from);
    if (step.reversal) meter_.forget_slip(closed_);
    return now;
}

std::vector<char> ClosureMeasurement::reached(const LoadStep& step, const NewtonReport& report, double from) const {
    return meter_.closed(report, closed_, step.target.value > from);
}

}  // namespace stria::coarse
