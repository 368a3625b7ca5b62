// What fatigue asks of a run: length and rate, opening loads and zones, from cycle to cycle.
#pragma once

#include <vector>

#include "app/charts/page.hpp"
#include "app/charts/sheet.hpp"
#include "app/report/record/run_record.hpp"

namespace stria::report {

std::vector<charts::Figure> cycle_figures(const RunRecord& run);

/// da/dN by the secant method of ASTM E647 between one row of cycles.csv and the next of that tip, with the means of
/// their lengths and ranges: a, mm; dadN, mm per cycle; dK (E647: of the part in tension) and dK_eff, MPa sqrt(mm).
charts::Sheet growth_rates(const RunRecord& run, std::size_t tip);

}  // namespace stria::report
