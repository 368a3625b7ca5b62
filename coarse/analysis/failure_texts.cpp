#include "coarse/analysis/failure_texts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <ranges>

namespace stria::coarse {

std::string last_converged(int increments, const Target& reached, double load_factor, const Target& towards) {
    if (increments == 0) return "no increment has converged before it";
    if (towards.control == Control::Load) return "the last converged one reached " + to_text(reached);
    return fmt::format("the last converged one reached {} at load factor {:.6g}", to_text(reached), load_factor);
}

std::string faces_not_released(const LoadStep& step, const NewtonReport& report, const FaceRelease& release,
                               const std::vector<TipResult>& nominal) {
    return fmt::format("cycle {}: the cracks have grown to a = {:.6g} mm; at {} no equilibrium is found with less "
                       "than {:.3g} % of the forces that held their new faces: {} after {} halvings",
                       step.cycle, fmt::join(nominal | std::views::transform(&TipResult::a), ", "),
                       to_text(step.target), 100.0 * release.held, report.failure, release.cuts);
}

std::string opening_load_lost(const LoadStep& step, double reached, int tip, const std::string& does) {
    return fmt::format("cycle {}: no equilibrium between {} and {} tells where tip {} {}: its load is left empty",
                       step.cycle, to_text({step.target.control, reached}), to_text(step.target), tip, does);
}

}  // namespace stria::coarse
