#include "common/enrichment/part_of_mesh.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "common/enrichment/element_basis.hpp"
#include "common/error.hpp"
#include "common/index.hpp"

namespace stria {

namespace {

/// Drops the terms that no element of the mesh sees.
void drop_unseen_terms(EnrichedMesh& mesh) {
    mesh.number();
    std::vector<char> seen(at(mesh.unknowns), 0);
    const std::vector<int> piece = piece_of_elements(mesh);
    const auto is_plain = [&](int node) { return mesh.terms[at(node)].empty() && mesh.tie(node) == nullptr; };
    for (int e = 0; e < static_cast<int>(mesh.elements.size()); ++e) {
        if (std::ranges::all_of(mesh.elements[at(e)], is_plain)) continue;  // most of them
        const ElementBasis basis(mesh, e, piece[at(e)] >= 0);
        for (const int unknown : basis.unknowns()) seen[at(unknown)] = 1;
    }
    for (const int node : mesh.terms.nodes()) {
        std::vector<Term> kept;
        const auto& terms = mesh.terms[at(node)];
        for (int t = 0; t < static_cast<int>(terms.size()); ++t) {
            if (mesh.follows(node, t + 1) || seen[at(mesh.unknown(node, t + 1, 0))] != 0) kept.push_back(terms[at(t)]);
        }
        mesh.terms.of(at(node)) = std::move(kept);
    }
    mesh.number();
}

}  // namespace

EnrichedMesh extract(const EnrichedMesh& whole, const std::vector<int>& elements) {
    EnrichedMesh part;
    part.tips = whole.tips;
    part.left_tips = whole.left_tips;
    part.mouths = whole.mouths;
    part.grown_at_start = whole.grown_at_start;
    part.tip_exponent = whole.tip_exponent;
    part.tip_functions = whole.tip_functions;

    std::vector<int> local_node(whole.nodes.size(), -1), local_element(whole.elements.size(), -1);
    for (const int e : elements) {
        for (const int node : whole.elements[at(e)]) local_node[at(node)] = 0;
    }
    std::vector<Vec2> nodes;
    std::vector<int> node_ids, of_whole;
    for (std::size_t n = 0; n < local_node.size(); ++n) {  // the part keeps the order of the whole
        if (local_node[n] < 0) continue;
        local_node[n] = static_cast<int>(nodes.size());
        nodes.push_back(whole.nodes[n]);
        node_ids.push_back(whole.node_ids[n]);
        of_whole.push_back(static_cast<int>(n));
    }
    part.terms = TermsOfNodes(nodes.size());
    for (std::size_t n = 0; n < nodes.size(); ++n)
        if (const auto& terms = whole.terms[at(of_whole[n])]; !terms.empty()) part.terms.of(n) = terms;
    part.nodes = std::move(nodes);
    part.node_ids = std::move(node_ids);
    std::vector<std::array<int, 4>> own;
    std::vector<int> element_ids, material;
    for (const int e : elements) {
        const auto index = at(e);
        local_element[index] = static_cast<int>(own.size());
        std::array<int, 4> corners{};
        for (std::size_t k = 0; k < 4; ++k) corners[k] = local_node[at(whole.elements[index][k])];
        own.push_back(corners);
        element_ids.push_back(whole.element_ids[index]);
        part.element_side.push_back(whole.element_side[index]);
        part.branch.push_back(static_cast<signed char>(branch_side(whole, e)));
        if (!whole.material.empty()) material.push_back(whole.material[index]);
    }
    part.elements = std::move(own);
    part.element_ids = std::move(element_ids);
    part.material = std::move(material);
    for (CrackPiece piece : whole.pieces) {
        piece.element = local_element[at(piece.element)];
        if (piece.neighbour >= 0) piece.neighbour = local_element[at(piece.neighbour)];
        if (piece.element >= 0) part.pieces.push_back(std::move(piece));
    }
    for (TiedNode tied : whole.tied) {
        const int local = local_node[at(tied.node)];
        if (local < 0) continue;
        tied.node = local;
        for (int& end : tied.ends) {
            end = local_node[at(end)];
            require(end >= 0, "a part of a mesh has the ends of the edges that its nodes hang on");
        }
        part.tied.push_back(tied);
    }
    drop_unseen_terms(part);
    return part;
}

std::vector<int> whole_unknowns(const EnrichedMesh& whole, const EnrichedMesh& part) {
    std::vector<int> result(at(part.unknowns));
    for (const auto& [node, term, unknown] : part.own_unknowns()) {
        const auto n = at(node);
        const auto place = std::ranges::lower_bound(whole.node_ids, part.node_ids[n]) - whole.node_ids.begin();
        const int there = static_cast<int>(place);
        // The part may have dropped terms that none of its elements sees.
        const int same = term == 0 ? 0 : whole.term_index(there, part.terms[n][at(term - 1)]);
        for (int c = 0; c < 2; ++c) result[at(unknown + c)] = whole.unknown(there, same, c);
    }
    return result;
}

}  // namespace stria
