// The sections of the case file that say what is loaded: the body, its mesh, material, cracks and boundaries.
#pragma once

#include <filesystem>

#include "common/case/case.hpp"
#include "common/schema/schema.hpp"

namespace stria {

schema::Section<ModelSection> model_section();
schema::Section<MeshSection> mesh_section();
schema::Section<MaterialSection> material_section();
schema::Section<RegionSection> region_section();
schema::Section<InitialStressSection> initial_stress_section();
schema::Section<CrackSection> crack_section();
schema::Section<BoundarySection> boundary_section();

/// Pins are those of specimens, groups those of a file. Throws CaseError with the line.
void check_names_of_mesh(const Case& whole, const schema::Value& root, const schema::Place& place);

/// The nodes of initial_stress.file. Throws CaseError with its line.
StressGrid read_stress_grid(const std::filesystem::path& path);

}  // namespace stria
