#include "coarse/advice/growth_adequacy.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

namespace stria::coarse {
namespace {

// Over Young's modulus, sqrt(mm). A crack that grows by an atom's distance b at a time has dK_eff = E sqrt(b), 5e-4 E
// (Hertzberg, Int. J. Fracture 64 (1993) R53), and thresholds are about that; brittle metals break at 3e-3 E. Those
// typed in MPa sqrt(m) are 1/32 of what they are.
constexpr double least_threshold = 1e-4, least_toughness = 1e-3;

const double root_metre = std::sqrt(1000.0);  // in sqrt(mm)

double least_young(const Case& input) {
    double least = input.material.young;
    for (const RegionSection& region : input.regions) least = std::min(least, region.material.young);
    return least;
}

std::optional<std::string> units_warning(const std::string& key, const std::optional<double>& K, double least) {
    if (!K || *K >= least) return std::nullopt;
    return fmt::format("{} = {:g} MPa sqrt(mm) is {:.2g} MPa sqrt(m), less than that of any metal; if {:g} is meant in "
                       "MPa sqrt(m), {} = {:.4g}",
                       key, *K, *K / root_metre, *K, key, *K * root_metre);
}

}  // namespace

std::vector<std::string> units_of_K_warnings(const Case& input) {
    if (!input.growth) return {};
    const double young = least_young(input);
    std::vector<std::string> all;
    for (const std::optional<std::string>& warning :
         {units_warning("growth.threshold", input.growth->threshold, least_threshold * young),
          units_warning("growth.toughness", input.growth->toughness, least_toughness * young)})
        if (warning) all.push_back(*warning);
    return all;
}

std::vector<std::string> early_break_warnings(const Case& input, const std::vector<double>& K,
                                              const std::vector<double>& turned) {
    if (!input.growth || !input.growth->toughness || K.empty()) return {};
    std::vector<double> largest = K;
    for (std::size_t t = 0; t < K.size(); ++t) largest[t] = std::max(K[t], turned[t]);
    const auto most = std::ranges::max_element(largest);
    if (*most < *input.growth->toughness) return {};
    const auto tip = most - largest.begin();
    return {fmt::format("growth.toughness = {:g}: {} of tip {} reaches {:.4g} MPa sqrt(mm) before it has grown, and "
                        "there the run ends",
                        *input.growth->toughness,
                        *most > K[static_cast<std::size_t>(tip)] ? "K behind the turn that K_II makes" : "K_max", tip,
                        *most)};
}

}  // namespace stria::coarse
