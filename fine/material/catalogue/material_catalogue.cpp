#include "fine/material/catalogue/material_catalogue.hpp"

#include <fmt/format.h>

#include "common/error.hpp"
#include "fine/material/elastic.hpp"
#include "fine/material/implicit/j2_implicit.hpp"
#include "fine/material/j2.hpp"
#include "fine/material/j2_plane_stress.hpp"

namespace stria::fine {

namespace {

void demand_not_negative(const char* key, double value) {
    if (!(value >= 0.0)) throw CaseError(fmt::format("material.kinematic.{} = {}: must be >= 0", key, value));
}

J2Parameters parameters_of(const MaterialSection& material, PlaneState plane, int substeps) {
    if (!(*material.yield_stress > 0.0))
        throw CaseError(fmt::format("material.yield_stress = {}: must be > 0", *material.yield_stress));
    for (const KinematicHardening& term : material.kinematic) {
        demand_not_negative("C", term.C);
        demand_not_negative("gamma", term.gamma);
        if (term.threshold && (term.gamma == 0.0 || term.C_start))
            throw CaseError("material.kinematic.threshold: needs gamma > 0 and no C_start: the limit is C / gamma");
    }
    return {.elasticity = elasticity_of(material, plane),
            .yield_stress = *material.yield_stress,
            .isotropic = material,
            .kinematic = material.kinematic,
            .substeps = substeps};
}

}  // namespace

// Linear hardening returns in closed form, in plane stress nearly so.
std::unique_ptr<MaterialLaw> make_material_law(const MaterialSection& material, PlaneState plane, int substeps) {
    if (!material.yield_stress) return std::make_unique<Elastic>(elasticity_of(material, plane));
    const J2Parameters parameters = parameters_of(material, plane, substeps);
    const bool closed = parameters.is_linear();
    if (closed && plane == PlaneState::Strain) return std::make_unique<J2>(parameters);
    if (closed && substeps == 1) return std::make_unique<J2PlaneStress>(parameters);
    return std::make_unique<J2Implicit>(parameters);
}

MaterialLaws make_material_laws(const Materials& materials, int substeps) {
    MaterialLaws laws;
    for (int m = 0; m < materials.count(); ++m)
        laws.push_back(make_material_law(materials.section(m), materials.elastic(m).plane, substeps));
    return laws;
}

}  // namespace stria::fine
