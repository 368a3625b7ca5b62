#include "common/fem/mesh.hpp"

#include "common/index.hpp"

namespace stria {

std::vector<std::vector<int>> elements_around_nodes(const Mesh& mesh) {
    std::vector<std::vector<int>> around(mesh.nodes.size());
    for (std::size_t element = 0; element < mesh.elements.size(); ++element) {
        for (const int node : mesh.elements[element]) around[at(node)].push_back(static_cast<int>(element));
    }
    for (const HangingNode& hanging : mesh.hanging) around[at(hanging.node)].push_back(hanging.larger);
    return around;
}

}  // namespace stria
