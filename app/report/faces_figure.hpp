// The crack faces of a run under a slider over the increments at which they were written.
#pragma once

#include "app/charts/page.hpp"
#include "app/report/record/run_record.hpp"

namespace stria::report {

/// Opening, contact pressure, and with friction shear and slip along each crack. Empty where no faces were written.
charts::Figure faces_figure(const RunRecord& run);

}  // namespace stria::report
