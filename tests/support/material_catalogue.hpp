// The laws that tests of all laws go through: one of each kind, in plane strain and plane stress.
#pragma once

#include <algorithm>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "common/case/case.hpp"

namespace stria::test {

struct Law {
    std::string name;
    MaterialSection material;
    PlaneState plane = PlaneState::Strain;
};

inline void PrintTo(const Law& law, std::ostream* out) { *out << law.name; }

inline MaterialSection linear_steel(double isotropic, std::vector<KinematicHardening> kinematic) {
    return {.young = 200e3,
            .poisson = 0.3,
            .yield_stress = 350.0,
            .isotropic = {.law = HardeningLaw::Linear, .modulus = isotropic},
            .kinematic = std::move(kinematic)};
}

inline MaterialSection curved(IsotropicHardening isotropic, std::vector<KinematicHardening> kinematic = {}) {
    MaterialSection material = linear_steel(0.0, std::move(kinematic));
    material.isotropic = std::move(isotropic);
    return material;
}

inline const IsotropicHardening voce{.law = HardeningLaw::Voce, .Q = 80.0, .b = 20.0};
inline const std::vector<KinematicHardening> recalling{{60e3, 300.0}, {9e3, 30.0}, {2e3, 0.0}};
inline const std::vector<KinematicHardening> multilinear{{100e3, 2000.0, true}, {30e3, 500.0, true}, {8e3, 60.0, true}};

inline const std::vector<Law>& catalogue() {
    static const std::vector<Law> laws = [] {
        std::vector<Law> all{
            {"elastic", {.young = 200e3, .poisson = 0.3, .yield_stress = {}, .isotropic = {}, .kinematic = {}}},
            {"perfect", linear_steel(0.0, {})},
            {"isotropic", linear_steel(2000.0, {})},
            {"prager", linear_steel(0.0, {{5000.0, 0.0}})},
            {"mixed", linear_steel(1000.0, {{3000.0, 0.0}, {20000.0, 0.0}})},
            {"voce", curved(voce, {{3000.0, 0.0}})},
            {"softening", curved({.law = HardeningLaw::Voce, .Q = -80.0, .b = 20.0}, recalling)},
            {"power", curved({.law = HardeningLaw::Power, .n = 8.0, .alpha = 0.5, .reference = 400.0})},
            {"table", curved({.law = HardeningLaw::Table,
                              .plastic_strain = {0.0, 0.002, 0.01, 0.1},
                              .stress = {350.0, 380.0, 400.0, 450.0}})},
            {"recall", curved(voce, recalling)},
            {"threshold", linear_steel(0.0, {{50e3, 500.0, true}})},
            {"multilinear", curved(voce, multilinear)},
            {"growing_recall", curved(voce, {{30e3, 300.0, false, 12e3, 40.0}, {5e3, 20.0, false, 9e3, 10.0}})},
            {"both_recalls", linear_steel(500.0, {{60e3, 300.0}, {30e3, 500.0, true}, {4e3, 0.0}, {0.0, 10.0, true}})},
        };
        const auto count = all.size();
        for (std::size_t k = 0; k < count; ++k)
            all.push_back({all[k].name + "_plane_stress", all[k].material, PlaneState::Stress});
        return all;
    }();
    return laws;
}

inline bool recalls(const MaterialSection& material) {
    return std::ranges::any_of(material.kinematic, [](const KinematicHardening& term) { return term.gamma > 0.0; });
}

/// Backward Euler minimises what an increment stores and dissipates: Armstrong and Frederick's recall, which takes back
/// stress against the direction of flow, has no such potential, and its tangent is not symmetric.
inline bool has_potential(const MaterialSection& material) {
    return std::ranges::none_of(material.kinematic,
                                [](const KinematicHardening& term) { return term.gamma > 0.0 && !term.threshold; });
}

}  // namespace stria::test
