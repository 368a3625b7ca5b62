// The page of a run.
#pragma once

#include <string>

#include "app/report/record/run_record.hpp"

namespace stria::report {

/// Warnings first, then the faces, the charts and the resolved case. Needs nothing but itself.
std::string page_of(const RunRecord& run);

/// What a reader has to know before believing a number, one sentence each.
std::vector<std::string> warnings_of(const RunRecord& run);

}  // namespace stria::report
