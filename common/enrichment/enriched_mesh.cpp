#include "common/enrichment/enriched_mesh.hpp"

#include <algorithm>
#include <map>

#include "common/enrichment/element_basis.hpp"
#include "common/index.hpp"

namespace stria {

void EnrichedMesh::number() {
    first_unknown.assign(nodes.size(), 0);
    first_gathered.assign(tips.size(), 0);
    std::vector<int> gathered(tips.size(), 0);  // functions of each tip
    unknowns = 0;
    for (std::size_t node = 0; node < nodes.size(); ++node) {
        const TiedNode* const tie_here = tie(static_cast<int>(node));
        first_unknown[node] = tie_here != nullptr ? unknowns - 2 : unknowns;
        if (tie_here == nullptr) unknowns += 2;
        for (const Term& term : terms[node]) {
            if (tie_here != nullptr && tie_here->jump_tied) continue;
            if (term.kind != Term::Kind::Gathered) {
                unknowns += 2;
                continue;
            }
            int& functions = gathered[at(term.owner)];
            functions = std::max(functions, term.function + 1);
        }
    }
    for (std::size_t tip = 0; tip < tips.size(); ++tip) {
        first_gathered[tip] = unknowns;
        unknowns += 2 * gathered[tip];
    }
}

const TiedNode* EnrichedMesh::tie(int node) const {
    const auto found = std::ranges::lower_bound(tied, node, {}, &TiedNode::node);
    return found != tied.end() && found->node == node ? &*found : nullptr;
}

bool EnrichedMesh::follows(int node, int term) const {
    const TiedNode* const here = tie(node);
    return here != nullptr && (term == 0 || here->jump_tied);
}

std::vector<std::pair<int, double>> EnrichedMesh::holders_of_jump(int node) const {
    const TiedNode* const here = tie(node);
    if (here == nullptr || !here->jump_tied) return {{node, 1.0}};
    return {{here->ends[0], 0.5}, {here->ends[1], 0.5}};
}

std::vector<EnrichedMesh::OwnUnknown> EnrichedMesh::own_unknowns() const {
    std::vector<OwnUnknown> own;
    for (int node = 0; node < std::ssize(nodes); ++node) {
        for (int term = 0; term <= std::ssize(terms[at(node)]); ++term)
            if (!follows(node, term)) own.push_back({node, term, unknown(node, term, 0)});
    }
    return own;
}

int EnrichedMesh::term_index(int node, const Term& term) const {
    const auto& own = terms[at(node)];
    const auto found = std::ranges::find_if(own, [&](const Term& t) { return t.same_function(term); });
    return found != own.end() ? static_cast<int>(found - own.begin()) + 1 : 0;
}

bool same_place(const Tip& a, const Tip& b) {
    return a.crack == b.crack && a.upper == b.upper && a.position == b.position && a.direction == b.direction;
}

namespace {

/// The same function on two meshes: a tip that has moved has others, unless the old one's stay.
bool same_on(const EnrichedMesh& from, const Term& old, const EnrichedMesh& to, const Term& term) {
    using enum Term::Kind;
    if (term.kind == Heaviside || old.kind == Heaviside) return old.same_function(term);
    return (old.kind == Gathered) == (term.kind == Gathered) && old.function == term.function &&
           same_place(from.tip_of(old), to.tip_of(term));
}

}  // namespace

Eigen::VectorXd carry_over(const EnrichedMesh& from, const Eigen::VectorXd& values, const EnrichedMesh& to,
                           Eigen::VectorXd initial) {
    std::map<int, int> old_node;  // by id
    for (int n = 0; n < std::ssize(from.nodes); ++n) old_node[from.node_ids[at(n)]] = n;
    for (const auto& [node, term, unknown] : to.own_unknowns()) {
        const auto n = at(node);
        const auto found = old_node.find(to.node_ids[n]);
        if (found == old_node.end()) continue;
        int same = 0;
        if (term > 0) {
            const Term& own = to.terms[n][at(term - 1)];
            const auto& old = from.terms[at(found->second)];
            const auto is_same = [&](const Term& other) { return same_on(from, other, to, own); };
            const auto twin = std::ranges::find_if(old, is_same);
            if (twin == old.end()) continue;
            same = static_cast<int>(twin - old.begin()) + 1;
        }
        if (from.follows(found->second, same)) continue;
        initial.segment<2>(unknown) = values.segment<2>(from.unknown(found->second, same, 0));
    }
    return initial;
}

std::vector<int> piece_of_elements(const EnrichedMesh& mesh) {
    std::vector<int> result(mesh.elements.size(), -1);
    for (std::size_t p = 0; p < mesh.pieces.size(); ++p) {
        if (mesh.pieces[p].neighbour < 0) result[at(mesh.pieces[p].element)] = static_cast<int>(p);
    }
    return result;
}

namespace {

/// Drops the terms that no element of the mesh sees.
void drop_unseen_terms(EnrichedMesh& mesh) {
    mesh.number();
    std::vector<char> seen(at(mesh.unknowns), 0);
    const std::vector<int> piece = piece_of_elements(mesh);
    for (int e = 0; e < static_cast<int>(mesh.elements.size()); ++e) {
        const ElementBasis basis(mesh, e, piece[at(e)] >= 0);
        for (const int unknown : basis.unknowns()) seen[at(unknown)] = 1;
    }
    for (int node = 0; node < static_cast<int>(mesh.nodes.size()); ++node) {
        std::vector<Term> kept;
        const auto& terms = mesh.terms[at(node)];
        for (int t = 0; t < static_cast<int>(terms.size()); ++t) {
            if (mesh.follows(node, t + 1) || seen[at(mesh.unknown(node, t + 1, 0))] != 0) kept.push_back(terms[at(t)]);
        }
        mesh.terms[at(node)] = std::move(kept);
    }
    mesh.number();
}

}  // namespace

EnrichedMesh extract(const EnrichedMesh& whole, const std::vector<int>& elements) {
    EnrichedMesh part;
    part.tips = whole.tips;
    part.left_tips = whole.left_tips;
    part.tip_exponent = whole.tip_exponent;
    part.tip_functions = whole.tip_functions;

    std::map<int, int> local_node;  // ascending: the part keeps the order of the whole
    std::vector<int> local_element(whole.elements.size(), -1);
    for (const int e : elements) {
        for (const int node : whole.elements[at(e)]) local_node.emplace(node, 0);
    }
    for (auto& [node, local] : local_node) {
        local = static_cast<int>(part.nodes.size());
        const auto n = at(node);
        part.nodes.push_back(whole.nodes[n]);
        part.node_ids.push_back(whole.node_ids[n]);
        part.terms.push_back(whole.terms[n]);
    }
    for (const int e : elements) {
        const auto index = at(e);
        local_element[index] = static_cast<int>(part.elements.size());
        std::array<int, 4> corners{};
        for (std::size_t k = 0; k < 4; ++k) corners[k] = local_node.at(whole.elements[index][k]);
        part.elements.push_back(corners);
        part.element_ids.push_back(whole.element_ids[index]);
        part.element_side.push_back(whole.element_side[index]);
    }
    for (CrackPiece piece : whole.pieces) {
        piece.element = local_element[at(piece.element)];
        if (piece.neighbour >= 0) piece.neighbour = local_element[at(piece.neighbour)];
        if (piece.element >= 0) part.pieces.push_back(std::move(piece));
    }
    for (TiedNode tied : whole.tied) {
        const auto local = local_node.find(tied.node);
        if (local == local_node.end()) continue;
        tied.node = local->second;
        for (int& end : tied.ends) end = local_node.at(end);
        part.tied.push_back(tied);
    }
    drop_unseen_terms(part);
    return part;
}

}  // namespace stria
