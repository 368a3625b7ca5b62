#include "coarse/growth/period_rates.hpp"

#include <algorithm>
#include <cmath>

#include "common/index.hpp"

namespace stria::coarse {

void PeriodRates::add(const std::vector<double>& rates, const std::vector<double>& grown, bool begins) {
    if (begins || memory_.cycles == 0) {
        const std::vector<double> before = present();
        const bool grew = std::ranges::any_of(grown, [](double way) { return way > 0.0; });
        memory_ = {.sum = std::vector<double>(rates.size(), 0.0),
                   .grown = grown,
                   .before = before,
                   .at_growth = grew ? before : memory_.at_growth};
    }
    for (std::size_t t = 0; t < rates.size(); ++t) memory_.sum[t] += rates[t];
    ++memory_.cycles;
}

std::vector<double> PeriodRates::present() const {
    std::vector<double> means = memory_.sum;
    for (double& mean : means) mean /= memory_.cycles;
    return means;
}

std::vector<double> PeriodRates::ahead() const {
    std::vector<double> rates = present();
    constexpr double leap = 2.0;  // what changes by more does not go on so
    for (std::size_t t = 0; t < memory_.at_growth.size(); ++t)
        if (const double before = memory_.at_growth[t]; before > 0.0)
            rates[t] *= std::clamp(std::sqrt(rates[t] / before), 1.0 / leap, leap);
    return rates;
}

}  // namespace stria::coarse
