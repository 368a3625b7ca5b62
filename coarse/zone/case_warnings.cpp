#include "coarse/zone/case_warnings.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <utility>

#include "coarse/load/case_histories.hpp"
#include "coarse/load/growth_schedule.hpp"
#include "coarse/zone/material_adequacy.hpp"
#include "coarse/zone/mesh_adequacy.hpp"
#include "coarse/zone/zone_selection.hpp"

namespace stria::coarse {
namespace {

std::vector<std::string> thickness_warnings(const Case& input) {
    const double t = input.model.thickness;
    if (t == 1.0) return {};
    return {fmt::format("model.thickness = {:g}: loads and results are per mm of thickness all the same. A force of F "
                        "on the whole body is F / {:g} here",
                        t, t)};
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
    add(mesh_warnings(scene, K, distance));
    return all;
}

}  // namespace stria::coarse
