#include "common/case/material_checks.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <vector>

namespace stria {

using schema::find;
using schema::Key;
using schema::Place;
using schema::reject;
using schema::Value;

namespace {

/// The keys of one law of isotropic hardening mean nothing to another, unless they say nothing.
void check_keys_of_law(const IsotropicHardening& given, const Value& table, const Place& place) {
    struct KeyOfLaw {
        const char *law, *key;
        bool says_something;
    };
    for (const auto& [law, key, says_something] : {KeyOfLaw{"linear", "modulus", given.modulus != 0.0},
                                                   {"voce", "Q", given.Q != 0.0},
                                                   {"voce", "b", given.b != 0.0},
                                                   {"power", "n", given.n != 0.0},
                                                   {"power", "alpha", given.alpha != 0.0},
                                                   {"power", "reference", given.reference.has_value()},
                                                   {"table", "plastic_strain", !given.plastic_strain.empty()},
                                                   {"table", "stress", !given.stress.empty()}})
        if (says_something && given.law != law)
            reject(place.inside(key), *find(table, key), {}, fmt::format("belongs to law = \"{}\"", law));
}

/// A back stress that never recovers has no limit. Where its modulus falls the energy that it holds grows: recall must
/// give that, 2 gamma >= -C'(p) / C(p), most at p = 0.
void check_back_stresses(const MaterialSection& material, const Value& table, const Place& place) {
    for (std::size_t k = 0; k < material.kinematic.size(); ++k) {
        const KinematicHardening& given = material.kinematic[k];
        const Value& term = std::get<schema::List>(find(table, "kinematic")->data)[k];
        const auto demand = [&](bool met, const char* key, const char* what) {
            if (!met)
                reject(place.inside("kinematic").inside(std::to_string(k)).inside(key), *find(term, key), {}, what);
        };
        if (given.threshold) demand(given.gamma > 0.0, "threshold", "needs gamma > 0: the limit is C / gamma");
        if (!given.C_start) continue;
        demand(!given.threshold && given.C > 0.0, "C_start", "needs C > 0 and no threshold");
        demand(2.0 * given.gamma >= given.C_rate * (1.0 - given.C / *given.C_start), "C_start",
               "needs 2 gamma >= C_rate (1 - C / C_start), else the metal gives more work than it takes");
    }
}

}  // namespace

void check_hardening(const MaterialSection& material, const Value& table, const Place& place) {
    constexpr double least_strain = 1e-9;  // at yield; below it plastic strains are all there is, and lose their digits
    constexpr double fastest_softening = 0.1;
    if (material.yield_stress && *material.yield_stress < least_strain * material.young)
        reject(place.inside("yield_stress"), *find(table, "yield_stress"), Key{.unit = "MPa"},
               "must be at least 1e-9 of young");
    check_back_stresses(material, table, place);
    const Value* isotropic = find(table, "isotropic");
    if (isotropic == nullptr) return;
    const IsotropicHardening& given = material.isotropic;
    const Place here = place.inside("isotropic");
    check_keys_of_law(given, *isotropic, here);
    const auto demand = [&](bool met, const char* what) {
        if (!met) reject(here, isotropic->line, what);
    };
    if (given.law == "voce") {
        demand(given.Q != 0.0 && given.b > 0.0, "needs Q and b > 0");
        demand(!material.yield_stress || given.Q > -*material.yield_stress,
               "needs a Q above -yield_stress: nothing would be left of it");
        demand(-given.Q * given.b < fastest_softening * material.young,
               "needs a Q b above -0.1 young: stress would fall faster than metals let it");
    }
    if (given.law == "power") {
        demand(given.n > 1.0 && given.alpha > 0.0, "needs n > 1 and alpha > 0");
        if (material.yield_stress && given.reference) {
            const double strain = std::pow(*material.yield_stress / *given.reference, given.n);
            demand(strain > 1e-200 && strain < 1e200, "needs a smaller n, or a reference nearer to the yield stress");
        }
    }
    if (given.law != "table") return;
    const std::vector<double>&p = given.plastic_strain, &stress = given.stress;
    demand(p.size() == stress.size() && p.size() > 1,
           "needs plastic_strain and stress, as long, with two numbers at least");
    demand(p.front() == 0.0 && std::ranges::adjacent_find(p, std::greater_equal()) == p.end(),
           "needs a plastic_strain that starts with 0 and ascends");
    demand(stress.front() == material.yield_stress, "needs a stress that starts with material.yield_stress");
    demand(std::ranges::is_sorted(stress), "needs a stress that does not fall: the metal would soften");
}

void check_material_test(const MaterialTestSection& test, const Value& table, const Place& place) {
    if (test.blocks.empty())
        reject(place, table.line, "needs blocks, for instance blocks = [ { cycles = 10, max = 0.01, ratio = -1 } ]");
    double increments = 0.0;
    for (const LoadBlock& block : test.blocks) increments += 1.0 * block.cycles * test.steps;
    if (increments > 1e7)
        reject(place, table.line, fmt::format("has {:.0f} increments in all, more than 10 million", increments));
    const auto large = [](const LoadBlock& block) { return std::max(std::abs(block.max), std::abs(block.min)) >= 1.0; };
    if (test.control == TestControl::Strain && std::ranges::any_of(test.blocks, large))
        reject(place.inside("blocks"), find(table, "blocks")->line, "must be strains below 1, not percent");
}

}  // namespace stria
