// Brings a scene to equilibrium at one load in process: the shortest way from a Scene to what its tips and faces
// report.
#pragma once

#include "coarse/equilibrium/condensed/condensed_equilibrium.hpp"
#include "coarse/equilibrium/newton.hpp"
#include "coarse/fracture/fracture_parameters.hpp"
#include "coarse/zone/zone_selection.hpp"
#include "fine/zone/fine_model.hpp"

namespace stria::test {

struct Equilibrated {
    coarse::NewtonReport newton;
    coupling::StepReport zone;
    Eigen::VectorXd displacement;  // of the whole mesh, zero inside the zone
    std::vector<coarse::TipResult> tips;
};

inline Equilibrated equilibrate(const coarse::Scene& scene, double load_factor) {
    const std::vector<double> no_K(scene.enriched.tips.size(), 0.0);
    const coarse::Structure structure(scene, coarse::select_zone(scene, no_K));
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(scene.enriched.unknowns);
    fine::FineModel fine(scene.input);
    fine.set_patch(coarse::make_patch(scene, structure.in_zone(), structure.gamma(), zero));
    coarse::CondensedEquilibrium equilibrium(structure, &fine, scene.input, zero, 0.0);
    Equilibrated result;
    result.newton = coarse::find_equilibrium(equilibrium, {Control::Load, load_factor}, 0.0, {scene.input.solver});
    result.displacement = equilibrium.structure_displacement();
    result.zone = equilibrium.commit({});
    result.tips = coarse::fracture_parameters(structure, result.displacement, result.zone);
    return result;
}

}  // namespace stria::test
