// Where the seconds of a run went, as a bar: the same for the page of a run and for that of a study.
#pragma once

#include <functional>
#include <string>

#include "app/charts/bar_chart.hpp"

namespace stria::report {

/// Seconds of a phase of summary.json ("setup", "exchange", ...); NaN where it is missing.
using Seconds = std::function<double(const std::string& phase)>;

/// Without bars yet: its parts are the phases that do not overlap. Points, contact and fronts are the zone's work
/// within what the structure waits for, and wire is the rest of that.
charts::BarChart time_chart(const std::string& title);

charts::Bar time_bar(const std::string& name, const Seconds& seconds);

}  // namespace stria::report
