#include "common/case/checks/material_checks.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <vector>

#include "common/schema/given.hpp"

namespace stria {

using schema::Given;
using schema::Place;
using schema::Value;

namespace {

/// The keys of one law of isotropic hardening mean nothing to another, unless they say nothing.
void check_keys_of_law(const IsotropicHardening& hardening, const Given& given) {
    struct KeyOfLaw {
        HardeningLaw law;
        const char *word, *key;
        bool says_something;
    };
    using enum HardeningLaw;
    for (const auto& [law, word, key, says_something] :
         {KeyOfLaw{Linear, "linear", "modulus", hardening.modulus != 0.0},
          {Voce, "voce", "Q", hardening.Q != 0.0},
          {Voce, "voce", "b", hardening.b != 0.0},
          {Power, "power", "n", hardening.n != 0.0},
          {Power, "power", "alpha", hardening.alpha != 0.0},
          {Power, "power", "reference", hardening.reference.has_value()},
          {Table, "table", "plastic_strain", !hardening.plastic_strain.empty()},
          {Table, "table", "stress", !hardening.stress.empty()}})
        given.demand(!says_something || hardening.law == law, key, fmt::format("belongs to law = \"{}\"", word));
}

/// A back stress that never recovers has no limit. Where its modulus falls the energy that it holds grows: recall must
/// give that, 2 gamma >= -C'(p) / C(p), most at p = 0.
void check_back_stresses(const MaterialSection& material, const Given& given) {
    for (std::size_t k = 0; k < material.kinematic.size(); ++k) {
        const KinematicHardening& term = material.kinematic[k];
        const Given of_term = given.entry("kinematic", k);
        of_term.demand(!term.threshold || term.gamma > 0.0, "threshold", "needs gamma > 0: the limit is C / gamma");
        of_term.demand(term.C_start || term.C_rate == 0.0, "C_rate", "belongs to a C_start: without one C stays");
        if (!term.C_start) continue;
        of_term.demand(!term.threshold && term.C > 0.0, "C_start", "needs C > 0 and no threshold");
        of_term.demand(2.0 * term.gamma >= term.C_rate * (1.0 - term.C / *term.C_start), "C_start",
                       "needs 2 gamma >= C_rate (1 - C / C_start), else the metal gives more work than it takes");
    }
}

/// Of the table of isotropic hardening as a whole.
void require_law(bool met, const Given& given, const char* what) {
    if (!met) given.refuse(what);
}

void check_voce(const MaterialSection& material, const Given& given) {
    constexpr double fastest_softening = 0.1;
    const double Q = material.isotropic.Q, b = material.isotropic.b;
    require_law(Q != 0.0 && b > 0.0, given, "needs a Q other than 0 and b > 0");
    require_law(!material.yield_stress || Q > -*material.yield_stress, given,
                "needs a Q above -yield_stress: nothing would be left of it");
    require_law(-Q * b < fastest_softening * material.young, given,
                "needs a Q b above -0.1 young: stress would fall faster than metals let it");
}

void check_power(const MaterialSection& material, const Given& given) {
    const IsotropicHardening& hardening = material.isotropic;
    require_law(hardening.n > 1.0 && hardening.alpha > 0.0, given, "needs n > 1 and alpha > 0");
    if (!material.yield_stress || !hardening.reference) return;
    const double strain = std::pow(*material.yield_stress / *hardening.reference, hardening.n);
    require_law(strain > 1e-200 && strain < 1e200, given,
                "needs a smaller n, or a reference nearer to the yield stress");
}

void check_table(const MaterialSection& material, const Given& given) {
    const std::vector<double>&p = material.isotropic.plastic_strain, &stress = material.isotropic.stress;
    require_law(p.size() == stress.size() && p.size() > 1, given,
                "needs plastic_strain and stress, as long, with two numbers at least");
    require_law(p.front() == 0.0 && std::ranges::adjacent_find(p, std::greater_equal()) == p.end(), given,
                "needs a plastic_strain that starts with 0 and ascends");
    require_law(stress.front() == material.yield_stress, given,
                "needs a stress that starts with material.yield_stress");
    require_law(std::ranges::is_sorted(stress), given, "needs a stress that does not fall: the metal would soften");
}

}  // namespace

void check_hardening(const MaterialSection& material, const Value& table, const Place& place) {
    constexpr double least_strain = 1e-9;  // at yield; below it plastic strains are all there is, and lose their digits
    const Given given{table, place};
    if (material.yield_stress && *material.yield_stress < least_strain * material.young)
        given.refuse_value("yield_stress", "must be at least 1e-9 of young", "MPa");
    check_back_stresses(material, given);
    if (!given.has("isotropic")) return;
    const Given isotropic = given.inside("isotropic");
    check_keys_of_law(material.isotropic, isotropic);
    const HardeningLaw law = material.isotropic.law;
    if (law == HardeningLaw::Voce) check_voce(material, isotropic);
    if (law == HardeningLaw::Power) check_power(material, isotropic);
    if (law == HardeningLaw::Table) check_table(material, isotropic);
}

void check_material_test(const MaterialTestSection& test, const Value& table, const Place& place) {
    const Given given{table, place};
    if (test.blocks.empty())
        given.refuse("needs blocks, for instance blocks = [ { cycles = 10, max = 0.01, ratio = -1 } ]");
    double increments = 0.0;
    for (const LoadBlock& block : test.blocks) increments += 1.0 * block.cycles * test.steps;
    if (increments > 1e7) given.refuse(fmt::format("has {:.0f} increments in all, more than 10 million", increments));
    const auto large = [](const LoadBlock& block) { return std::max(std::abs(block.max), std::abs(block.min)) >= 1.0; };
    if (test.control == TestControl::Strain && std::ranges::any_of(test.blocks, large))
        given.refuse("blocks", "must be strains below 1, not percent");
}

}  // namespace stria
