#include "coarse/structure/gamma.hpp"

#include <algorithm>

#include "common/enrichment/element_basis.hpp"
#include "common/index.hpp"
#include "common/integration/plain_operator.hpp"

namespace stria::coarse {

namespace {

/// Elements with nodes whose unknowns elements of the zone see, or with nodes that have more than their own standard
/// ones: others share nothing with the zone.
ElementSet elements_that_may_share(const BodyMesh& body, const EnrichedMesh& mesh, const ElementSet& in_zone) {
    NodeSet nodes(mesh.nodes.size());
    for (const int node : mesh.terms.nodes()) nodes.insert(node);
    for (const int e : in_zone.members())
        for (const int node : mesh.elements[at(e)]) nodes.insert(node);
    for (const TiedNode& tie : mesh.tied)
        for (const int node : {tie.node, tie.ends[0], tie.ends[1]}) nodes.insert(node);
    ElementSet elements(in_zone.size());
    for (const int node : nodes.members())
        for (const int e : body.around()[at(node)]) elements.insert(e);
    return elements;
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
    const auto look_at = [&](int e) {
        UnknownSet& side = in_zone.contains(e) ? fine : coarse;
        if (is_plain(mesh, e) && piece[at(e)] < 0)
            mark(plain_unknowns(mesh, e), side);
        else
            mark(ElementBasis(mesh, e, piece[at(e)] >= 0).unknowns(), side);
    };
    for (int e = 0; e < in_zone.size() && !moves; ++e) look_at(e);
    for (const int e : elements_that_may_share(scene.mesh, mesh, in_zone).members()) look_at(e);
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
