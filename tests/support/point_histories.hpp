// Points of a small cracked plate whose material yields, for tests of what they remember.
#pragma once

#include "fine/bulk/bulk_elements.hpp"
#include "fine/bulk/points/point_history.hpp"
#include "fine/material/catalogue/material_catalogue.hpp"
#include "tests/support/plates.hpp"

namespace stria::test {

/// Cut, tip and plain elements.
struct PlatePoints {
    Case input = plate_case({{0.0, 2.4}, {2.3, 2.6}});
    EnrichedMesh mesh = plate_mesh(5, 5, input);
    Elasticity elastic = elasticity_of(input.material, input.model.plane);
    fine::BulkElements elements{mesh, Materials(input), IntegrationRule{.subcells = 2, .tip_points = 4},
                                [](int, const CrackPiece*) { return std::nullopt; }};

    [[nodiscard]] fine::PointHistory history() const {
        return {fine::make_material_laws(Materials(input)), mesh.material, elements.operators()};
    }

    /// Every node moves along y in proportion to its height: a uniform strain.
    [[nodiscard]] Eigen::VectorXd stretched(double strain) const {
        Eigen::VectorXd u = Eigen::VectorXd::Zero(mesh.unknowns);
        for (int n = 0; n < std::ssize(mesh.nodes); ++n) u[mesh.unknown(n, 0, 1)] = strain * mesh.nodes[at(n)].y();
        return u;
    }
};

}  // namespace stria::test
