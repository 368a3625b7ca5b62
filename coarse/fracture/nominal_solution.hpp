// The nominal solution: the linear elastic body with traction-free cracks at the load factor 1, without an initial
// stress. Its K_I is K_1(a). What the initial stress does alone is K_initial(a).
#pragma once

#include <memory>
#include <vector>

#include "coarse/fracture/fracture_parameters.hpp"
#include "coarse/fracture/ring_forms.hpp"
#include "coarse/load/load_scale.hpp"
#include "coarse/structure/structure.hpp"

namespace stria::coarse {

/// What the body does, wherever on it the tips are said to be. Displacements are those of the whole mesh, mm.
struct NominalFields {
    Eigen::VectorXd unit, initial;          // at the load factor 1; of the initial stress alone, empty: there is none
    std::vector<Eigen::VectorXd> of_cases;  // of each load case alone
    double mean_displacement = 0.0;         // of the loaded boundary, mm
    Eigen::VectorXd mean_of_cases;          // likewise, of each load case alone
    double mean_of_initial = 0.0;           // likewise, of the initial stress alone
};

struct NominalSolution {
    std::unique_ptr<const Scene> scene;    // where the nominal body has functions of its own
    std::unique_ptr<Structure> structure;  // of the whole body: no element is in a zone
    NominalFields fields;
    std::vector<TipResult> tips;   // one per tip
    std::vector<RingForms> rings;  // likewise, of all near elements: for a structure beside a zone on this scene
};

/// `body`: without a zone.
[[nodiscard]] NominalSolution solve_nominal(std::unique_ptr<Structure> body);

/// Finds the displacement of near elements alone, which is all that K needs, and K and T alone (nominal_K()). Costs
/// less. `for_K`: elements of whose rings nobody asks for more, as those that will be in the zone; of size zero: none.
[[nodiscard]] NominalSolution solve_nominal_near(std::unique_ptr<Structure> body, const ElementSet& for_K = {});

/// Condenses the whole body for it. `scene` must outlive the solution.
[[nodiscard]] NominalSolution solve_nominal(const Scene& scene);

[[nodiscard]] std::vector<double> stress_intensities(const std::vector<TipResult>& tips);  // K_I, one per tip

/// What scales a load history. `displacement`: of the same body as K.
[[nodiscard]] UnitDisplacement unit_displacement(const NominalFields& fields);
[[nodiscard]] UnitResponse unit_response(const Scene& scene, const std::vector<TipResult>& tips,
                                         const UnitDisplacement& displacement);
[[nodiscard]] UnitResponse unit_response(const NominalSolution& nominal);

}  // namespace stria::coarse
