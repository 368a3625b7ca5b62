#include "coarse/analysis/closure_measurement.hpp"

namespace stria::coarse {
namespace {

constexpr double precision = 0.002;  // of the larger load of a half cycle

}  // namespace

bool ClosureMeasurement::has_changed(const LoadStep& step, const NewtonReport& report) const {
    const std::vector<char> now = meter_.closed(report);
    return step.cycle > 0 && closed_.size() == now.size() && now != closed_;
}

std::vector<OpeningChange> ClosureMeasurement::changes(const LoadStep& step, const NewtonReport& report, double from,
                                                       double extreme, const Solve& solve) const {
    const double to = step.target.value;
    return meter_.locate(closed_, meter_.closed(report), from, to, precision * extreme, [&](double target) {
        LoadStep part = step;
        part.target.value = target;
        part.predictor.factor *= (target - from) / (to - from);
        return solve(part);
    });
}

}  // namespace stria::coarse
