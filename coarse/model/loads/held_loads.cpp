#include "coarse/model/loads/held_loads.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "coarse/model/loads/boundary_conditions.hpp"
#include "common/error.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {

using Held = std::set<std::pair<int, int>>;  // nodes and components

Held held_places(const Mesh& mesh, const std::vector<BoundarySection>& sections) {
    Held held;
    for (std::size_t k = 0; k < sections.size(); ++k)
        for (int component = 0; component < 2; ++component) {
            if (!sections[k].displacement[at(component)]) continue;
            for (const int node : place_of(mesh, sections[k], key_of(k)).nodes) held.insert({node, component});
        }
    return held;
}

/// Whether a force is felt at one of these nodes; one without size is not.
bool is_felt(const Vec2& force, const auto& nodes, const Held& held) {
    constexpr double rounding = 1e-9;
    for (int component = 0; component < 2; ++component) {
        if (std::abs(force[component]) <= rounding * force.norm()) continue;
        if (std::ranges::any_of(nodes, [&](int node) { return !held.contains({node, component}); })) return true;
    }
    return false;
}

bool is_felt(const Mesh& mesh, const Loads& loads, const Held& held) {
    const auto edge_feels = [&](const EdgeLoad& load) {
        const Loads alone{.edges = {load}, .forces = {}, .displacements = {}, .points = {}};
        return std::ranges::any_of(applied_forces(mesh, alone), [&](const AppliedForce& applied) {
            return is_felt(applied.force, edge_nodes(mesh, load.edge), held);
        });
    };
    return std::ranges::any_of(loads.edges, edge_feels) ||
           std::ranges::any_of(loads.forces, [&](const PointForce& force) {
               return is_felt(force.force, std::array{force.node}, held);
           });
}

}  // namespace

void require_free_places(const Mesh& mesh, const std::vector<BoundarySection>& sections) {
    const Held held = held_places(mesh, sections);
    if (held.empty()) return;
    for (std::size_t k = 0; k < sections.size(); ++k) {
        const Loads loads = resolve_boundaries(mesh, {sections[k]});
        if ((!loads.edges.empty() || !loads.forces.empty()) && !is_felt(mesh, loads, held))
            throw CaseError(key_of(k) +
                            ": its load acts where a displacement is given along it, so the support bears all of it "
                            "and the body feels none; give one of the two");
    }
}

}  // namespace stria::coarse
