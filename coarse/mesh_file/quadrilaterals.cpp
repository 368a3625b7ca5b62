#include "coarse/mesh_file/quadrilaterals.hpp"

#include <algorithm>
#include <numeric>

#include "common/index.hpp"

namespace stria::coarse {

Quadrilaterals::Quadrilaterals(const Faces& faces)
    : faces_(faces), split_(std::ranges::any_of(faces.faces, [](const Face& face) { return face.nodes.size() < 4; })) {
    mesh_.nodes = faces.nodes;
    for (const auto& [number, nodes] : faces.faces) {
        first_.push_back(static_cast<int>(mesh_.elements.size()));
        if (!split_) {
            mesh_.elements.push_back({nodes[0], nodes[1], nodes[2], nodes[3]});
            continue;
        }
        const std::size_t n = nodes.size();
        std::vector<int> middles;
        Vec2 sum = Vec2::Zero();
        for (std::size_t k = 0; k < n; ++k) {
            middles.push_back(middle(std::minmax(nodes[k], nodes[(k + 1) % n])));
            sum += faces.nodes[at(nodes[k])];
        }
        const int centre = static_cast<int>(mesh_.nodes.size());
        mesh_.nodes.push_back(sum / static_cast<double>(n));
        for (std::size_t k = 0; k < n; ++k)
            mesh_.elements.push_back({nodes[k], middles[k], centre, middles[(k + n - 1) % n]});
    }
}

int Quadrilaterals::middle(const NodePair& edge) {
    const auto [found, added] = middle_.try_emplace(edge, static_cast<int>(mesh_.nodes.size()));
    if (added) mesh_.nodes.push_back((mesh_.nodes[at(edge.first)] + mesh_.nodes[at(edge.second)]) / 2.0);
    return found->second;
}

std::vector<int> Quadrilaterals::parts(int face) const {
    std::vector<int> elements(split_ ? faces_.faces[at(face)].nodes.size() : 1);
    std::iota(elements.begin(), elements.end(), first_[at(face)]);
    return elements;
}

// Part k lies at corner k: its edges 0 and 3 are halves of the face's edges k and k - 1.
std::vector<BoundaryEdge> Quadrilaterals::parts(const FaceEdge& edge) const {
    const int first = first_[at(edge.face)];
    if (!split_) return {{first, edge.edge}};
    const int corners = static_cast<int>(faces_.faces[at(edge.face)].nodes.size());
    return {{first + edge.edge, 0}, {first + (edge.edge + 1) % corners, 3}};
}

}  // namespace stria::coarse
