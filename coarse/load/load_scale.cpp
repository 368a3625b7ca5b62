#include "coarse/load/load_scale.hpp"

#include <cmath>

#include "coarse/load/load_history.hpp"
#include "common/error.hpp"

namespace stria::coarse {
namespace {

/// Of the range of K, in da/dN.
double exponent_of_K(const GrowthSection& growth) {
    switch (growth.law) {
    case GrowthLaw::Paris:
        return growth.m;
    case GrowthLaw::Ctod:
        return 2.0 * growth.m;  // openings go with its square
    default:
        return 0.0;
    }
}

}  // namespace

double target_of_unit(const LoadSection& load, const std::vector<double>& K_I, double grown) {
    if (load.control != Control::StressIntensity) return 1.0;
    if (K_I.empty() || !(K_I.front() > 0.0))
        throw CaseError("load.control: \"K\" needs a crack tip with K_I > 0 under the unit load");
    return std::exp(load.K_gradient * grown) / K_I.front();
}

double largest_load_factor(const LoadSection& load, const UnitResponse& nominal, double grown) {
    double per_load_factor = 1.0 / target_of_unit(load, nominal.K_I, grown);
    if (load.control == Control::Displacement) {
        per_load_factor = nominal.displacement.mean;
        if (std::abs(per_load_factor) <= 1e-9 * nominal.displacement.largest)
            throw CaseError("load.control: the loads do not move the loaded boundary along their direction");
    }
    return largest_value(load) / per_load_factor;
}

std::vector<double> largest_K_I(const LoadSection& load, const UnitResponse& nominal, double grown,
                                const CaseHistories& cases) {
    const double largest = largest_load_factor(load, nominal, grown);
    std::vector<double> K_I;
    for (std::size_t t = 0; t < nominal.K_I.size(); ++t) {
        K_I.push_back(nominal.K_I[t] * largest + (nominal.K_initial.empty() ? 0.0 : nominal.K_initial[t]));
        if (cases.count() > 0)
            K_I.back() += cases.largest_sum(nominal.K_of_cases[t], target_of_unit(load, nominal.K_I, grown));
    }
    return K_I;
}

std::vector<double> common_K_I(const Case& input, const UnitResponse& nominal) {
    LoadSection load = input.load;
    if (input.growth) load.blocks = {{.max = median_maximum(load, exponent_of_K(*input.growth)) / load.scale}};
    return largest_K_I(load, nominal, 0.0, CaseHistories(input));
}

}  // namespace stria::coarse
