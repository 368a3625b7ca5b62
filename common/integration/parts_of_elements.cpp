#include "common/integration/parts_of_elements.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

#include "common/index.hpp"
#include "common/index_set.hpp"
#include "common/integration/element_field.hpp"

namespace stria {
namespace {

class FieldsAtCorners {
public:
    FieldsAtCorners(const EnrichedMesh& from, const EnrichedMesh& to, const std::vector<int>& part_of)
        : from_(from), to_(to), piece_(piece_of_elements(from)), known_(to.nodes.size()) {
        element_of_id_.assign(from.element_ids.empty() ? 0 : at(std::ranges::max(from.element_ids)) + 1, -1);
        for (int e = 0; e < std::ssize(from.elements); ++e) element_of_id_[at(from.element_ids[at(e)])] = e;
        for (int e = 0; e < std::ssize(to.elements); ++e)
            add(e, part_of[at(e)], [](const FieldAtNode*) { return true; });
        // Where a crack runs along edges, elements beyond it that were not split know the other side.
        for (int e = 0; e < std::ssize(to.elements); ++e)
            if (part_of[at(e)] < 0)
                add(e, to.element_ids[at(e)], [](const FieldAtNode* known) { return known && !known->half_jump(); });
    }

    [[nodiscard]] const std::map<int, FieldAtNode>& all() const { return fields_; }

private:
    template <class Wanted> void add(int element, int id_before, const Wanted& wanted) {
        if (id_before < 0 || id_before >= std::ssize(element_of_id_)) return;
        const int before = element_of_id_[at(id_before)];
        if (before < 0) return;
        std::optional<ElementField> field;
        for (const int node : to_.elements[at(element)]) {
            if (!wanted(known_.contains(node) ? &fields_.at(node) : nullptr)) continue;
            known_.insert(node);
            if (!field) field.emplace(from_, before, from_.piece(piece_[at(before)]));
            fields_.try_emplace(node, to_.nodes[at(node)], to_.terms[at(node)]).first->second.add(*field);
        }
    }

    const EnrichedMesh &from_, &to_;
    std::vector<int> piece_;
    std::vector<int> element_of_id_;  // -1: there is none
    NodeSet known_;                   // whose fields are there
    std::map<int, FieldAtNode> fields_;
};

}  // namespace

Eigen::VectorXd on_parts(const EnrichedMesh& from, const Eigen::VectorXd& values, const EnrichedMesh& to,
                         const std::vector<int>& part_of, Eigen::VectorXd initial) {
    if (part_of.empty()) return initial;
    const FieldsAtCorners fields(from, to, part_of);
    for (const auto& [node, field] : fields.all()) {
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
