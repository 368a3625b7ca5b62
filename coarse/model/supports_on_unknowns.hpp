// Supports and imposed displacements of a case on the unknowns of an enriched mesh.
#pragma once

#include <Eigen/Core>
#include <map>
#include <utility>
#include <vector>

#include "coarse/load/load_factors.hpp"
#include "coarse/model/loads/loads_of_case.hpp"
#include "coarse/model/rigid_motions.hpp"
#include "common/enrichment/enriched_mesh.hpp"
#include "common/index.hpp"
#include "common/index_set.hpp"

namespace stria::coarse {

struct PrescribedUnknown {
    int unknown;                     // of the whole mesh
    double value;                    // mm at the load factor 1
    std::vector<double> in_cases{};  // likewise of the first load cases; the others do not move it

    [[nodiscard]] double in_case(Eigen::Index k) const { return k < std::ssize(in_cases) ? in_cases[at(k)] : 0.0; }
    [[nodiscard]] double under(const LoadFactors& factors) const {
        double sum = factors.main * value;
        for (Eigen::Index k = 0; k < std::ssize(in_cases); ++k) sum += factors.of_case(k) * in_cases[at(k)];
        return sum;
    }
};

/// Those that are prescribed, of so many unknowns.
[[nodiscard]] UnknownSet prescribed_among(int unknowns, const std::vector<PrescribedUnknown>& prescribed);

/// Overwrites the prescribed ones among the unknowns `u` of the whole mesh, mm.
void impose(const std::vector<PrescribedUnknown>& prescribed, const LoadFactors& factors, Eigen::VectorXd& u);

/// What is held or moved per node and component, mm at the load factor 1: by the supports, and by the pins of free
/// motions.
[[nodiscard]] std::map<std::pair<int, int>, double> held_nodes(const Loads& main, const FreeMotions& free_motions);

/// Ascending: supports, imposed displacements, the pins of free motions, and enriched terms that would move a supported
/// edge. Throws CaseError where a support ends at a crack, on the face to which the node there does not belong.
[[nodiscard]] std::vector<PrescribedUnknown> prescribed_unknowns(const Mesh& mesh, const EnrichedMesh& enriched,
                                                                 const LoadsOfCase& loads,
                                                                 const FreeMotions& free_motions);

}  // namespace stria::coarse
