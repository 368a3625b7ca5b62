#include "coarse/zone/refined_scene.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <utility>

#include "coarse/enrichment/tip_reach.hpp"
#include "coarse/fracture/nominal_solution.hpp"
#include "coarse/fracture/turned_tip.hpp"
#include "coarse/specimen/specimen.hpp"
#include "coarse/zone/tip_refinement.hpp"
#include "common/crack/bends.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {

/// The cracks, those longer that turn sharply as soon as they grow: metal flows on that way before a tip is there, and
/// what has flowed is never split. By K of the largest load; beside load cases they go straight on.
std::vector<CrackSection> about_to_turn(const Scene& scene, const std::vector<TipResult>& nominal,
                                        const LoadFactors& largest) {
    const Case& input = scene.input;
    std::vector<CrackSection> cracks = input.cracks;
    if (!input.growth || input.growth->direction == GrowthDirection::Straight || !input.load_cases.empty())
        return cracks;
    for (std::size_t t = 0; t < scene.enriched.tips.size(); ++t) {
        const Tip& tip = scene.enriched.tips[t];
        const double K_I = K_I_under(nominal[t], largest),
                     angle = hoop_stress_angle(K_I, K_II_under(nominal[t], largest));
        if (!(K_I > 0.0) || !(std::abs(angle) > sharp_turn)) continue;
        const Vec2 step = 0.1 * tip_element_edge(scene.enriched, tip) * (Eigen::Rotation2Dd(angle) * tip.direction);
        std::vector<Vec2>& points = cracks[at(tip.crack)].points;
        points.insert(tip.upper < 0 ? points.begin() : points.end(), tip.position + step);
    }
    return cracks;
}

}  // namespace

Scene refined_scene(const Case& given, const std::function<void(const Scene&)>& before_solving) {
    Mesh mesh = make_mesh(given.mesh, given.cracks, given.regions, given.boundaries);
    Case input = given;
    for (CrackSection& crack : input.cracks) crack.points = ends_and_bends(crack.points);
    Scene scene = make_scene(input, BodyMesh(std::move(mesh)), input.fine.refine);
    if (input.fine.refine == 1) return scene;
    std::vector<double> K(scene.enriched.tips.size(), 0.0);
    std::vector<CrackSection> cracks = input.cracks;
    if (!input.fine.radius || input.growth) {
        if (before_solving) before_solving(scene);
        const NominalSolution nominal = solve_nominal(scene);
        const UnitResponse unit = unit_response(nominal);
        K = largest_K(input, unit);
        cracks = about_to_turn(scene, nominal.tips, range_of_load(input, unit).largest);
    }
    Mesh refined = refine(scene.mesh, disks_about_tips(scene, cracks, K, Room::ToGrow)).mesh;
    refined.material.clear();  // small elements tell the outlines of regions better
    return make_scene(input, BodyMesh(std::move(refined)));
}

}  // namespace stria::coarse
