#include "common/fracture/ring_weights.hpp"

#include <array>
#include <cmath>
#include <optional>

#include "common/index.hpp"

namespace stria {
namespace {

/// How far from a tip a node is that hangs between two others: as far as these.
using Distances = std::array<double, 2>;

Distances distances(const EnrichedMesh& mesh, int node, const Tip& tip) {
    const auto of_node = [&](int n) { return (mesh.nodes[at(n)] - tip.position).norm(); };
    const TiedNode* const tied = mesh.tied.empty() ? nullptr : mesh.tie(node);
    if (tied != nullptr) return {of_node(tied->ends[0]), of_node(tied->ends[1])};
    const double distance = of_node(node);
    return {distance, distance};
}

std::array<Distances, 4> corner_distances(const EnrichedMesh& mesh, int element, const Tip& tip) {
    std::array<Distances, 4> corners;
    std::ranges::transform(mesh.elements[at(element)], corners.begin(),
                           [&](int node) { return distances(mesh, node, tip); });
    return corners;
}

// Between the ends of its edge at a hanging node, so that q is continuous.
Eigen::Vector4d weights(const std::array<Distances, 4>& corners, const Annulus& ring) {
    Eigen::Vector4d q;
    for (std::size_t k = 0; k < 4; ++k)
        q[static_cast<Eigen::Index>(k)] = (ring.weight(corners[k][0]) + ring.weight(corners[k][1])) / 2.0;
    return q;
}

bool constant(const Eigen::Vector4d& q) { return (q.array() == q[0]).all(); }

}  // namespace

Eigen::Vector4d corner_weights(const EnrichedMesh& mesh, int element, const Tip& tip, const Annulus& ring) {
    return weights(corner_distances(mesh, element, tip), ring);
}

RingWeights::RingWeights(const EnrichedMesh& mesh, const Tip& tip, std::span<const Annulus> rings,
                         std::span<const int> among, bool with_inside) {
    std::vector<Distances> known;  // elements share their corners
    std::vector<int> place(mesh.nodes.size(), -1);
    const auto of_corner = [&](int node) {
        int& own = place[at(node)];
        if (own < 0) {
            own = static_cast<int>(known.size());
            known.push_back(distances(mesh, node, tip));
        }
        return known[at(own)];
    };
    for (const int element : among) {
        const std::size_t first = entered_.size();
        std::array<Distances, 4> corners;
        std::ranges::transform(mesh.elements[at(element)], corners.begin(), of_corner);
        for (std::size_t ring = 0; ring < rings.size(); ++ring) {
            const Eigen::Vector4d q = weights(corners, rings[ring]);
            if (!constant(q) || (with_inside && q[0] != 0.0)) entered_.push_back({ring, q});
        }
        if (entered_.size() == first) continue;
        elements_.push_back(element);
        first_.push_back(first);
    }
    first_.push_back(entered_.size());
}

bool reaches(const EnrichedMesh& mesh, const Tip& tip, const Annulus& ring) {
    for (int element = 0; element < std::ssize(mesh.elements); ++element)
        if (!constant(corner_weights(mesh, element, tip, ring))) return true;
    return false;
}

}  // namespace stria
