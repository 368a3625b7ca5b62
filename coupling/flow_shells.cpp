#include "coupling/flow_shells.hpp"

#include <algorithm>
#include <ranges>

#include "common/index.hpp"

namespace stria::coupling {
namespace {

/// An element or more lies between: on a mesh of equal elements exactly one often does, and rounding must not tell.
bool is_apart(const FlowShell& shell, const FlowShell& next) {
    constexpr double rounding = 1e-6;
    return next.begin > (1.0 - rounding) * shell.end;
}

void join(FlowShell& shell, const FlowShell& next) {
    shell.end = std::max(shell.end, next.end);
    shell.reach = std::max(shell.reach, next.reach);
    shell.axis = std::max(shell.axis, next.axis);
}

}  // namespace

FlowShell shell_of(const std::array<int, 4>& element, std::span<const Vec2> nodes, const Vec2& tip, double reach,
                   double axis) {
    const auto distance = [&](int node) { return (nodes[at(node)] - tip).norm(); };
    const auto [begin, end] = std::ranges::minmax(element | std::views::transform(distance));
    return {begin, end + (end - begin), reach, axis};  // an element may lie between
}

std::vector<FlowShell> joined(std::vector<FlowShell> shells) {
    std::ranges::sort(shells, {}, &FlowShell::begin);
    std::vector<FlowShell> all;
    for (const FlowShell& next : shells) {
        if (all.empty() || is_apart(all.back(), next))
            all.push_back(next);
        else
            join(all.back(), next);
    }
    return all;
}

FlowShell shell_at_tip(const std::vector<FlowShell>& shells, double element_size) {
    FlowShell own{.end = 2.0 * element_size};
    for (const FlowShell& next : shells) {
        if (is_apart(own, next)) break;
        join(own, next);
    }
    return own;
}

}  // namespace stria::coupling
