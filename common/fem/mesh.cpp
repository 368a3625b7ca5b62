#include "common/fem/mesh.hpp"

#include <limits>
#include <numeric>
#include <utility>

#include "common/index.hpp"

namespace stria {
namespace {

/// Of the elements around a node.
double shortest_edge(const Mesh& mesh, int node) {
    double shortest = std::numeric_limits<double>::infinity();
    for (const std::array<int, 4>& element : mesh.elements) {
        if (std::ranges::find(element, node) == element.end()) continue;
        for (std::size_t k = 0; k < 4; ++k)
            shortest = std::min(shortest, (mesh.nodes[at(element[(k + 1) % 4])] - mesh.nodes[at(element[k])]).norm());
    }
    return shortest;
}

}  // namespace

int nearest_node(const Mesh& mesh, const Vec2& place) {
    const auto distance = [&](const Vec2& node) { return (node - place).squaredNorm(); };
    return static_cast<int>(std::ranges::min_element(mesh.nodes, {}, distance) - mesh.nodes.begin());
}

bool is_at(const Mesh& mesh, int node, const Vec2& place) {
    constexpr double coincidence = 1e-6;
    return (mesh.nodes[at(node)] - place).norm() <= coincidence * shortest_edge(mesh, node);
}

IndexLists elements_around_nodes(const Mesh& mesh) {
    std::vector<std::size_t> first(mesh.nodes.size() + 1, 0);
    for (const std::array<int, 4>& element : mesh.elements)
        for (const int node : element) ++first[at(node) + 1];
    for (const HangingNode& hanging : mesh.hanging) ++first[at(hanging.node) + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<std::size_t> next(first.begin(), first.end() - 1);
    std::vector<int> around(first.back());
    for (std::size_t element = 0; element < mesh.elements.size(); ++element)
        for (const int node : mesh.elements[element]) around[next[at(node)]++] = static_cast<int>(element);
    for (const HangingNode& hanging : mesh.hanging) around[next[at(hanging.node)]++] = hanging.larger;
    return {std::move(first), std::move(around)};
}

}  // namespace stria
