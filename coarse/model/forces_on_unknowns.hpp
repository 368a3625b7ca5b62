// Loads of a case as forces on the unknowns of an enriched mesh, enriched terms included.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "coarse/model/loads/boundary_conditions.hpp"
#include "common/enrichment/enriched_mesh.hpp"

namespace stria::coarse {

/// The mesh and its enrichment must outlive it.
class ForcesOnUnknowns {
public:
    ForcesOnUnknowns(const Mesh& mesh, const EnrichedMesh& enriched);

    /// On all unknowns, N/mm: what does the work of the loads, whatever moves.
    [[nodiscard]] Eigen::VectorXd of(const Loads& loads) const;

private:
    void add(const EdgeLoad& load, Eigen::VectorXd& force) const;

    const Mesh& mesh_;
    const EnrichedMesh& enriched_;
    std::vector<int> piece_of_elements_;
};

}  // namespace stria::coarse
