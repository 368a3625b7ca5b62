#include "coarse/model/forces_on_unknowns.hpp"

#include <algorithm>

#include "common/enrichment/element_basis.hpp"
#include "common/fem/shape_q4.hpp"
#include "common/index.hpp"
#include "common/integration/cut_element.hpp"

namespace stria::coarse {
namespace {

/// Splits an element edge where a crack leaves it, so that each part lies on one side.
std::vector<double> edge_breaks(const CrackPiece* piece, int edge) {
    std::vector<double> breaks{0.0, 1.0};
    if (piece != nullptr) {
        for (const double place : {piece->entry, piece->exit}) {
            if (place > edge && place < edge + 1) breaks.push_back(place - edge);
        }
    }
    std::ranges::sort(breaks);
    return breaks;
}

}  // namespace

ForcesOnUnknowns::ForcesOnUnknowns(const Mesh& mesh, const EnrichedMesh& enriched)
    : mesh_(mesh), enriched_(enriched), piece_of_elements_(piece_of_elements(enriched)) {}

void ForcesOnUnknowns::add(const EdgeLoad& load, Eigen::VectorXd& force) const {
    const CrackPiece* piece = enriched_.piece(piece_of_elements_[at(load.edge.element)]);
    const EdgeGeometry edge = edge_geometry(mesh_, load.edge);
    const ElementBasis basis(enriched_, load.edge.element, piece != nullptr);
    const std::vector<double> breaks = edge_breaks(piece, load.edge.edge);
    BasisValues values;
    for (std::size_t part = 0; part + 1 < breaks.size(); ++part) {
        const double length = breaks[part + 1] - breaks[part];
        int side = 0;
        if (piece != nullptr)
            side = cut_element(basis.corners(), *piece)
                       .side_of(edge.at(breaks[part] + length / 2.0) + 1e-6 * edge.length() * edge.inward_normal());
        for (const auto& [fraction, weight] :
             edge_points(load.traction, edge, breaks[part], breaks[part + 1], basis.singular() ? 16 : 3)) {
            const Vec2 x = edge.at(fraction);
            const Vec2 traction = load.traction.at(x, edge.inward_normal());
            basis.evaluate(map_to_parent(basis.corners(), x), x, side, values);
            for (int f = 0; f < basis.functions(); ++f) {
                for (int c = 0; c < 2; ++c)
                    force[basis.unknowns()[at(2 * f + c)]] += weight * values.value[f] * traction[c];
            }
        }
    }
}

Eigen::VectorXd ForcesOnUnknowns::of(const Loads& loads) const {
    Eigen::VectorXd force = Eigen::VectorXd::Zero(enriched_.unknowns);
    for (const EdgeLoad& load : loads.edges) add(load, force);
    for (const PointForce& load : loads.forces) force.segment<2>(enriched_.unknown(load.node, 0, 0)) += load.force;
    return force;
}

}  // namespace stria::coarse
