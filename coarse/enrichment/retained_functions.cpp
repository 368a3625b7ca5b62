#include "coarse/enrichment/retained_functions.hpp"

#include <algorithm>

#include "coarse/enrichment/tip_reach.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {

bool is_nearly_at(const EnrichedMesh& mesh, const Tip& tip, const Tip& old) {
    return mesh.tip_functions > 0 && tip.crack == old.crack && tip.upper == old.upper &&
           (tip.position - old.position).norm() < apart_to_retain * tip_element_edge(mesh, tip);
}

}  // namespace

EnrichedMesh with_functions_left(EnrichedMesh mesh, const EnrichedMesh& before) {
    for (const int node : before.terms.nodes()) {
        for (Term term : before.terms[at(node)]) {
            if (term.kind != Term::Kind::Tip && term.kind != Term::Kind::Left) continue;
            const Tip& tip = before.tip_of(term);
            const auto same = [&](const Tip& other) { return same_place(tip, other); };
            if (mesh.tip_functions > 0 && std::ranges::any_of(mesh.tips, same)) continue;
            const auto nearly = [&](const Tip& other) { return is_nearly_at(mesh, other, tip); };
            if (term.kind == Term::Kind::Tip && std::ranges::any_of(mesh.tips, nearly)) continue;
            auto left = std::ranges::find_if(mesh.left_tips, same);
            if (left == mesh.left_tips.end()) left = mesh.left_tips.insert(left, tip);
            term.kind = Term::Kind::Left;
            term.owner = static_cast<int>(left - mesh.left_tips.begin());
            mesh.terms.of(at(node)).push_back(term);
        }
    }
    mesh.number();
    return mesh;
}

std::vector<int> tips_nearly_where_they_were(const EnrichedMesh& mesh, const EnrichedMesh& before) {
    std::vector<int> tips;
    for (int t = 0; before.tip_functions > 0 && t < std::ssize(mesh.tips); ++t) {
        const Tip& tip = mesh.tips[at(t)];
        const auto has_moved_a_little = [&](const Tip& old) {
            return is_nearly_at(mesh, tip, old) && !same_place(tip, old);
        };
        if (std::ranges::any_of(before.tips, has_moved_a_little)) tips.push_back(t);
    }
    return tips;
}

}  // namespace stria::coarse
