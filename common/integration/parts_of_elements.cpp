#include "common/integration/parts_of_elements.hpp"

#include <map>

#include "common/index.hpp"
#include "common/integration/element_field.hpp"

namespace stria {
namespace {

/// Of each corner of parts, what the wholes say there.
std::map<int, FieldAtNode> fields_at_corners(const EnrichedMesh& from, const EnrichedMesh& to,
                                             const std::vector<int>& part_of) {
    std::map<int, int> element_of_id;
    for (int e = 0; e < std::ssize(from.elements); ++e) element_of_id[from.element_ids[at(e)]] = e;
    const std::vector<int> piece = piece_of_elements(from);
    std::map<int, FieldAtNode> fields;
    for (int e = 0; e < std::ssize(to.elements); ++e) {
        const auto whole = element_of_id.find(part_of[at(e)]);
        if (whole == element_of_id.end()) continue;
        const int p = piece[at(whole->second)];
        const ElementField field(from, whole->second, p >= 0 ? &from.pieces[at(p)] : nullptr);
        for (const int node : to.elements[at(e)])
            fields.try_emplace(node, to.nodes[at(node)], to.terms[at(node)]).first->second.add(field);
    }
    return fields;
}

}  // namespace

Eigen::VectorXd on_parts(const EnrichedMesh& from, const Eigen::VectorXd& values, const EnrichedMesh& to,
                         const std::vector<int>& part_of, Eigen::VectorXd initial) {
    if (part_of.empty()) return initial;
    for (const auto& [node, field] : fields_at_corners(from, to, part_of)) {
        if (!to.follows(node, 0) && field.standard())
            initial.segment<2>(to.unknown(node, 0, 0)) = sum_of(*field.standard(), values);
        const std::optional<Shares> jump = field.half_jump();
        const auto& terms = to.terms[at(node)];
        for (int term = 1; term <= std::ssize(terms) && jump; ++term) {
            if (terms[at(term - 1)].kind == Term::Kind::Heaviside && !to.follows(node, term))
                initial.segment<2>(to.unknown(node, term, 0)) = sum_of(*jump, values);
        }
    }
    return initial;
}

}  // namespace stria
