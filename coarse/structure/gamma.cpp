#include "coarse/structure/gamma.hpp"

#include "common/enrichment/element_basis.hpp"
#include "common/index.hpp"
#include "common/integration/plain_operator.hpp"

namespace stria::coarse {

std::vector<int> gamma_of(const Scene& scene, const std::vector<char>& in_zone) {
    const EnrichedMesh& mesh = scene.enriched;
    const auto unknowns = at(mesh.unknowns);
    std::vector<char> coarse(unknowns, 0), fine = coarse;
    const auto mark = [](const auto& seen, std::vector<char>& side) {
        for (const int unknown : seen) side[at(unknown)] = 1;
    };
    const std::vector<int> piece = piece_of_elements(mesh);
    for (int e = 0; e < std::ssize(in_zone); ++e) {
        const auto element = at(e);
        std::vector<char>& side = in_zone[element] != 0 ? fine : coarse;
        if (is_plain(mesh, e) && piece[element] < 0)
            mark(plain_unknowns(mesh, e), side);
        else
            mark(ElementBasis(mesh, e, piece[element] >= 0).unknowns(), side);
    }
    for (const PrescribedUnknown& p : scene.prescribed) coarse[at(p.unknown)] = 1;
    std::vector<int> gamma;
    for (std::size_t i = 0; i < unknowns; ++i)
        if (fine[i] != 0 && (coarse[i] != 0 || scene.observed[i] != 0)) gamma.push_back(static_cast<int>(i));
    return gamma;
}

}  // namespace stria::coarse
