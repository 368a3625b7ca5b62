#include "common/enrichment/enriched_mesh.hpp"

#include <algorithm>

#include "common/error.hpp"
#include "common/index.hpp"

namespace stria {
namespace {

/// Nodes with other unknowns than those of their displacement, or none of their own; ascending.
std::vector<int> nodes_with_more_or_less(const EnrichedMesh& mesh) {
    std::vector<int> nodes = mesh.terms.nodes();
    for (const TiedNode& tie : mesh.tied) nodes.push_back(tie.node);
    std::ranges::sort(nodes);
    nodes.erase(std::ranges::unique(nodes).begin(), nodes.end());
    return nodes;
}

}  // namespace

void EnrichedMesh::number() {
    first_unknown.assign(nodes.size(), 0);
    first_gathered.assign(tips.size(), 0);
    std::vector<int> gathered(tips.size(), 0);  // functions of each tip
    unknowns = 0;
    int next = 0;
    const auto number_until = [&](int end) {  // nodes with a displacement of their own alone
        for (; next < end; ++next, unknowns += 2) first_unknown[at(next)] = unknowns;
    };
    for (const int node : nodes_with_more_or_less(*this)) {
        number_until(node);
        const TiedNode* const tie_here = tie(node);
        first_unknown[at(node)] = tie_here != nullptr ? unknowns - 2 : unknowns;
        if (tie_here == nullptr) unknowns += 2;
        const std::vector<Term>& own = terms[at(node)];
        for (int k = 0; k < std::ssize(own); ++k) {
            if (own[at(k)].kind != Term::Kind::Gathered) {
                if (!follows(node, k + 1)) unknowns += 2;
                continue;
            }
            int& functions = gathered[at(own[at(k)].owner)];
            functions = std::max(functions, own[at(k)].function + 1);
        }
        ++next;
    }
    number_until(static_cast<int>(nodes.size()));
    for (std::size_t tip = 0; tip < tips.size(); ++tip) {
        first_gathered[tip] = unknowns;
        unknowns += 2 * gathered[tip];
    }
}

bool EnrichedMesh::follows(int node, int term) const {
    const TiedNode* const here = tie(node);
    return here != nullptr &&
           (term == 0 || here->jump_tied || terms[at(node)][at(term - 1)].kind != Term::Kind::Heaviside);
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

// Nodes without unknowns of their own seem to begin where others do.
int EnrichedMesh::node_of(int unknown) const {
    if (!first_gathered.empty() && unknown >= first_gathered.front()) return -1;
    auto node = static_cast<int>(std::ranges::upper_bound(first_unknown, unknown) - first_unknown.begin()) - 1;
    while (tie(node) != nullptr && unknown < first_unknown[at(node)] + 2) --node;
    return node;
}

bool EnrichedMesh::is_standard(int unknown) const {
    const int node = node_of(unknown);
    return node >= 0 && unknown < first_unknown[at(node)] + 2;
}

double EnrichedMesh::value_at(const TiedNode& here, const Term& function) const {
    if (function.kind == Term::Kind::Heaviside) return here.side;
    const int own = term_index(here.node, function);
    require(own > 0, "a hanging node has the tip functions of the ends of its edge");
    return terms[at(here.node)][at(own - 1)].shift;
}

int EnrichedMesh::term_index(int node, const Term& term) const {
    const auto& own = terms[at(node)];
    const auto found = std::ranges::find_if(own, [&](const Term& t) { return t.same_function(term); });
    return found != own.end() ? static_cast<int>(found - own.begin()) + 1 : 0;
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

std::vector<int> same_unknowns(const EnrichedMesh& mesh, const EnrichedMesh& other) {
    std::vector<int> result(at(mesh.unknowns), -1);
    const auto put = [&](int node, int term, int other_node, int other_term) {
        if (mesh.follows(node, term) || other.follows(other_node, other_term)) return;
        for (const int component : {0, 1})
            result[at(mesh.unknown(node, term, component))] = other.unknown(other_node, other_term, component);
    };
    std::size_t twin = 0;  // ids ascend in both
    for (int node = 0; node < std::ssize(mesh.nodes); ++node) {
        while (twin < other.node_ids.size() && other.node_ids[twin] < mesh.node_ids[at(node)]) ++twin;
        if (twin == other.node_ids.size()) break;
        if (other.node_ids[twin] != mesh.node_ids[at(node)]) continue;
        const int other_node = static_cast<int>(twin);
        put(node, 0, other_node, 0);
        const std::vector<Term>&own = mesh.terms[at(node)], &terms = other.terms[twin];
        for (std::size_t term = 0; term < own.size(); ++term) {
            const auto is_same = [&](const Term& t) { return same_on(other, t, mesh, own[term]); };
            const auto found = std::ranges::find_if(terms, is_same);
            if (found == terms.end()) continue;
            put(node, static_cast<int>(term) + 1, other_node, static_cast<int>(found - terms.begin()) + 1);
        }
    }
    return result;
}

Eigen::VectorXd carry_over(const EnrichedMesh& from, const Eigen::VectorXd& values, const EnrichedMesh& to,
                           Eigen::VectorXd initial) {
    const std::vector<int> same = same_unknowns(to, from);
    for (std::size_t i = 0; i < same.size(); ++i)
        if (same[i] >= 0) initial[static_cast<Eigen::Index>(i)] = values[same[i]];
    return initial;
}

int branch_side(const EnrichedMesh& mesh, int element) {
    if (!mesh.branch.empty()) return mesh.branch[at(element)];
    if (const int side = mesh.element_side[at(element)]; side != 0) return side;
    for (const int node : mesh.elements[at(element)])
        for (const Term& term : mesh.terms[at(node)])
            if (term.kind == Term::Kind::Heaviside) return static_cast<int>(term.shift);
    return 0;
}

std::vector<int> piece_of_elements(const EnrichedMesh& mesh) {
    std::vector<int> result(mesh.elements.size(), -1);
    for (std::size_t p = 0; p < mesh.pieces.size(); ++p) {
        if (mesh.pieces[p].neighbour < 0) result[at(mesh.pieces[p].element)] = static_cast<int>(p);
    }
    return result;
}

}  // namespace stria
