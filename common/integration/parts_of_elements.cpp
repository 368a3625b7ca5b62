#include "common/integration/parts_of_elements.hpp"

#include <map>

#include "common/index.hpp"
#include "common/integration/element_field.hpp"

namespace stria {
namespace {

void take_field(const ElementField& field, const Eigen::VectorXd& of_whole, const EnrichedMesh& to, int node,
                Eigen::VectorXd& values) {
    const Vec2& x = to.nodes[at(node)];
    if (!to.follows(node, 0)) values.segment<2>(to.unknown(node, 0, 0)) = sum_of(field.at_place(x), of_whole);
    const auto& terms = to.terms[at(node)];
    for (int term = 1; term <= std::ssize(terms) && field.is_cut(); ++term) {
        if (terms[at(term - 1)].kind == Term::Kind::Heaviside && !to.follows(node, term))
            values.segment<2>(to.unknown(node, term, 0)) = sum_of(field.half_jump(x), of_whole);
    }
}

}  // namespace

Eigen::VectorXd on_parts(const EnrichedMesh& from, const Eigen::VectorXd& values, const EnrichedMesh& to,
                         const std::vector<int>& part_of, Eigen::VectorXd initial) {
    if (part_of.empty()) return initial;
    std::map<int, int> element_of_id;
    for (int e = 0; e < std::ssize(from.elements); ++e) element_of_id[from.element_ids[at(e)]] = e;
    const std::vector<int> piece = piece_of_elements(from);
    for (int e = 0; e < std::ssize(to.elements); ++e) {
        const auto whole = element_of_id.find(part_of[at(e)]);
        if (whole == element_of_id.end()) continue;
        const int p = piece[at(whole->second)];
        const ElementField field(from, whole->second, p >= 0 ? &from.pieces[at(p)] : nullptr);
        for (const int node : to.elements[at(e)]) take_field(field, values, to, node, initial);
    }
    return initial;
}

}  // namespace stria
