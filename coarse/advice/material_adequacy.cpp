#include "coarse/advice/material_adequacy.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "coarse/load/rate_law.hpp"
#include "common/case/case_questions.hpp"

namespace stria::coarse {
namespace {

// Strain at yield. Metals from soft lead to glassy ones have 1e-4 to 0.02.
constexpr double least_strain = 1e-5, largest_strain = 0.1;

// mm per cycle. Cracks do not grow by less than an atom's distance, 3e-7 mm, in some hundred cycles; those that grow by
// more than 0.1 mm in one are about to tear.
constexpr double slowest_rate = 1e-9, fastest_rate = 0.1;

std::optional<std::string> material_warning(const std::string& key, const MaterialSection& material) {
    if (!material.yield_stress) return std::nullopt;
    const double strain = *material.yield_stress / material.young;
    if (strain >= least_strain && strain <= largest_strain) return std::nullopt;
    return fmt::format(
        "{}: yield_stress / young = {:.2g} is a strain at which no metal yields (1e-4 to 0.02): are both "
        "in MPa?{}",
        key, strain, strain < least_strain ? " Increments of many times that strain take long" : "");
}

/// dX/dp of a back stress that is pulled on and on, MPa.
double hardening_of(const KinematicHardening& term, double p) {
    if (term.threshold) return term.gamma * p < 1.0 ? term.C : 0.0;
    return term.C * std::exp(-term.gamma * p);
}

/// Where the slope of stress over plastic strain is negative flow gathers in bands as wide as an element.
std::optional<std::string> softening_warning(const std::string& key, const MaterialSection& material) {
    const IsotropicHardening& isotropic = material.isotropic;
    if (!material.yield_stress || isotropic.law != HardeningLaw::Voce || isotropic.Q >= 0.0) return std::nullopt;
    double least = 0.0, strain = 0.0;
    constexpr double first = 1e-5, last = 1.0, step = 1.02;  // plastic strains
    constexpr double seen_in_a_run = 1e-4;
    for (double p = first; p < last; p *= step) {
        double slope = isotropic.Q * isotropic.b * std::exp(-isotropic.b * p);
        for (const KinematicHardening& term : material.kinematic) slope += hardening_of(term, p);
        if (slope >= least) continue;
        least = slope;
        strain = p;
    }
    if (-least < seen_in_a_run * material.young) return std::nullopt;
    return fmt::format(
        "{}: at a plastic strain of {:.2g} it softens by more than it hardens, by {:.3g} MPa: flow gathers "
        "in bands as wide as an element, and what comes of it follows the mesh; a kinematic term "
        "without gamma and with C = {:.2g} keeps it from that",
        key, strain, -least, -least);
}

/// A crack grows by it, mm per cycle.
bool is_known(double rate) { return rate >= slowest_rate && rate <= fastest_rate; }

/// Of a law by which no crack grows: what C would be if it came in units with which one would.
std::string other_units(const GrowthSection& growth, double rate) {
    const double per_root_metre = std::pow(1000.0, -0.5 * growth.m);
    std::string units;
    const auto add = [&](const char* unit, double factor) {
        if (is_known(factor * rate))
            units += fmt::format("{}{} and MPa sqrt(m), growth.C = {:.3g}",
                                 units.empty() ? ". If C is of " : "; if of ", unit, factor * growth.C);
    };
    add("mm/cycle", per_root_metre);
    add("m/cycle", 1000.0 * per_root_metre);
    return units;
}

/// Of a largest K: what of it drives at most, where the load is all that the body feels and never falls to zero.
double part_that_drives(const Case& input) {
    const bool alone = input.load_cases.empty() && !has_initial_stress(input);
    if (!alone || input.load.control == Control::Displacement || input.load.blocks.empty()) return 1.0;
    const double power = input.growth->driving == GrowthDriving::Range ? input.growth->walker : 1.0;
    double most = 0.0;
    for (const LoadBlock& block : input.load.blocks)
        most = std::max(most, block.max > 0.0 ? std::pow(1.0 - std::max(block.min, 0.0) / block.max, power) : 1.0);
    return most;
}

}  // namespace

std::vector<std::string> material_warnings(const Case& input) {
    std::vector<std::string> warnings;
    const auto look_at = [&](const std::string& key, const MaterialSection& material) {
        for (const std::optional<std::string>& warning :
             {material_warning(key, material), softening_warning(key, material)})
            if (warning) warnings.push_back(*warning);
    };
    look_at("material", input.material);
    for (std::size_t k = 0; k < input.regions.size(); ++k)
        look_at(fmt::format("region.{}.material", k), input.regions[k].material);
    return warnings;
}

std::vector<std::string> rate_warnings(const Case& input, const std::vector<double>& K,
                                       const std::vector<double>& largest_K) {
    if (!input.growth || !is_law_of_dK(*input.growth) || K.empty()) return {};
    const GrowthSection& growth = *input.growth;
    const double part = part_that_drives(input);
    const double usual = part * std::ranges::max(K), largest = part * std::ranges::max(largest_K);
    if (usual <= 0.0) return {};
    const bool table = growth.law == GrowthLaw::Table;
    if (largest < threshold_of(growth)) {
        if (growth.driving == GrowthDriving::FullRange) return {};  // larger than K
        return {fmt::format("{}: no growth by a dK below {:.4g} MPa sqrt(mm), and that of no tip is larger than {:.4g}",
                            table ? "growth.ranges" : "growth.threshold", threshold_of(growth), largest)};
    }
    if (table && largest > growth.ranges.back())
        return {fmt::format("growth.ranges ends at dK = {:.4g} MPa sqrt(mm), and that of a tip may be {:.4g}: the last "
                            "line goes on",
                            growth.ranges.back(), largest)};
    if (usual < threshold_of(growth)) return {};  // a rarer cycle drives a tip
    const double rate = rate_of_range(growth, usual);
    if (is_known(rate)) return {};
    const std::string grows =
        fmt::format("{}: at dK = {:.4g} MPa sqrt(mm) the law gives da/dN = {:.2g} mm, and no crack "
                    "grows so{} (1e-9 to 0.1)",
                    table ? "growth.rates" : "growth.C", usual, rate, rate > fastest_rate ? " fast" : " slowly");
    if (table) return {grows};
    return {grows + other_units(growth, rate)};
}

}  // namespace stria::coarse
