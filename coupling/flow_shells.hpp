// What of the flow about a tip is the tip's own: metal may flow elsewhere too, under a load at a point, at a hole, or
// by 1e-9 in the wake that it has left.
#pragma once

#include <vector>

#include "coupling/messages.hpp"

namespace stria::coupling {

/// Shells one of which begins within twice the end of another become one. Ascending, and apart from one another.
[[nodiscard]] std::vector<FlowShell> joined(std::vector<FlowShell> shells);

/// The shell about a tip, from joined ones: it begins within two elements of it, or there is none (zeros).
/// `element_size`: at the tip, mm.
[[nodiscard]] FlowShell shell_at_tip(const std::vector<FlowShell>& shells, double element_size);

}  // namespace stria::coupling
