#include "coarse/advice/case_warnings.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>

#include "coarse/advice/growth_adequacy.hpp"
#include "coarse/advice/material_adequacy.hpp"
#include "coarse/advice/mesh_adequacy.hpp"
#include "coarse/fracture/plastic_zone.hpp"
#include "coarse/load/case_histories.hpp"
#include "coarse/load/growth_schedule.hpp"
#include "common/case/case_questions.hpp"
#include "common/crack/notch.hpp"
#include "common/geometry/segment.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {

std::vector<std::string> thickness_warnings(const Case& input) {
    const double t = input.model.thickness;
    if (t == 1.0) return {};
    return {fmt::format("model.thickness = {:g}: loads and results are per mm of thickness all the same. A force of F "
                        "on the whole body is F / {:g} here",
                        t, t)};
}

/// How far off one increment and two between reversals are: docs/verification/increments.md.
std::vector<std::string> steps_warnings(const Case& input) {
    constexpr int enough = 8;
    if (!may_yield(input) || input.load.steps.is_auto() || input.load.steps.value() >= enough) return {};
    return {fmt::format("load.steps = {}: metal that flows is taken from one reversal to the next in {}; with one the "
                        "opening range was 2 to 5 % too large and K_op up to 0.02 of K_max too low, with two 1 % and "
                        "0.01: {} or more, or \"auto\"",
                        input.load.steps.value(),
                        input.load.steps.value() == 2 ? "one increment"
                                                      : fmt::format("{} increments", input.load.steps.value() / 2),
                        enough)};
}

/// How far behind a tip faces that may touch end, mm along them: at the notch, or beyond it at the other end of the
/// crack; at its middle where that end is a tip.
double faces_that_touch(const Scene& scene, const Tip& tip) {
    const CrackSection& crack = scene.input.cracks[at(tip.crack)];
    const auto of_crack = [&](const Tip& other) { return other.crack == tip.crack; };
    const double length = length_of(crack.points),
                 own = length / static_cast<double>(std::ranges::count_if(scene.enriched.tips, of_crack));
    if (crack.notch == 0.0) return own;
    const Notch notch = notch_of(crack, crack.grown_at_start);
    const auto behind = [&](double s) { return std::clamp(tip.upper > 0 ? length - s : s, 0.0, own); };
    const auto [begins, ends] = std::minmax({behind(notch.from), behind(notch.to)});
    return ends < own ? own : begins;
}

/// Beyond them nothing touches.
std::vector<std::string> closure_warnings(const Scene& scene, const std::vector<double>& distance) {
    std::vector<std::string> all;
    const std::vector<Tip>& tips = scene.enriched.tips;
    for (std::size_t t = 0; t < tips.size(); ++t) {
        const double own = faces_that_touch(scene, tips[t]);
        if (may_touch(scene.input.cracks[at(tips[t].crack)]) && distance[t] >= own)
            all.push_back(fmt::format(
                "tip {}: closure is looked at {:.3g} mm behind it, and its faces that may touch end after {:.3g} mm: "
                "nothing touches there, and it counts as open all the cycle{} (closure.distance)",
                t, distance[t], own,
                scene.input.growth ? fmt::format(" until it has grown by {:.3g} mm", distance[t] - own) : ""));
    }
    return all;
}

}  // namespace

std::vector<std::string> case_warnings(const Scene& scene, const UnitResponse& nominal) {
    const std::vector<double> K = common_K_I(scene.input, nominal),
                              distance = closure_distances(scene.input.closure, K_of_closure(scene.input, nominal),
                                                           scene.yield_stress_at_tips());
    std::vector<std::string> all = material_warnings(scene.input);
    const auto add = [&](std::vector<std::string> more) { std::ranges::move(more, std::back_inserter(all)); };
    add(thickness_warnings(scene.input));
    add(steps_warnings(scene.input));
    add(units_of_K_warnings(scene.input));
    add(rate_warnings(scene.input, K, largest_K_I(scene.input, nominal)));
    add(early_break_warnings(scene.input, largest_K_I(scene.input, nominal)));
    add(travel_warnings(scene.input));
    add(growth_warnings(scene.input));
    add(closure_warnings(scene, distance));
    add(mesh_warnings(scene, K, distance));
    return all;
}

}  // namespace stria::coarse
