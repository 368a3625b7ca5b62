#include "coarse/structure/near_elements.hpp"

#include <algorithm>
#include <cmath>

#include "coarse/model/rings.hpp"
#include "common/index.hpp"
#include "common/integration/plain_operator.hpp"

namespace stria::coarse {
namespace {

/// Per node, 1 where it belongs to the zone.
std::vector<char> nodes_of_zone(const EnrichedMesh& mesh, const std::vector<char>& in_zone) {
    std::vector<char> nodes(mesh.nodes.size(), 0);
    for (std::size_t e = 0; e < in_zone.size(); ++e) {
        if (in_zone[e] == 0) continue;
        for (const int node : mesh.elements[e]) nodes[at(node)] = 1;
    }
    return nodes;
}

/// What is near a tip: within `radius` of the way that it has ahead.
struct Neighbourhood {
    double radius = 0.0, way = 0.0;  // mm

    [[nodiscard]] bool holds(const Tip& tip, const Vec2& x) const {
        const Vec2 from_tip = x - tip.position;
        const double along = std::clamp(from_tip.dot(tip.direction), 0.0, way);
        return (from_tip - along * tip.direction).squaredNorm() <= radius * radius;
    }
};

void add_neighbourhood(const EnrichedMesh& mesh, int tip, const Neighbourhood& about, std::vector<char>& nodes) {
    for (std::size_t n = 0; n < nodes.size(); ++n)
        if (about.holds(mesh.tips[at(tip)], mesh.nodes[n])) nodes[n] = 1;
}

/// How far from a tip, ahead of it, the zone reaches that is about no other tip, mm.
double reach_of_zone(const EnrichedMesh& mesh, int tip, const std::vector<char>& nodes) {
    const Tip& own = mesh.tips[at(tip)];
    double reach = 0.0;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        if (nodes[n] == 0 || (mesh.nodes[n] - own.position).dot(own.direction) < 0.0) continue;
        const double distance = (mesh.nodes[n] - own.position).norm();
        const auto closer = [&](const Tip& other) { return (mesh.nodes[n] - other.position).norm() < distance; };
        if (std::ranges::none_of(mesh.tips, closer)) reach = std::max(reach, distance);
    }
    return reach;
}

/// A ring grows no faster than its tip advances; a zone goes with its tip. How long the run will be must not show: it
/// may be resumed with more cycles.
Neighbourhood with_room(const Scene& scene, int tip, const std::vector<char>& nodes_of_zone) {
    constexpr double most = 0.25;  // of the largest ring's radius: what is near is paid for in each increment
    constexpr int steps = 20;
    const double radius = largest_ring(scene, tip);
    if (!scene.input.growth) return {radius, 0.0};
    const double room = std::min(steps * scene.input.growth->increment, most * radius);
    return {std::max(radius, reach_of_zone(scene.enriched, tip, nodes_of_zone)) + room, room};
}

/// Coarse elements that see one of the nodes, and those that are not plain.
std::vector<char> near_about(const EnrichedMesh& mesh, const std::vector<char>& in_zone,
                             const std::vector<char>& nodes) {
    std::vector<char> near(in_zone.size(), 0);
    for (int e = 0; e < std::ssize(in_zone); ++e) {
        if (in_zone[at(e)] != 0) continue;
        const bool close = std::ranges::any_of(mesh.elements[at(e)], [&](int node) { return nodes[at(node)] != 0; });
        near[at(e)] = static_cast<char>(close || !is_plain(mesh, e));
    }
    return near;
}

}  // namespace

std::vector<char> near_elements(const Scene& scene, const std::vector<char>& in_zone) {
    const EnrichedMesh& mesh = scene.enriched;
    std::vector<char> nodes = nodes_of_zone(mesh, in_zone);
    for (int t = 0; t < std::ssize(mesh.tips); ++t) add_neighbourhood(mesh, t, {largest_ring(scene, t), 0.0}, nodes);
    return near_about(mesh, in_zone, nodes);
}

// Where nothing has to be near nothing is far either.
std::vector<char> far_elements(const Scene& scene, const std::vector<char>& in_zone, const std::vector<char>& known) {
    const EnrichedMesh& mesh = scene.enriched;
    std::vector<char> near = near_elements(scene, in_zone);
    const auto elements = in_zone.size();
    bool still = known.size() == elements;
    for (std::size_t e = 0; e < elements && still; ++e) still = known[e] == 0 || (in_zone[e] == 0 && near[e] == 0);
    if (still) return known;
    const std::vector<char> of_zone = nodes_of_zone(mesh, in_zone);
    std::vector<char> nodes = of_zone;
    for (int t = 0; t < std::ssize(mesh.tips); ++t) add_neighbourhood(mesh, t, with_room(scene, t, of_zone), nodes);
    near = near_about(mesh, in_zone, nodes);
    std::vector<char> far(elements, 0);
    if (std::ranges::find(near, static_cast<char>(1)) == near.end()) return far;
    for (std::size_t e = 0; e < elements; ++e) far[e] = static_cast<char>(in_zone[e] == 0 && near[e] == 0);
    return far;
}

}  // namespace stria::coarse
