#include "coarse/advice/mesh_adequacy.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <optional>

#include "coarse/advice/opening_adequacy.hpp"
#include "coarse/advice/ring_adequacy.hpp"
#include "coarse/enrichment/tip_reach.hpp"
#include "coarse/model/rings.hpp"
#include "coarse/specimen/regions.hpp"
#include "coarse/zone/tip_refinement.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {

constexpr auto kinds = static_cast<std::size_t>(MeshDoubtKind::Count);

std::optional<MeshDoubt> doubt_of_rings(const Scene& scene, std::size_t tip, double radius, bool first) {
    std::optional<MeshDoubt> doubt;
    if (first) doubt = doubt_of_bend(scene, tip);
    if (!doubt) doubt = doubt_of_room(scene, tip, radius);
    if (!doubt) doubt = doubt_of_metal(scene, tip);
    if (!doubt && first) doubt = doubt_of_sharp_bend(scene, tip);
    if (!doubt) doubt = doubt_of_neighbour(scene, tip);
    return doubt;
}

MeshDoubt doubt_of_large_elements(const Scene& scene, std::size_t tip, int missing) {
    return {MeshDoubtKind::LargeElements,
            fmt::format("tip {} has come to elements of {:.3g} mm, {} times as large as fine.refine asks for: what has "
                        "flowed before a tip is there is never split. Openings, opening loads and zones are those of "
                        "such elements; mesh.grading with a smaller fine.refine makes them small from the start",
                        tip, tip_element_edge(scene.enriched, scene.enriched.tips[tip]), 1 << missing),
            missing};
}

}  // namespace

bool MeshJudge::is_news(std::size_t tip, const MeshDoubt& doubt) {
    int& said = said_[tip * kinds + static_cast<std::size_t>(doubt.kind)];
    if (doubt.degree <= said) return false;
    said = doubt.degree;
    return true;
}

std::vector<std::string> MeshJudge::look_at(const Scene& scene, const MeshDemands& demands) {
    const bool first = said_.empty();
    const std::size_t tips = scene.enriched.tips.size();
    said_.resize(tips * kinds, 0);
    std::vector<std::string> all;
    const auto take = [&](std::size_t tip, const MeshDoubt& doubt) {
        const bool told = first && doubt.kind == MeshDoubtKind::Reach;  // by who reads the history (overload_warnings)
        if (is_news(tip, doubt) && !told) all.push_back(doubt.sentence);
    };
    for (std::size_t t = 0; t < tips; ++t)
        if (const auto doubt = doubt_of_rings(scene, t, demands.radius[t], first)) take(t, *doubt);
    if (const auto found = doubt_of_functions(scene)) take(found->tip, found->doubt);
    for (std::size_t t = 0; t < tips; ++t) {
        const int missing = first ? 0 : levels_missing(scene, scene.enriched.tips[t]);
        if (missing > 0) take(t, doubt_of_large_elements(scene, t, missing));
        if (t >= std::min(demands.K_I.size(), demands.distance.size())) continue;
        for (const MeshDoubt& doubt : doubts_of_openings(scene, t, demands.K_I[t], demands.distance[t], missing))
            take(t, doubt);
    }
    return all;
}

std::vector<std::string> mesh_warnings(const Scene& scene, const std::vector<double>& K_I,
                                       const std::vector<double>& distance) {
    std::vector<std::string> warnings = region_warnings(scene.mesh, scene.input.regions);
    MeshDemands demands{.K_I = K_I, .distance = distance};
    for (int tip = 0; tip < std::ssize(scene.enriched.tips); ++tip) demands.radius.push_back(largest_ring(scene, tip));
    for (std::string& warning : MeshJudge().look_at(scene, demands)) warnings.push_back(std::move(warning));
    return warnings;
}

}  // namespace stria::coarse
