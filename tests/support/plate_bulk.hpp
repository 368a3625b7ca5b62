// The bulk of a small plate as if it were the zone.
#pragma once

#include "fine/bulk/bulk.hpp"
#include "tests/support/plates.hpp"

namespace stria::test {

inline fine::Bulk make_bulk(const EnrichedMesh& mesh, const Case& input, const Eigen::VectorXd& displacement,
                            const fine::Bulk* old = nullptr) {
    return {mesh,
            fine::make_material_law(input.material, input.model.plane),
            elasticity_of(input.material, input.model.plane),
            IntegrationRule{.subcells = 2, .tip_points = 4},
            old,
            displacement};
}

inline fine::Bulk make_bulk(const EnrichedMesh& mesh, const Case& input) {
    return make_bulk(mesh, input, Eigen::VectorXd::Zero(mesh.unknowns));
}

}  // namespace stria::test
