// A case as mechanics for one position of the cracks: mesh, enrichment, loads and supports on unknowns.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "coarse/model/loads/loads_of_case.hpp"
#include "coarse/model/rigid_motions.hpp"
#include "coarse/model/supports_on_unknowns.hpp"
#include "common/case/case.hpp"
#include "common/enrichment/enriched_mesh.hpp"
#include "common/fem/body_mesh.hpp"
#include "common/index_set.hpp"
#include "common/integration/element_operator.hpp"
#include "common/material/materials.hpp"

namespace stria::coarse {

struct Scene {
    Case input;
    BodyMesh mesh;
    Materials materials;
    LoadsOfCase loads;
    FreeMotions free_motions;
    EnrichedMesh enriched;
    std::shared_ptr<const EnrichedMesh> nominal;  // of the nominal body; null: it has the same functions
    bool is_nominal = false;                      // made by nominal_scene()
    Eigen::VectorXd unit_force;                   // on all unknowns at the load factor 1, N/mm
    std::vector<Eigen::VectorXd> case_forces;     // likewise, one per load case

    /// Supports, imposed displacements and the pins of free motions, ascending.
    std::vector<PrescribedUnknown> prescribed;

    /// Standard unknowns of the nodes where loads are applied or reported.
    UnknownSet observed;

    // What a testing machine reads (machine_weights.hpp).
    Eigen::VectorXd displacement_weights;  // of the loaded boundary, on all unknowns: weights_of_displacement()
    Eigen::VectorXd pull;                  // likewise: weights_of_reactions()

    /// The material of an element, or at a tip.
    [[nodiscard]] const Elasticity& elastic(int element) const { return materials.elastic(mesh->material_of(element)); }
    [[nodiscard]] const Elasticity& elastic(const Tip& tip) const { return materials.elastic(tip.material); }
    [[nodiscard]] const MandelMatrix& stiffness(int element) const {
        return materials.stiffness(mesh->material_of(element));
    }
    [[nodiscard]] const InitialStress& initial_stress() const { return materials.initial_stress(); }
    /// In an element, MPa.
    [[nodiscard]] Mandel initial_stress(int element, const Vec2& x) const {
        return initial_stress().at(x, mesh->material_of(element));
    }
    /// What of its stress counts against the weakest yield stress (materials.hpp): nothing in the insert of a pin.
    [[nodiscard]] double stress_weight(int element) const {
        return mesh->in_insert(element) ? 0.0 : materials.stress_weight(mesh->material_of(element));
    }
    /// At each tip, MPa; infinite where it never yields.
    [[nodiscard]] std::vector<double> yield_stress_at_tips() const {
        std::vector<double> stresses;
        for (const Tip& tip : enriched.tips) stresses.push_back(materials.yield_stress(tip.material));
        return stresses;
    }
    /// Where nothing flows nothing locks: there a mean would only let functions of a tip relax the elements about it.
    [[nodiscard]] MeanDilatation mean_dilatation(int element) const;
};

/// Enriches and resolves a case on a mesh. Throws CaseError. `refined`: tips need room there (require_room); 0: they
/// have been looked at. That is asked before loads are resolved, of which there may be very many.
Scene make_scene(const Case& input, BodyMesh mesh, int refined = 0);

/// The same scene, with the tip functions of `before` kept as unknowns where the tip has moved on (growth.retain), but
/// for those of a tip that is nearly where it was.
Scene with_functions_left(Scene scene, const EnrichedMesh& before);

/// The nominal body of a scene, where it has functions of its own; else null.
std::unique_ptr<Scene> nominal_scene(const Scene& scene);

/// Functions of the nominal body of a scene.
const EnrichedMesh& nominal_functions(const Scene& scene);

/// Loads and supports on the unknowns of an enriched mesh: enriched terms included, the jump held on supported edges.
void put_loads_on_unknowns(Scene& scene);

}  // namespace stria::coarse
