#include "coarse/advice/case_warnings.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>

#include "coarse/advice/material_adequacy.hpp"
#include "coarse/advice/mesh_adequacy.hpp"
#include "coarse/fracture/plastic_zone.hpp"
#include "coarse/load/case_histories.hpp"
#include "coarse/load/growth_schedule.hpp"
#include "common/case/case_questions.hpp"
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

/// Beyond the other end of a crack, or its middle where that is a tip, nothing touches.
std::vector<std::string> closure_warnings(const Scene& scene, const std::vector<double>& distance) {
    std::vector<std::string> all;
    const std::vector<Tip>& tips = scene.enriched.tips;
    for (std::size_t t = 0; t < tips.size(); ++t) {
        const CrackSection& crack = scene.input.cracks[at(tips[t].crack)];
        const auto of_crack = [&](const Tip& tip) { return tip.crack == tips[t].crack; };
        const double own = length_of(crack.points) / static_cast<double>(std::ranges::count_if(tips, of_crack));
        if (may_touch(crack) && distance[t] >= own)
            all.push_back(
                fmt::format("tip {}: closure is looked at {:.3g} mm behind it, and its faces end after {:.3g} "
                            "mm: nothing touches there (closure.distance)",
                            t, distance[t], own));
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
    add(rate_warnings(scene.input, K));
    add(travel_warnings(scene.input));
    add(growth_warnings(scene.input));
    add(closure_warnings(scene, distance));
    add(mesh_warnings(scene, K, distance));
    return all;
}

}  // namespace stria::coarse
