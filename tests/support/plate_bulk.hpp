// The bulk of a small plate as if it were the zone.
#pragma once

#include "fine/bulk/bulk.hpp"
#include "fine/material/catalogue/material_catalogue.hpp"
#include "tests/support/plates.hpp"

namespace stria::test {

inline fine::Bulk make_bulk(const EnrichedMesh& mesh, const Case& input, const Eigen::VectorXd& displacement,
                            fine::Bulk* old = nullptr) {
    return {mesh,
            Materials(input),
            fine::make_material_laws(Materials(input)),
            IntegrationRule{.subcells = 2, .tip_points = 4},
            old,
            displacement};
}

inline fine::Bulk make_bulk(const EnrichedMesh& mesh, const Case& input) {
    return make_bulk(mesh, input, Eigen::VectorXd::Zero(mesh.unknowns));
}

}  // namespace stria::test
