#include "coarse/enrichment/retained_functions.hpp"

#include <algorithm>

#include "coarse/enrichment/tip_reach.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {

/// Functions of a tip so near to those of the old one say next to the same: over some elements in steps of a fifth of
/// one the condition of the equations is 1e9 with six functions, of a tenth 1e15 (verification.RetainedFunctions).
bool is_nearly_where_it_was(const EnrichedMesh& mesh, const Tip& old) {
    constexpr double apart = 0.22;  // elements
    return mesh.tip_functions > 0 && std::ranges::any_of(mesh.tips, [&](const Tip& tip) {
               return tip.crack == old.crack && tip.upper == old.upper &&
                      (tip.position - old.position).norm() < apart * tip_element_edge(mesh, tip);
           });
}

}  // namespace

EnrichedMesh with_functions_left(EnrichedMesh mesh, const EnrichedMesh& before) {
    for (std::size_t node = 0; node < before.nodes.size(); ++node) {
        for (Term term : before.terms[node]) {
            if (term.kind != Term::Kind::Tip && term.kind != Term::Kind::Left) continue;
            const Tip& tip = before.tip_of(term);
            const auto same = [&](const Tip& other) { return same_place(tip, other); };
            if (mesh.tip_functions > 0 && std::ranges::any_of(mesh.tips, same)) continue;
            if (term.kind == Term::Kind::Tip && is_nearly_where_it_was(mesh, tip)) continue;
            auto left = std::ranges::find_if(mesh.left_tips, same);
            if (left == mesh.left_tips.end()) left = mesh.left_tips.insert(left, tip);
            term.kind = Term::Kind::Left;
            term.owner = static_cast<int>(left - mesh.left_tips.begin());
            mesh.terms[node].push_back(term);
        }
    }
    mesh.number();
    return mesh;
}

}  // namespace stria::coarse
