// The elements about many nodes, where a sorted list of them would cost more than what is done with each.
#pragma once

#include <algorithm>
#include <span>

#include "common/fem/body_mesh.hpp"
#include "common/index.hpp"

namespace stria {

/// Calls visit(element) for the elements that have some of the nodes as corners, once a corner.
template <class Visit> void for_each_about(const BodyMesh& mesh, std::span<const int> nodes, const Visit& visit) {
    for (const int node : nodes) {
        for (const int element : mesh.around()[at(node)]) {
            const std::array<int, 4>& corners = mesh->elements[at(element)];  // a node may hang on its edge
            if (std::ranges::find(corners, node) != corners.end()) visit(element);
        }
    }
}

}  // namespace stria
