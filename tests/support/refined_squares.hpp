// Squares with elements of several sizes, and cracks whose tips lie where small ones end.
#pragma once

#include "coarse/model/mesh_refinement.hpp"
#include "common/error.hpp"
#include "tests/support/cracked_mesh.hpp"

namespace stria::test {

inline coarse::RefinedMesh refined(Mesh mesh, const std::vector<coarse::RefinedDisk>& disks,
                                   const ElementSet& never = {}) {
    return coarse::refine(BodyMesh(std::move(mesh)), disks, never);
}

inline Mesh refined_square(int n, const Vec2& centre, int levels, double radius = 0.3, double growth = 0.2) {
    return refined(square_mesh(n), {{centre, centre, radius, levels, growth}}).mesh;
}

/// Cracks whose tips lie where small elements end, as those of a crack that has grown into metal that has flowed.
struct AtTheRim {
    Mesh mesh;
    Vec2 tip, along;
    std::vector<Vec2> crack;

    explicit AtTheRim(int k, bool bent = false) {
        const Vec2 centre(0.5 + 0.1 * std::sin(5.0 * k), 0.5 + 0.1 * std::cos(9.0 * k));
        mesh = refined(k % 3 == 0 ? distorted(square_mesh(6), 0.02) : square_mesh(6), {{centre, centre, 0.15, 3, 0.2}})
                   .mesh;
        tip = centre + (0.05 + 0.004 * k) * Vec2(std::cos(2.3 * k), std::sin(2.3 * k));
        along = {std::cos(0.7 * k), std::sin(0.7 * k)};
        const Vec2 aside(-along.y(), along.x());
        crack = {tip - 2.0 * along, tip};
        if (bent) crack.insert(crack.begin() + 1, tip - 0.1 * along + 0.05 * aside);
    }
};

inline bool has_tip_function_that_hangs(const EnrichedMesh& enriched) {
    return std::ranges::any_of(enriched.tied, [&](const TiedNode& tied) {
        const std::vector<Term>& terms = enriched.terms[at(tied.node)];
        return std::ranges::find(terms, Term::Kind::Tip, &Term::kind) != terms.end();
    });
}

}  // namespace stria::test
