#include "coarse/zone/material_adequacy.hpp"

#include <optional>
#include <utility>

#include <fmt/format.h>

namespace stria::coarse {
namespace {

// Strain at yield. Metals from soft lead to glassy ones have 1e-4 to 0.02.
constexpr double least_strain = 1e-5, largest_strain = 0.1;

std::optional<std::string> material_warning(const std::string& key, const MaterialSection& material) {
    if (!material.yield_stress) return std::nullopt;
    const double strain = *material.yield_stress / material.young;
    if (strain >= least_strain && strain <= largest_strain) return std::nullopt;
    return fmt::format(
        "{}: yield_stress / young = {:.2g} is a strain at which no metal yields (1e-4 to 0.02): are both "
        "in MPa?{}",
        key, strain, strain < least_strain ? " Increments of many times that strain take long" : "");
}

}  // namespace

std::vector<std::string> material_warnings(const Case& input) {
    std::vector<std::string> warnings;
    const auto look_at = [&](const std::string& key, const MaterialSection& material) {
        if (std::optional<std::string> warning = material_warning(key, material))
            warnings.push_back(std::move(*warning));
    };
    look_at("material", input.material);
    for (std::size_t k = 0; k < input.regions.size(); ++k)
        look_at(fmt::format("region[{}].material", k + 1), input.regions[k].material);
    return warnings;
}

}  // namespace stria::coarse
