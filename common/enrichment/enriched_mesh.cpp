#include "common/enrichment/enriched_mesh.hpp"

#include <algorithm>

#include "common/error.hpp"
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
        for (int k = 0; k < std::ssize(terms[node]); ++k) {
            const Term& term = terms[node][at(k)];
            if (term.kind != Term::Kind::Gathered) {
                if (!follows(static_cast<int>(node), k + 1)) unknowns += 2;
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
    auto twin = other.node_ids.begin();  // ids ascend in both
    for (const auto& [node, term, unknown] : mesh.own_unknowns()) {
        const auto n = at(node);
        while (twin != other.node_ids.end() && *twin < mesh.node_ids[n]) ++twin;
        if (twin == other.node_ids.end()) break;
        if (*twin != mesh.node_ids[n]) continue;
        const int other_node = static_cast<int>(twin - other.node_ids.begin());
        int same = 0;
        if (term > 0) {
            const Term& own = mesh.terms[n][at(term - 1)];
            const auto& terms = other.terms[at(other_node)];
            const auto found = std::ranges::find_if(terms, [&](const Term& t) { return same_on(other, t, mesh, own); });
            if (found == terms.end()) continue;
            same = static_cast<int>(found - terms.begin()) + 1;
        }
        if (other.follows(other_node, same)) continue;
        for (const int component : {0, 1}) result[at(unknown + component)] = other.unknown(other_node, same, component);
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
