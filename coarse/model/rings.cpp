#include "coarse/model/rings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "coarse/model/tip_reach.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {

/// Over the outer radius of the largest ring. The second is there for plastic zones that reach into the first.
constexpr std::array<Annulus, most_rings> family{Annulus{0.5, 1.0}, Annulus{0.75, 1.0}, Annulus{0.35, 0.7},
                                                 Annulus{0.25, 0.5}, Annulus{0.175, 0.35}};
constexpr double elements_across = 2.0;

/// Longest element edge with an end inside each ring, mm; zero where there is none.
std::vector<double> longest_edges(const EnrichedMesh& mesh, const Tip& tip, std::span<const Annulus> rings) {
    const double farthest = std::ranges::max(rings, {}, &Annulus::outer).outer;
    constexpr double outside = std::numeric_limits<double>::infinity(), margin = 1.001;
    std::vector<double> distance;
    distance.reserve(mesh.nodes.size());
    for (const Vec2& x : mesh.nodes) {
        const double squared = (x - tip.position).squaredNorm();
        distance.push_back(squared < margin * farthest * farthest ? std::sqrt(squared) : outside);
    }
    std::vector<double> longest(rings.size(), 0.0);
    const auto is_outside = [&](int node) { return distance[at(node)] == outside; };
    for (const std::array<int, 4>& element : mesh.elements) {
        if (std::ranges::all_of(element, is_outside)) continue;
        for (std::size_t k = 0; k < 4; ++k) {
            const int a = element[k], b = element[(k + 1) % 4];
            if (is_outside(a) && is_outside(b)) continue;
            const double length = (mesh.nodes[at(b)] - mesh.nodes[at(a)]).norm();
            for (std::size_t ring = 0; ring < rings.size(); ++ring) {
                const auto inside = [&](double r) { return r > rings[ring].inner && r < rings[ring].outer; };
                if (inside(distance[at(a)]) || inside(distance[at(b)])) longest[ring] = std::max(longest[ring], length);
            }
        }
    }
    return longest;
}

}  // namespace

double largest_ring(const Scene& scene, int tip_index) {
    const EnrichedMesh& mesh = scene.enriched;
    const Tip& tip = mesh.tips[at(tip_index)];
    double radius =
        tip_reach(scene.mesh, scene.input.cracks, mesh.tips, tip, bend_to_element * tip_element_size(mesh, tip));
    const auto keep_off = [&](const Loads& loads) {
        for (const PointForce& load : loads.forces)
            radius = std::min(radius, (mesh.nodes[at(load.node)] - tip.position).norm());
    };
    keep_off(scene.loads.main);
    for (const Loads& of_case : scene.loads.cases) keep_off(of_case);
    radius = std::min(radius, distance_to_interface(mesh, tip));
    return 0.95 * radius;
}

std::vector<Annulus> rings_about(const Scene& scene, int tip) {
    const double radius = largest_ring(scene, tip);
    std::array<Annulus, family.size()> all = family;
    for (auto& [inner, outer] : all) inner *= radius, outer *= radius;
    const std::vector<double> sizes = longest_edges(scene.enriched, scene.enriched.tips[at(tip)], all);
    std::vector<Annulus> rings;
    for (std::size_t k = 0; k < all.size(); ++k) {
        const bool is_thick = sizes[k] > 0.0 && all[k].outer - all[k].inner >= elements_across * sizes[k];
        if (rings.empty() || is_thick) rings.push_back(all[k]);
    }
    return rings;
}

}  // namespace stria::coarse
