#include "coarse/analysis/run_texts.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <ranges>

namespace stria::coarse {
namespace {

constexpr double rounding_of_work = 1e-6;  // of the largest: Newton's tolerance leaves as much

std::string rings_flow(double load_factor, std::ptrdiff_t tip) {
    return fmt::format("load factor {:.6g}: no ring about tip {} lies outside what has flowed: K and T are no elastic "
                       "ones from here on",
                       load_factor, tip);
}

std::string faces_overlap(double load_factor, const coupling::FaceSample& deepest, bool metal_may_flow) {
    return fmt::format("warning: load factor {:.6g}: faces of crack {} overlap, by {:.3g} mm at ({:.6g}, {:.6g}){}: "
                       "they touch with contact = {{}} in its section",
                       load_factor, deepest.crack, -deepest.opening, deepest.x, deepest.y,
                       metal_may_flow ? ", and metal flows by it" : "");
}

std::string last_converged(const LastConverged& last) {
    if (last.increments == 0) return "no increment has converged before it";
    if (last.reached.control == Control::Load) return "the last converged one reached " + to_text(last.reached);
    return fmt::format("the last converged one reached {} at load factor {:.6g}", to_text(last.reached),
                       last.load_factor);
}

}  // namespace

std::string no_equilibrium(const LoadStep& step, const NewtonReport& report, int halvings, const LastConverged& last) {
    return fmt::format("increment {} (cycle {}) towards {}: {} after {} halvings; {}", last.increments + 1, step.cycle,
                       to_text(step.target), report.failure, halvings, last_converged(last));
}

std::string stress_does_not_settle(const NewtonReport& report) {
    return "the initial stress finds no equilibrium without load: " + report.failure +
           "; it may be more than the body bears";
}

std::string released_in_parts(const LoadStep& step, const NewtonReport& report) {
    return fmt::format("after growth at {}: {}; its faces are released in parts", to_text(step.target), report.failure);
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

std::vector<std::string> count_doubts(const Increment& increment, const Scene& scene, RunCounts& counts) {
    std::vector<std::string> first;
    const auto tip = std::ranges::find(increment.tips, true, &TipResult::rings_flow);
    if (tip != increment.tips.end() && counts.flowing_rings++ == 0)
        first.push_back(rings_flow(increment.load_factor, tip - increment.tips.begin()));
    const coupling::FaceSample* deepest = deepest_overlap(increment.zone.faces, scene.input.cracks);
    if (deepest != nullptr && counts.overlapping_faces++ == 0)
        first.push_back(faces_overlap(increment.load_factor, *deepest, scene.materials.may_yield()));
    return first;
}

// Little may be known of what is lost where the balance is open by little. A wheel rolls over a rough crack, and
// friction is 12 % too low: the balance is open by 0.3 % of the work, and by 19 % of what friction takes.
std::string work_out_of_balance(const WorkBalance& work) {
    constexpr double much_of_work = 0.01, much_of_lost = 0.15;
    const double of_work = work.share_of_largest(), of_lost = work.share_of_lost();
    // What an initial stress has stored beforehand is rounded too, and may be all there is beside small loads.
    constexpr double rounding_of_stored = 1e-12;
    if (std::abs(work.error()) <= rounding_of_stored * std::abs(work.at_start)) return "";
    if (!(of_work > much_of_work || (of_lost > much_of_lost && of_work > rounding_of_work))) return "";
    const std::string beside_lost =
        std::isfinite(of_lost)
            ? fmt::format(", {:.2g} % of what flow and friction dissipate and growth releases", 100.0 * of_lost)
            : "";
    return fmt::format("the work balance is open by {:.2g} % of the largest work of the loads{}: one of these is off "
                       "by so much; finer increments (load.steps, growth.increment) tell",
                       100.0 * of_work, beside_lost);
}

std::string misses_accuracy(double off, double accuracy) {
    return fmt::format(
        "warning: load.accuracy = {:g} may not be kept: with as many increments as are chosen at most, a half cycle "
        "is off by {:.2g} of the range of the opening, by its estimate, and half of the accuracy is its share; more of "
        "them (load.steps) tell",
        accuracy, off);
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
