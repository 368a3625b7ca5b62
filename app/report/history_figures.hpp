// What a run went through, from increment to increment: loops of load against opening, K and J, work, iterations, time.
#pragma once

#include <vector>

#include "app/charts/page.hpp"
#include "app/report/record/run_record.hpp"

namespace stria::report {

std::vector<charts::Figure> history_figures(const RunRecord& run);

}  // namespace stria::report
