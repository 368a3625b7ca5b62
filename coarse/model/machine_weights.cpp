#include "coarse/model/machine_weights.hpp"

#include <algorithm>

#include "common/index.hpp"

namespace stria::coarse {
namespace {

/// Where the displacement is taken as if these forces did work on it.
std::vector<AppliedForce> forces_that_read(const std::vector<NodalWeight>& mean, const Mesh& mesh) {
    std::vector<AppliedForce> forces;
    for (const auto& [node, weight] : mean) forces.push_back({mesh.nodes[at(node)], weight});
    return forces;
}

/// Forces over their sum, as weights of nodal displacements. What a jump adds between the nodes beside a mouth is a
/// zone's own, and no equilibrium but that of one matrix could weigh it.
Eigen::VectorXd without_jumps(const EnrichedMesh& enriched, Eigen::VectorXd forces, double sum) {
    for (Eigen::Index unknown = 0; unknown < forces.size(); ++unknown)
        if (forces[unknown] != 0.0)
            forces[unknown] = enriched.is_standard(static_cast<int>(unknown)) ? forces[unknown] / sum : 0.0;
    return forces;
}

}  // namespace

// Half of load times displacement is the work then, however uneven the loads, and dC/da of the two the energy release
// rate. Forces that balance all over do no work on a motion which nothing holds.
Eigen::VectorXd weights_of_displacement(const std::optional<LoadedBoundary>& loaded, const Mesh& mesh,
                                        const EnrichedMesh& enriched, const ForcesOnUnknowns& forces,
                                        const LoadsOfCase& loads) {
    if (!loaded || !loaded->has_direction()) return Eigen::VectorXd::Zero(enriched.unknowns);
    const std::vector<NodalWeight> mean = nodal_weights_of_mean(mesh, *loaded);
    if (loaded->by_force && loaded->force > 0.0) {
        const bool is_pin = mesh.pins.contains(loaded->name);
        const std::vector<AppliedForce> there =
            is_pin ? forces_that_read(mean, mesh) : applied_forces(mesh, loaded->acting);
        if (is_left_free(there, mesh, loads.main))
            return without_jumps(enriched, forces.of(loads.of(loaded->load_case)), loaded->pull);
        if (!is_pin) return without_jumps(enriched, forces.of(loaded->acting), loaded->force);
    }
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(enriched.unknowns);
    for (const auto& [node, weight] : mean) weights.segment<2>(enriched.unknown(node, 0, 0)) += weight;
    return weights;
}

Eigen::VectorXd weights_of_reactions(const std::optional<LoadedBoundary>& loaded, const EnrichedMesh& enriched,
                                     const std::vector<PrescribedUnknown>& prescribed) {
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(std::ssize(prescribed));
    if (!loaded || loaded->by_force) return weights;
    for (const int node : loaded->nodes) {
        for (int c = 0; c < 2; ++c) {
            const int unknown = enriched.unknown(node, 0, c);
            const auto found = std::ranges::lower_bound(prescribed, unknown, {}, &PrescribedUnknown::unknown);
            if (found != prescribed.end() && found->unknown == unknown)
                weights[found - prescribed.begin()] = loaded->direction[c];
        }
    }
    return weights;
}

}  // namespace stria::coarse
