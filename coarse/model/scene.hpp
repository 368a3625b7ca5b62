// A case turned into mechanics: mesh, enrichment, loads and supports on unknowns, for one position of the cracks.
#pragma once

#include <string>
#include <vector>

#include "coarse/model/boundary_conditions.hpp"
#include "coarse/model/rigid_motions.hpp"
#include "common/enrichment/enriched_mesh.hpp"
#include "common/io/case.hpp"
#include "common/material/elasticity.hpp"

namespace stria::coarse {

struct PrescribedUnknown {
    int unknown;
    double value;  // mm per unit load factor
};

struct Scene {
    Case input;
    Mesh mesh;
    Elasticity elastic;
    Loads loads;
    FreeMotions free_motions;
    EnrichedMesh enriched;
    Eigen::VectorXd unit_force;  // on all unknowns, per unit load factor, N/mm
    std::vector<PrescribedUnknown>
        prescribed;                     // ascending; supports, imposed displacements, and the pins of free motions
    std::vector<char> observed;         // per unknown: standard unknown of a node where loads are applied and reported
    Eigen::VectorXd mean_displacement;  // weights on all unknowns: of the loaded boundary, along its direction; zero
                                        // where there is none
    Eigen::VectorXd pull;  // of each prescribed unknown: what its reaction adds to the load reported; zero where forces
                           // load the boundary reported
};

/// Meshes, refines, enriches and resolves a case. Throws CaseError.
Scene make_scene(const Case& input);

/// The same on a given mesh.
Scene make_scene(const Case& input, Mesh mesh);

/// The same scene with the functions of the tips that `before` had and it has not as unknowns still (growth.retain).
Scene with_functions_left(Scene scene, const EnrichedMesh& before);

/// Loads and supports on the unknowns of an enriched mesh: enriched terms included, the jump held on supported edges.
void put_loads_on_unknowns(Scene& scene);

}  // namespace stria::coarse
