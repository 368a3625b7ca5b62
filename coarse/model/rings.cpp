#include "coarse/model/rings.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "coarse/model/tip_reach.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {

/// Over the outer radius of the largest ring. The second is there for plastic zones that reach into the first.
constexpr std::array family{Annulus{0.5, 1.0}, Annulus{0.75, 1.0}, Annulus{0.35, 0.7}, Annulus{0.25, 0.5},
                            Annulus{0.175, 0.35}};
constexpr double elements_across = 2.0;

/// Longest element edge with an end inside a ring, mm.
double element_size(const EnrichedMesh& mesh, const Tip& tip, const Annulus& ring) {
    const auto inside = [&](const Vec2& x) {
        const double r = (x - tip.position).norm();
        return r > ring.inner && r < ring.outer;
    };
    double longest = 0.0;
    for (const std::array<int, 4>& element : mesh.elements) {
        for (std::size_t k = 0; k < 4; ++k) {
            const Vec2 &a = mesh.nodes[at(element[k])], &b = mesh.nodes[at(element[(k + 1) % 4])];
            if (inside(a) || inside(b)) longest = std::max(longest, (b - a).norm());
        }
    }
    return longest > 0.0 ? longest : std::numeric_limits<double>::infinity();
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
    std::vector<Annulus> rings;
    for (const auto& [inner, outer] : family) {
        const Annulus ring{inner * radius, outer * radius};
        const double size = element_size(scene.enriched, scene.enriched.tips[at(tip)], ring);
        if (rings.empty() || ring.outer - ring.inner >= elements_across * size) rings.push_back(ring);
    }
    return rings;
}

}  // namespace stria::coarse
