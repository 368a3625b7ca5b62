#include "common/enrichment/same_functions.hpp"

#include <algorithm>

namespace stria {
namespace {

bool same_term(const Term& a, const Term& b) { return a.same_function(b) && a.shift == b.shift; }

bool same_terms(const std::vector<Term>& a, const std::vector<Term>& b) { return std::ranges::equal(a, b, same_term); }

bool same_terms(const TermsOfNodes& a, const TermsOfNodes& b) {
    const std::vector<int> nodes = a.nodes();
    return a.size() == b.size() && nodes == b.nodes() &&
           std::ranges::all_of(nodes, [&](int node) { return same_terms(a[at(node)], b[at(node)]); });
}

bool same_tie(const TiedNode& a, const TiedNode& b) {
    return a.node == b.node && a.ends == b.ends && a.side == b.side && a.jump_tied == b.jump_tied;
}

/// What tip_polar() reads of a tip.
bool same_frame(const Tip& a, const Tip& b) {
    return a.position == b.position && a.direction == b.direction && a.upper == b.upper;
}

bool same_piece(const CrackPiece& a, const CrackPiece& b) {
    return a.crack == b.crack && a.element == b.element && a.neighbour == b.neighbour && a.points == b.points &&
           a.entry == b.entry && a.exit == b.exit;
}

}  // namespace

bool same_functions_at(int node, const EnrichedMesh& mesh, int other_node, const EnrichedMesh& other) {
    const std::vector<Term>& own = mesh.terms[at(node)];
    const auto stands = [&](const Term& term) {
        return term.kind == Term::Kind::Heaviside || same_frame(mesh.tip_of(term), other.tip_of(term));
    };
    return same_terms(own, other.terms[at(other_node)]) && std::ranges::all_of(own, stands);
}

bool same_but_for_tips(const EnrichedMesh& mesh, const EnrichedMesh& other) {
    const auto plain = [](const EnrichedMesh& m) { return m.tip_functions == 0 && m.left_tips.empty(); };
    const auto same_end = [](const Tip& a, const Tip& b) { return a.crack == b.crack && a.upper == b.upper; };
    return plain(mesh) && plain(other) && mesh.unknowns == other.unknowns &&
           std::ranges::equal(mesh.tips, other.tips, same_end) &&
           std::ranges::equal(mesh.pieces, other.pieces, same_piece) && mesh.element_ids == other.element_ids &&
           mesh.node_ids == other.node_ids && mesh.elements == other.elements && mesh.nodes == other.nodes &&
           mesh.material == other.material && mesh.element_side == other.element_side && mesh.branch == other.branch &&
           std::ranges::equal(mesh.tied, other.tied, same_tie) && same_terms(mesh.terms, other.terms);
}

bool same_arc_lengths(const EnrichedMesh& mesh, const EnrichedMesh& other) {
    return std::ranges::equal(mesh.pieces, other.pieces, {}, &CrackPiece::s, &CrackPiece::s);
}

bool same_functions(const EnrichedMesh& mesh, const EnrichedMesh& other, const ElementSet& elements) {
    NodeSet nodes(mesh.nodes.size());
    for (const int e : elements.members()) {
        for (const int node : mesh.elements[at(e)]) {
            nodes.insert(node);
            if (const TiedNode* const tie = mesh.tie(node))
                for (const int end : tie->ends) nodes.insert(end);
        }
    }
    const auto same_node = [&](int node) {
        const TiedNode *const tie = mesh.tie(node), *const other_tie = other.tie(node);
        const bool as_tied = tie == nullptr ? other_tie == nullptr : other_tie != nullptr && same_tie(*tie, *other_tie);
        return as_tied && same_terms(mesh.terms[at(node)], other.terms[at(node)]);
    };
    const std::vector<int> piece = piece_of_elements(mesh), other_piece = piece_of_elements(other);
    const auto same_cut = [&](int e) {
        const CrackPiece *const a = mesh.piece(piece[at(e)]), *const b = other.piece(other_piece[at(e)]);
        return a == nullptr || b == nullptr ? a == b : same_piece(*a, *b);
    };
    for (int e = 0; e < std::ssize(mesh.elements); ++e) {
        const auto& corners = mesh.elements[at(e)];
        if (!contains_any(nodes, corners)) continue;
        if (corners != other.elements[at(e)] || !std::ranges::all_of(corners, same_node) || !same_cut(e) ||
            mesh.element_side[at(e)] != other.element_side[at(e)])
            return false;
    }
    return true;
}

}  // namespace stria
