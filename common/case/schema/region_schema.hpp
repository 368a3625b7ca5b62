// The sections of the case file on parts of the body of another material, and on the stress before any load.
#pragma once

#include <filesystem>

#include "common/case/case.hpp"
#include "common/schema/schema.hpp"

namespace stria {

schema::Section<RegionSection> region_section();
schema::Section<InitialStressSection> initial_stress_section();

/// The nodes of initial_stress.file. Throws CaseError with its line.
StressGrid read_stress_grid(const std::filesystem::path& path);

}  // namespace stria
