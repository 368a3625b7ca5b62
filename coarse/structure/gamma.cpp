#include "coarse/structure/gamma.hpp"

#include <algorithm>

#include "common/enrichment/element_basis.hpp"
#include "common/index.hpp"
#include "common/integration/plain_operator.hpp"

namespace stria::coarse {

namespace {

/// Nodes whose unknowns elements of the zone see, and all that see more than their own standard ones: elements without
/// such a node share nothing with the zone.
NodeSet nodes_that_may_share(const EnrichedMesh& mesh, const ElementSet& in_zone) {
    NodeSet nodes(mesh.nodes.size());
    for (int node = 0; node < nodes.size(); ++node)
        if (!mesh.terms[at(node)].empty()) nodes.insert(node);
    for (const int e : in_zone.members())
        for (const int node : mesh.elements[at(e)]) nodes.insert(node);
    for (const TiedNode& tie : mesh.tied)
        for (const int node : {tie.node, tie.ends[0], tie.ends[1]}) nodes.insert(node);
    return nodes;
}

}  // namespace

std::vector<int> gamma_of(const Scene& scene, const ElementSet& in_zone) {
    if (in_zone.none()) return {};
    const EnrichedMesh& mesh = scene.enriched;
    UnknownSet coarse(mesh.unknowns), fine = coarse;
    const UnknownSet prescribed = prescribed_among(mesh.unknowns, scene.prescribed);
    bool moves = false;  // an unknown of the structure, or one that is reported
    const auto mark = [&](const auto& seen, UnknownSet& side) {
        for (const int unknown : seen) {
            side.insert(unknown);
            moves = moves || (&side == &coarse && !prescribed.contains(unknown));
        }
    };
    for (int i = 0; i < mesh.unknowns && !moves; ++i) moves = scene.observed.contains(i) && !prescribed.contains(i);
    const std::vector<int> piece = piece_of_elements(mesh);
    const NodeSet may_share = nodes_that_may_share(mesh, in_zone);
    for (int e = 0; e < in_zone.size(); ++e) {
        if (moves && !contains_any(may_share, mesh.elements[at(e)])) continue;
        UnknownSet& side = in_zone.contains(e) ? fine : coarse;
        if (is_plain(mesh, e) && piece[at(e)] < 0)
            mark(plain_unknowns(mesh, e), side);
        else
            mark(ElementBasis(mesh, e, piece[at(e)] >= 0).unknowns(), side);
    }
    UnknownSet of_zone = fine;
    for (const PrescribedUnknown& p : scene.prescribed) {
        of_zone.erase(p.unknown);
        coarse.insert(p.unknown);
    }
    // Where the zone is all of the body and all that is held or reported, the structure keeps an unknown nevertheless.
    if (!moves && !of_zone.none()) coarse.insert(of_zone.members().front());
    std::vector<int> gamma;
    for (int i = 0; i < mesh.unknowns; ++i)
        if (fine.contains(i) && (coarse.contains(i) || scene.observed.contains(i))) gamma.push_back(i);
    return gamma;
}

}  // namespace stria::coarse
