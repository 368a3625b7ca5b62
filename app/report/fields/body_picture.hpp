// Where in its body a crack has gone: outline with holes, zone, and the way of each crack.
#pragma once

#include "app/charts/page.hpp"
#include "app/report/record/run_record.hpp"

namespace stria::report {

/// Of the last written increment, as the body was made. Empty without fields in VTKHDF.
charts::Figure body_picture(const RunRecord& run);

}  // namespace stria::report
