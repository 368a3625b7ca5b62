// The sections of the case file that say what happens: the history of the load, growth, and what is measured on the
// way.
#pragma once

#include "common/case/case.hpp"
#include "common/schema/schema.hpp"

namespace stria {

schema::Section<LoadSection> load_section();
schema::Section<LoadCaseSection> load_case_section();
schema::Section<MaterialTestSection> material_test_section();
schema::Section<GrowthSection> growth_section();
schema::Section<ClosureSection> closure_section();

}  // namespace stria
