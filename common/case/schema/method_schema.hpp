// The sections of the case file that say how it is computed and what is written.
#pragma once

#include "common/case/case.hpp"
#include "common/schema/schema.hpp"

namespace stria {

inline constexpr int most_refined = 4096;  // fine.refine

schema::Section<SolverSection> solver_section();
schema::Section<CouplingSection> coupling_section();
schema::Section<FineSection> fine_section();
schema::Section<OutputSection> output_section();

}  // namespace stria
