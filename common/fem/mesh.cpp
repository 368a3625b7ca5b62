#include "common/fem/mesh.hpp"

namespace stria {

std::vector<std::vector<int>> elements_around_nodes(const std::vector<std::array<int, 4>>& elements,
                                                    std::size_t node_count) {
    std::vector<std::vector<int>> around(node_count);
    for (std::size_t element = 0; element < elements.size(); ++element) {
        for (const int node : elements[element]) {
            around[static_cast<std::size_t>(node)].push_back(static_cast<int>(element));
        }
    }
    return around;
}

}  // namespace stria
