// The sections of the case file that say what is loaded: the body, its mesh, material, cracks and boundaries.
#pragma once

#include "common/case/case.hpp"
#include "common/schema/schema.hpp"

namespace stria {

schema::Section<ModelSection> model_section();
schema::Section<MeshSection> mesh_section();
schema::Section<MaterialSection> material_section();
schema::Section<CrackSection> crack_section();
schema::Section<BoundarySection> boundary_section();

}  // namespace stria
