#include "coarse/analysis/run_texts.hpp"

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

std::string load_left_empty(const LoadStep& step, const Target& reached, int tip, const char* does) {
    return fmt::format("cycle {}: no equilibrium between {} and {} tells where tip {} {}: its load is left empty",
                       step.cycle, to_text(reached), to_text(step.target), tip, does);
}

std::string rings_flow(double load_factor, std::ptrdiff_t tip) {
    return fmt::format("load factor {:.6g}: no ring about tip {} lies outside what has flowed: K and T are no elastic "
                       "ones from here on",
                       load_factor, tip);
}

std::string elements_stay_elastic(const LoadStep& step, std::size_t elements) {
    return fmt::format("warning: {}: {} elements outside the zone are beyond yield; they stay elastic "
                       "(fine.guard = \"warn\")",
                       to_text(step.target), elements);
}

std::string elements_join_zone(const LoadStep& step, std::size_t elements) {
    return fmt::format("{}: {} elements outside the zone would yield; they join it and the increment is redone",
                       to_text(step.target), elements);
}

}  // namespace stria::coarse
