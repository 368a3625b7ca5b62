// The plastic zone and the wake as the fields of a run show them.
#pragma once

#include "app/charts/page.hpp"
#include "app/report/record/run_record.hpp"

namespace stria::report {

/// Accumulated plastic strain about the cracks at the last written increments, the crack open. Empty without fields in
/// VTKHDF, and where nothing has flowed.
charts::Figure field_picture(const RunRecord& run);

}  // namespace stria::report
