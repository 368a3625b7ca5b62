#include "app/charts/scale.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "common/error.hpp"

namespace stria::charts {

namespace {

constexpr double slack = 1e-9;     // relative: rounding of powers of ten
constexpr double beyond = 1e-3;    // of a step: what a value may lie beyond the last tick, too little to be seen
constexpr double rounding = 1e-6;  // of a value: ranges below it are widened, or rounding would look like a result
constexpr std::size_t most_ticks = 8;

double round_step(double step) {
    const double power = std::pow(10.0, std::floor(std::log10(step)));
    for (const double digit : {1.0, 2.0, 5.0})
        if (step <= digit * power * (1.0 + slack)) return digit * power;
    return 10.0 * power;
}

}  // namespace

std::vector<double> linear_ticks(Range range, int wanted) {
    const double size = std::max(std::abs(range.low), std::abs(range.high));
    if (range.high - range.low <= rounding * size) {
        const double room = size > 0.0 ? 0.1 * size : 1.0;
        range = {range.low - room, range.high + room};
    }
    const double step = round_step((range.high - range.low) / std::max(1, wanted));
    const double first = std::floor(range.low / step + beyond), last = std::ceil(range.high / step - beyond);
    std::vector<double> ticks;
    for (double k = first; k <= last; ++k) ticks.push_back(k * step + 0.0);  // no -0
    return ticks;
}

std::vector<double> log_ticks(Range range) {
    require(range.low > 0.0 && range.high >= range.low, "a logarithmic axis has positive values");
    const bool narrow = range.high < 100.0 * range.low;
    const double first = std::floor(std::log10(range.low) + slack), last = std::ceil(std::log10(range.high) - slack);
    std::vector<double> ticks;
    const double stride = std::max(1.0, std::ceil((last - first) / static_cast<double>(most_ticks)));
    for (double decade = first; decade < last + stride; decade += stride)
        for (const double digit : {1.0, 2.0, 5.0})
            if (digit == 1.0 || narrow) ticks.push_back(digit * std::pow(10.0, decade));
    // No more on either side than it takes to enclose the range.
    while (ticks.size() > 2 && ticks[1] <= range.low * (1.0 + slack)) ticks.erase(ticks.begin());
    while (ticks.size() > 2 && ticks[ticks.size() - 2] >= range.high * (1.0 - slack)) ticks.pop_back();
    if (ticks.size() < 2) ticks.push_back(10.0 * ticks.front());
    return ticks;
}

std::vector<std::string> tick_labels(const std::vector<double>& ticks) {
    std::vector<std::string> labels;
    for (int digits = 6; digits < 16; ++digits) {
        labels.clear();
        for (const double tick : ticks) labels.push_back(fmt::format("{:.{}g}", tick, digits));
        if (std::ranges::adjacent_find(labels) == labels.end()) break;
    }
    return labels;
}

Scale::Scale(std::vector<double> ticks, bool logarithmic, Range pixels)
    : ticks_(std::move(ticks)), logarithmic_(logarithmic), pixels_(pixels) {}

double Scale::operator()(double value) const {
    const auto measure = [&](double v) { return logarithmic_ ? std::log10(v) : v; };
    const double low = measure(ticks_.front()), high = measure(ticks_.back());
    return std::lerp(pixels_.low, pixels_.high, (measure(value) - low) / (high - low));
}

}  // namespace stria::charts
