#include "coupling/flow_shells.hpp"

#include <algorithm>

namespace stria::coupling {
namespace {

constexpr double apart = 2.0;  // where the next one begins, over where the last one ends

void join(FlowShell& shell, const FlowShell& next) {
    shell.end = std::max(shell.end, next.end);
    shell.reach = std::max(shell.reach, next.reach);
    shell.axis = std::max(shell.axis, next.axis);
}

}  // namespace

std::vector<FlowShell> joined(std::vector<FlowShell> shells) {
    std::ranges::sort(shells, {}, &FlowShell::begin);
    std::vector<FlowShell> all;
    for (const FlowShell& next : shells) {
        if (all.empty() || next.begin > apart * all.back().end)
            all.push_back(next);
        else
            join(all.back(), next);
    }
    return all;
}

FlowShell shell_at_tip(const std::vector<FlowShell>& shells, double element_size) {
    FlowShell own;
    for (const FlowShell& next : shells) {
        if (next.begin > apart * std::max(own.end, element_size)) break;
        join(own, next);
    }
    return own;
}

}  // namespace stria::coupling
