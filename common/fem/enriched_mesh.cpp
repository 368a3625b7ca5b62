#include "common/fem/enriched_mesh.hpp"

#include <map>

namespace stria {

void EnrichedMesh::number() {
    first_unknown.assign(nodes.size(), 0);
    unknowns = 0;
    for (std::size_t node = 0; node < nodes.size(); ++node) {
        first_unknown[node] = unknowns;
        unknowns += 2 * (1 + static_cast<int>(terms[node].size()));
    }
}

EnrichedMesh extract(const EnrichedMesh& whole, const std::vector<int>& elements) {
    EnrichedMesh part;
    part.tips = whole.tips;
    part.tip_exponent = whole.tip_exponent;
    part.tip_functions = whole.tip_functions;

    std::map<int, int> local_node;  // ascending: the part keeps the order of the whole
    std::vector<int> local_element(whole.elements.size(), -1);
    for (const int e : elements) {
        for (const int node : whole.elements[static_cast<std::size_t>(e)]) local_node.emplace(node, 0);
    }
    for (auto& [node, local] : local_node) {
        local = static_cast<int>(part.nodes.size());
        const auto n = static_cast<std::size_t>(node);
        part.nodes.push_back(whole.nodes[n]);
        part.node_ids.push_back(whole.node_ids[n]);
        part.terms.push_back(whole.terms[n]);
    }
    for (const int e : elements) {
        const auto index = static_cast<std::size_t>(e);
        local_element[index] = static_cast<int>(part.elements.size());
        std::array<int, 4> corners{};
        for (std::size_t k = 0; k < 4; ++k) corners[k] = local_node.at(whole.elements[index][k]);
        part.elements.push_back(corners);
        part.element_ids.push_back(whole.element_ids[index]);
        part.element_side.push_back(whole.element_side[index]);
    }
    for (CrackPiece piece : whole.pieces) {
        piece.element = local_element[static_cast<std::size_t>(piece.element)];
        if (piece.neighbour >= 0) piece.neighbour = local_element[static_cast<std::size_t>(piece.neighbour)];
        if (piece.element >= 0) part.pieces.push_back(std::move(piece));
    }
    part.number();
    return part;
}

}  // namespace stria
