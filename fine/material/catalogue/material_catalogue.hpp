// Which laws there are: from what a case says of a material to its law.
#pragma once

#include <memory>

#include "common/case/case.hpp"
#include "common/material/materials.hpp"
#include "fine/material/material_law.hpp"

namespace stria::fine {

/// The law of a case, of plane strain or plane stress: J2 with isotropic and kinematic hardening, or elastic where no
/// yield stress is given. `substeps`: of a strain increment at points that flow. Throws CaseError for parameters that
/// make no law.
std::unique_ptr<MaterialLaw> make_material_law(const MaterialSection& material, PlaneState plane, int substeps = 1);

/// The same of each material of a body, in its order.
[[nodiscard]] MaterialLaws make_material_laws(const Materials& materials, int substeps = 1);

}  // namespace stria::fine
