#include <array>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "common/error.hpp"
#include "fine/material/elastic.hpp"
#include "fine/material/j2.hpp"
#include "fine/material/j2_plane_stress.hpp"

namespace stria::fine {

namespace {

void demand(bool met, std::string_view key, const auto& value, std::string_view allowed) {
    if (!met) throw CaseError(fmt::format("material.{} = {}: {}", key, value, allowed));
}

std::unique_ptr<MaterialLaw> make_linear(const MaterialSection& material, PlaneState plane, int substeps) {
    J2Parameters parameters{.elasticity = elasticity_of(material, plane),
                            .yield_stress = *material.yield_stress,
                            .isotropic = material.isotropic.modulus,
                            .kinematic = {},
                            .substeps = substeps};
    demand(parameters.yield_stress > 0.0, "yield_stress", parameters.yield_stress, "must be > 0");
    demand(parameters.isotropic >= 0.0, "isotropic.modulus", parameters.isotropic, "must be >= 0");
    for (const auto& [C, gamma] : material.kinematic) {
        demand(C >= 0.0, "kinematic.C", C, "must be >= 0");
        demand(gamma == 0.0, "kinematic.gamma", gamma, "this version has Prager's rule only, gamma = 0");
        parameters.kinematic.push_back(C);
    }
    if (plane == PlaneState::Stress && substeps > 1)
        throw CaseError(fmt::format("fine.substeps = {}: in plane stress this version has 1 only", substeps));
    if (plane == PlaneState::Stress) return std::make_unique<J2PlaneStress>(parameters);
    return std::make_unique<J2>(parameters);
}

struct Entry {
    std::string_view isotropic_law;
    std::unique_ptr<MaterialLaw> (*make)(const MaterialSection&, PlaneState, int);
};

constexpr std::array catalogue{Entry{"linear", make_linear}};

}  // namespace

std::unique_ptr<MaterialLaw> make_material_law(const MaterialSection& material, PlaneState plane, int substeps) {
    if (!material.yield_stress) return std::make_unique<Elastic>(elasticity_of(material, plane));
    for (const Entry& entry : catalogue)
        if (entry.isotropic_law == material.isotropic.law) return entry.make(material, plane, substeps);
    std::string known;
    for (const Entry& entry : catalogue) known += fmt::format(" \"{}\"", entry.isotropic_law);
    throw CaseError(fmt::format("material.isotropic.law = \"{}\": this version has{}", material.isotropic.law, known));
}

}  // namespace stria::fine
