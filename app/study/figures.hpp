// Which charts a study shows: what depends on what, one curve for each combination of the axes that are not along it.
#pragma once

#include <vector>

#include "app/charts/page.hpp"
#include "app/study/variants/table.hpp"

namespace stria::study {

/// The ends of the runs, errors against time, results along each axis, openings, time by phase, sizes and traffic.
std::vector<charts::Figure> figures(const Report& report);

}  // namespace stria::study
