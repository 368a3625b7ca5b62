#include "common/fem/mesh.hpp"

#include <numeric>
#include <utility>

#include "common/index.hpp"

namespace stria {

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
