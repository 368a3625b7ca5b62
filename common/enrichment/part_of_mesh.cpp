#include "common/enrichment/part_of_mesh.hpp"

#include <algorithm>

#include "common/index.hpp"

namespace stria {

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
