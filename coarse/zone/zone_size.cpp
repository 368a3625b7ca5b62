#include "coarse/zone/zone_size.hpp"

#include <algorithm>
#include <memory>

#include "coarse/fracture/nominal_solution.hpp"
#include "coarse/zone/tip_refinement.hpp"
#include "coarse/zone/zone_selection.hpp"
#include "common/error.hpp"
#include "common/fem/centre.hpp"
#include "common/geometry/segment.hpp"
#include "common/integration/zone_rule.hpp"

namespace stria::coarse {
namespace {

/// What tips that go straight on pass over: elements within the disk of eq. (3), or split, and of them those whose
/// points are those of a way.
struct Passed {
    double all = 0.0, on_way = 0.0;
};

Passed passed_by(const Scene& scene, const Mesh& mesh, const std::vector<double>& K, double way) {
    const std::vector<Tip>& tips = scene.enriched.tips;
    const std::vector<double> yield_stress = scene.yield_stress_at_tips();
    Passed passed;
    for (int e = 0; e < std::ssize(mesh.elements); ++e) {
        const Vec2 x = centre(mesh, e);
        const double size = diagonal(mesh, e);
        const bool is_split = !mesh.level.empty() && mesh.level[at(e)] > 0;
        bool inside = is_split, on_way = false;
        for (std::size_t t = 0; t < tips.size(); ++t) {
            const double distance =
                distance_to_segment(x, tips[t].position, tips[t].position + way * tips[t].direction);
            inside = inside || distance <= zone_radius(scene.input.fine, yield_stress[t], K[t]);
            on_way = on_way || lies_on_way(tips[t], x, size);
        }
        passed.all += inside ? 1.0 : 0.0;
        passed.on_way += inside && on_way ? 1.0 : 0.0;
    }
    return passed;
}

}  // namespace

ZoneSize size_of_zone(const Scene& scene, const ElementSet& zone) {
    const IntegrationRule rule = zone_rule(scene.input.fine, scene.materials.may_yield());
    const std::vector<int> pieces = piece_of_elements(scene.enriched);
    ZoneSize size{.all = static_cast<double>(zone.size()), .elements = static_cast<double>(zone.count())};
    for (const int e : zone.members())
        size.points += points_of_zone(scene.enriched, e, scene.enriched.piece(pieces[at(e)]), rule);
    return size;
}

ZoneSize size_after(const Scene& scene, const ElementSet& zone, const std::vector<double>& K,
                    const std::vector<double>& K_on_way, double way) {
    ZoneSize size = size_of_zone(scene, zone);
    if (way <= 0.0) return size;
    const bool follows = scene.input.fine.refine > 1;
    const auto mesh_after = [&](double gone) {
        std::vector<RefinedDisk> disks = disks_about_tips(scene, scene.input.cracks, K_on_way, Room::ToGrow);
        for (std::size_t t = 0; t < disks.size(); ++t) disks[t].to += gone * scene.enriched.tips[t].direction;
        return refine(scene.mesh, disks).mesh;
    };
    const Mesh finer = follows ? mesh_after(way) : Mesh();
    const Mesh& mesh = follows ? finer : *scene.mesh;
    const Passed before = passed_by(scene, *scene.mesh, K, 0.0);
    const Passed after = passed_by(scene, mesh, K_on_way, way);
    const IntegrationRule rule = zone_rule(scene.input.fine, scene.materials.may_yield());
    const double near = rule.subcells, far = rule.far_subcells.value_or(rule.subcells);
    const double joining = std::max(after.all - before.all, 0.0), on_way = std::max(after.on_way - before.on_way, 0.0);
    size.all = static_cast<double>(mesh.elements.size());
    size.elements += joining;
    size.points += 4.0 * (far * far * std::max(joining - on_way, 0.0) + near * near * on_way);
    return size;
}

std::vector<double> K_after(const Scene& scene, double way) {
    Case longer = scene.input;
    for (const Tip& tip : scene.enriched.tips) {
        std::vector<Vec2>& points = longer.cracks[at(tip.crack)].points;
        (tip.upper > 0 ? points.back() : points.front()) += way * tip.direction;
    }
    try {
        const Scene body = make_scene(longer, scene.mesh);
        const std::unique_ptr<const Scene> own = nominal_scene(body);
        const NominalSolution nominal = solve_nominal_near(std::make_unique<Structure>(own ? *own : body));
        return largest_K(longer, unit_response(nominal));
    } catch (const CaseError&) {
    } catch (const NumericalFailure&) {
    }
    return {};
}

}  // namespace stria::coarse
