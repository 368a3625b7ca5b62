#include "coarse/structure/gamma.hpp"

#include "common/enrichment/element_basis.hpp"
#include "common/index.hpp"
#include "common/integration/plain_operator.hpp"

namespace stria::coarse {

std::vector<int> gamma_of(const Scene& scene, const ElementSet& in_zone) {
    const EnrichedMesh& mesh = scene.enriched;
    UnknownSet coarse(mesh.unknowns), fine = coarse;
    const auto mark = [](const auto& seen, UnknownSet& side) {
        for (const int unknown : seen) side.insert(unknown);
    };
    const std::vector<int> piece = piece_of_elements(mesh);
    for (int e = 0; e < in_zone.size(); ++e) {
        UnknownSet& side = in_zone.contains(e) ? fine : coarse;
        if (is_plain(mesh, e) && piece[at(e)] < 0)
            mark(plain_unknowns(mesh, e), side);
        else
            mark(ElementBasis(mesh, e, piece[at(e)] >= 0).unknowns(), side);
    }
    UnknownSet movable = coarse, of_zone = fine;
    movable |= scene.observed;
    for (const PrescribedUnknown& p : scene.prescribed) {
        movable.erase(p.unknown);
        of_zone.erase(p.unknown);
        coarse.insert(p.unknown);
    }
    // Where the zone is all of the body and all that is held or reported, the structure keeps an unknown nevertheless.
    if (movable.none() && !of_zone.none()) coarse.insert(of_zone.members().front());
    std::vector<int> gamma;
    for (int i = 0; i < mesh.unknowns; ++i)
        if (fine.contains(i) && (coarse.contains(i) || scene.observed.contains(i))) gamma.push_back(i);
    return gamma;
}

}  // namespace stria::coarse
