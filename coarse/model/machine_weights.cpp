#include "coarse/model/machine_weights.hpp"

#include <algorithm>
#include <set>

namespace stria::coarse {
namespace {

/// What the loads of [load] do work on, over what pulls along the loaded boundary's direction. They balance, so that a
/// motion which nothing holds does not change it.
std::vector<NodalWeight> displacement_of_loads(const Mesh& mesh, const EnrichedMesh& enriched, const Loads& main,
                                               const Eigen::VectorXd& unit_force, double pull) {
    std::set<int> nodes;
    for (const EdgeLoad& load : main.edges)
        for (const int node : edge_nodes(mesh, load.edge)) nodes.insert(node);
    for (const PointForce& load : main.forces) nodes.insert(load.node);
    std::vector<NodalWeight> sum;
    for (const int node : nodes) sum.push_back({node, unit_force.segment<2>(enriched.unknown(node, 0, 0)) / pull});
    return sum;
}

/// Of [load], on the loaded boundary; none unless a pin presses there.
Loads pressure_of_pin(const LoadedBoundary& loaded, const Loads& main) {
    Loads there;
    for (const EdgeLoad& load : main.edges)
        if (std::ranges::any_of(loaded.edges, [&](const BoundaryEdge& edge) {
                return edge.element == load.edge.element && edge.edge == load.edge.edge;
            }))
            there.edges.push_back(load);
    const auto is_pin = [](const EdgeLoad& load) { return load.traction.cosine.has_value(); };
    return std::ranges::any_of(there.edges, is_pin) ? there : Loads{};
}

}  // namespace

Eigen::VectorXd weights_of_displacement(const std::optional<LoadedBoundary>& loaded, const Mesh& mesh,
                                        const EnrichedMesh& enriched, const ForcesOnUnknowns& forces, const Loads& main,
                                        const Eigen::VectorXd& unit_force) {
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(enriched.unknowns);
    if (!loaded || !loaded->has_direction()) return weights;
    std::vector<NodalWeight> sum = mean_displacement(mesh, *loaded);
    const bool bends_only = loaded->resultant.isZero(0.0);
    if (loaded->by_force && !bends_only) {
        if (is_left_free(sum, mesh, main)) {
            sum = displacement_of_loads(mesh, enriched, main, unit_force, loaded->pull);
        } else if (const Loads pin = pressure_of_pin(*loaded, main); !pin.edges.empty()) {
            // The half of a hole on which nothing presses moves otherwise, and the mean of both is no compliance.
            return forces.of(pin) / loaded->resultant.norm();
        }
    }
    for (const auto& [node, weight] : sum) weights.segment<2>(enriched.unknown(node, 0, 0)) += weight;
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
