#include "coarse/zone/tip_refinement.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "coarse/enrichment/tip_reach.hpp"
#include "coarse/fracture/plastic_zone.hpp"
#include "coarse/zone/zone_selection.hpp"
#include "common/crack/crack_end.hpp"
#include "common/fem/centre.hpp"
#include "common/index.hpp"
#include "coupling/flow_shells.hpp"

namespace stria::coarse {
namespace {

/// How often an element at a tip is split.
int levels_of(const FineSection& fine) { return std::countr_zero(static_cast<unsigned>(fine.refine)); }

/// How often it has been.
int level_at(const Scene& scene, const Tip& tip) {
    return scene.mesh->level.empty() ? 0 : scene.mesh->level[at(piece_of(scene.enriched.pieces, tip)->element)];
}

/// How far small elements lie ahead of a tip that grows, mm: as far as metal flows, because it is never split again.
double way_ahead(const Case& input, double flow, double radius, Room room) {
    constexpr double most = 0.15;  // of the radius: each element of the zone is paid for
    constexpr int steps = 10;
    if (!input.growth) return 0.0;
    return std::min(flow, radius) +
           (room == Room::ToGrow ? std::min(steps * input.growth->increment.value_or(radius), most * radius) : 0.0);
}

}  // namespace

int levels_missing(const Scene& scene, const Tip& tip) { return levels_of(scene.input.fine) - level_at(scene, tip); }

std::vector<RefinedDisk> disks_about_tips(const Scene& scene, const std::vector<CrackSection>& cracks,
                                          const std::vector<double>& K, Room room) {
    const EnrichedMesh& mesh = scene.enriched;
    const FineSection& fine = scene.input.fine;
    const int levels = levels_of(fine);
    const std::vector<double> yield_stress = scene.yield_stress_at_tips();
    std::vector<RefinedDisk> disks;
    for (std::size_t t = 0; t < mesh.tips.size(); ++t) {
        const Tip& tip = mesh.tips[t];
        const double smallest = std::ldexp(tip_element_size(mesh, tip), -levels_missing(scene, tip));
        const double radius = std::max(zone_radius(fine, yield_stress[t], K[t]), 3.0 * smallest);
        const double flow = elastic_zone_ahead(K[t], yield_stress[t], scene.input.model.plane);
        const Vec2 ahead = way_ahead(scene.input, flow, radius, room) * direction_of_end(cracks[at(tip.crack)], tip);
        disks.push_back({tip.position, end_of(cracks[at(tip.crack)], tip) + ahead, radius, levels, fine.growth});
    }
    return disks;
}

ElementSet elements_to_split_soon(const Scene& scene, const std::vector<double>& K, const ElementSet& whole) {
    constexpr int steps = 10;
    ElementSet soon(scene.mesh->elements.size());
    if (scene.input.fine.refine == 1 || !scene.input.growth) return soon;
    std::vector<RefinedDisk> disks = disks_about_tips(scene, scene.input.cracks, K, Room::ToGrow);
    for (std::size_t t = 0; t < disks.size(); ++t) {
        const Tip& tip = scene.enriched.tips[t];
        const double step = scene.input.growth->increment.value_or(tip_element_edge(scene.enriched, tip));
        disks[t].to += steps * step * tip.direction;
    }
    const std::vector<int> part_of = refine(scene.mesh, disks, whole).part_of;
    for (int e = 0; e < soon.size(); ++e)
        if (part_of[at(e)] >= 0) soon.insert(e);
    return soon;
}

std::vector<RefinedDisk> disks_about_flow(const Scene& scene, const std::vector<int>& flowing,
                                          const ElementSet& flowed) {
    constexpr double size_to_distance = 0.25;
    const std::vector<Tip>& tips = scene.enriched.tips;
    if (tips.empty()) return {};
    std::vector<std::vector<coupling::FlowShell>> flow(tips.size());
    const auto add = [&](int e, bool now) {
        const Vec2 place = centre(*scene.mesh, e);
        const auto distance = [&](const Tip& tip) { return (tip.position - place).norm(); };
        const auto own = std::ranges::min_element(tips, {}, distance);
        flow[at(own - tips.begin())].push_back(coupling::shell_of(scene.mesh->elements[at(e)], scene.mesh->nodes,
                                                                  own->position, now ? distance(*own) : 0.0));
    };
    for (const int e : flowing) add(e, true);
    for (const int e : flowed.members()) add(e, false);
    std::vector<RefinedDisk> disks;
    for (std::size_t t = 0; t < tips.size(); ++t) {
        const double size = tip_element_size(scene.enriched, tips[t]);
        const double radius = shell_at_tip(coupling::joined(std::move(flow[t])), size).reach;
        disks.push_back({tips[t].position, tips[t].position, radius, levels_of(scene.input.fine),
                         std::max(scene.input.fine.growth, size_to_distance)});
    }
    return disks;
}

ElementSet elements_with_more_than_jumps(const Scene& scene) {
    const EnrichedMesh& mesh = scene.enriched;
    ElementSet found(mesh.elements.size());
    const auto sees_tip = [&](int node) { return mesh.has_tip_functions(node); };
    for (const int e : scene.mesh.elements_about(mesh.terms.nodes()))
        if (std::ranges::any_of(mesh.elements[at(e)], sees_tip)) found.insert(e);
    for (const Tip& tip : mesh.tips) found.insert(piece_of(mesh.pieces, tip)->element);
    add_touching_faces(scene, found);
    return found;
}

}  // namespace stria::coarse
