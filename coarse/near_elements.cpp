#include "coarse/near_elements.hpp"

#include <algorithm>

#include "coarse/rings.hpp"
#include "common/fem/plain_operator.hpp"

namespace stria::coarse {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// Per node, 1 where it belongs to the zone or lies within the largest ring about a tip.
std::vector<char> nodes_of_interest(const Scene& scene, const std::vector<char>& in_zone) {
    const EnrichedMesh& mesh = scene.enriched;
    std::vector<char> nodes(mesh.nodes.size(), 0);
    for (std::size_t e = 0; e < in_zone.size(); ++e) {
        if (in_zone[e] == 0) continue;
        for (const int node : mesh.elements[e]) nodes[at(node)] = 1;
    }
    for (int t = 0; t < std::ssize(mesh.tips); ++t) {
        const double radius = largest_ring(scene, t);
        const Vec2 tip = mesh.tips[at(t)].position;
        for (std::size_t n = 0; n < nodes.size(); ++n)
            if ((mesh.nodes[n] - tip).squaredNorm() <= radius * radius) nodes[n] = 1;
    }
    return nodes;
}

}  // namespace

std::vector<char> near_elements(const Scene& scene, const std::vector<char>& in_zone) {
    const std::vector<char> nodes = nodes_of_interest(scene, in_zone);
    std::vector<char> near(in_zone.size(), 0);
    for (int e = 0; e < std::ssize(in_zone); ++e) {
        if (in_zone[at(e)] != 0) continue;
        const auto& corners = scene.enriched.elements[at(e)];
        const bool close = std::ranges::any_of(corners, [&](int node) { return nodes[at(node)] != 0; });
        near[at(e)] = static_cast<char>(close || !is_plain(scene.enriched, e));
    }
    return near;
}

}  // namespace stria::coarse
