#include "coarse/analysis/growth/period_rates.hpp"

#include "common/index.hpp"

namespace stria::coarse {

void PeriodRates::add(const std::vector<double>& rates, const std::vector<double>& grown, bool begins) {
    if (begins || memory_.cycles == 0)
        memory_ = {.sum = std::vector<double>(rates.size(), 0.0), .grown = grown, .before = present()};
    for (std::size_t t = 0; t < rates.size(); ++t) memory_.sum[t] += rates[t];
    ++memory_.cycles;
}

std::vector<double> PeriodRates::present() const {
    std::vector<double> means = memory_.sum;
    for (double& mean : means) mean /= memory_.cycles;
    return means;
}

}  // namespace stria::coarse
