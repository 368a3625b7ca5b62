// What of the flow about a tip is the tip's own: metal may flow elsewhere too, under a load at a point, at a hole, or
// by 1e-7 in the wake that it has left.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "common/geometry/vec2.hpp"
#include "coupling/messages.hpp"

namespace stria::coupling {

/// Of one element. `tip`: its place; `reach`, `axis`: of the element's points, mm.
[[nodiscard]] FlowShell shell_of(const std::array<int, 4>& element, std::span<const Vec2> nodes, const Vec2& tip,
                                 double reach, double axis = 0.0);

/// Shells that overlap become one: flow, as seen from the tip, with less than an element between. Ascending, and apart
/// from one another.
[[nodiscard]] std::vector<FlowShell> joined(std::vector<FlowShell> shells);

/// The shell about a tip, from joined ones: it begins within two elements of it, or there is none (its reach is zero).
/// `element_size`: at the tip, mm.
[[nodiscard]] FlowShell shell_at_tip(const std::vector<FlowShell>& shells, double element_size);

}  // namespace stria::coupling
