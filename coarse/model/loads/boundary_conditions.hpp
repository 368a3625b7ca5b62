// Supports and loads of a case as plain data on the mesh, per unit load factor and mm of thickness; they know nothing
// of enrichment: whoever assembles them adds its terms.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "coarse/model/loads/places.hpp"
#include "coarse/model/loads/traction.hpp"
#include "common/case/case.hpp"
#include "common/fem/mesh.hpp"
#include "common/geometry/vec2.hpp"

namespace stria::coarse {

struct EdgeLoad {
    BoundaryEdge edge;
    Traction traction;
};

struct PointForce {
    int node;
    Vec2 force;  // N per mm of thickness
};

struct PrescribedDisplacement {
    int node;
    int component;
    double value;  // mm
};

struct Loads {
    std::vector<EdgeLoad> edges;
    std::vector<PointForce> forces;
    std::vector<PrescribedDisplacement> displacements;  // each node and component once, in ascending order
    std::vector<int> points;  // nodes that bear a force or are held by themselves: stress is singular there
};

/// Resolves names and points. Throws CaseError: an unknown name (the available ones are listed), a point without a node
/// (the nearest is named), a load that its place cannot carry, two different displacements of one node.
/// `wanted`: which sections count.
Loads resolve_boundaries(
    const Mesh& mesh, const std::vector<BoundarySection>& sections,
    const std::function<bool(const BoundarySection&)>& wanted = [](const BoundarySection&) { return true; });

EdgeGeometry edge_geometry(const Mesh& mesh, const BoundaryEdge& edge);

/// A force that acts at a point: what an edge load is for a balance of forces and moments.
struct AppliedForce {
    Vec2 x;      // mm
    Vec2 force;  // N per mm of thickness
};

/// Edge loads (at points that integrate them and their moments) and point forces alike.
std::vector<AppliedForce> applied_forces(const Mesh& mesh, const Loads& loads);

/// Where `load` and `displacement` of the history are taken (docs/method.md, section 9).
struct LoadedBoundary {
    std::string name;                 // of the section: an edge's or pin's name, or "point"
    std::vector<BoundaryEdge> edges;  // empty: a point or pin
    std::vector<int> nodes;           // ascending
    /// Unit: of the prescribed displacement, else of the resultant, else outwards. Zero where nothing tells one: a
    /// pressure all around a hole.
    Vec2 direction = Vec2::Zero();
    Vec2 resultant = Vec2::Zero();  // of all loads of [load] there per unit load factor, N/mm
    bool by_force = true;           // forces load it; or it is moved
    /// Whose loads tell the displacement where they are forces: [load], or the load case of this number.
    std::optional<std::size_t> load_case = {};
    Loads acting = {};                // those of it that act there
    double force = 0.0;               // their resultant, N/mm; zero where they balance
    double pull = 0.0;                // of it along the direction, on this boundary and others, N/mm
    std::vector<Vec2> in_cases = {};  // what each load case adds to the resultant

    [[nodiscard]] bool has_direction() const { return !direction.isZero(0.0); }
};

struct NodalWeight {
    int node;
    Vec2 weight;
};

/// Mean displacement of a loaded boundary along its direction: the sum of weight . u over the nodes listed, which may
/// come more than once. Of a pin: what its force does work on, relative to the opposite pin, as in a machine that holds
/// that one.
std::vector<NodalWeight> nodal_weights_of_mean(const Mesh& mesh, const LoadedBoundary& boundary);

}  // namespace stria::coarse
