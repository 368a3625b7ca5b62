// One equilibrium without the programs: a case, its scene, structure and zone in this process; prints K and J per tip.
#include <fmt/format.h>

#include "coarse/equilibrium/condensed/condensed_equilibrium.hpp"
#include "coarse/equilibrium/newton.hpp"
#include "coarse/fracture/nominal_solution.hpp"
#include "coarse/zone/refined_scene.hpp"
#include "coarse/zone/zone_selection.hpp"
#include "common/case/schema/case_file.hpp"
#include "common/linear/blas.hpp"
#include "fine/zone/fine_model.hpp"

int main(int count, char** words) {
    using namespace stria;
    if (count != 3) return fmt::print(stderr, "one_increment CASE.toml LOAD_FACTOR\n"), 2;
    const double load_factor = std::stod(words[2]);
    use_one_thread();
    const Case input = read_case(words[1]);
    const coarse::Scene scene = coarse::refined_scene(input);

    // The elastic body says how large the zone of eq. (3) has to be.
    std::vector<double> K;  // one per tip, MPa sqrt(mm)
    for (const coarse::TipResult& tip : coarse::solve_nominal(scene).tips) K.push_back(load_factor * tip.K_I);

    // Structure and zone share the displacement of Gamma, the boundary between them.
    const coarse::Structure structure(scene, coarse::select_zone(scene, K));
    const Eigen::VectorXd start = Eigen::VectorXd::Zero(scene.enriched.unknowns);
    fine::FineModel zone(input);
    zone.set_patch(coarse::make_patch(scene, structure.in_zone(), structure.gamma(), start));
    coarse::CondensedEquilibrium equilibrium(structure, &zone, input, start, 0.0);
    const auto newton = coarse::find_equilibrium(equilibrium, {Control::Load, load_factor}, {}, {input.solver});
    if (!newton.converged) return fmt::print(stderr, "{}\n{}", newton.failure, newton.table()), 3;

    const Eigen::VectorXd u = equilibrium.structure_displacement();
    const coupling::StepReport report = equilibrium.commit({});
    fmt::print("{} iterations\n", newton.count());
    for (const auto& tip : coarse::fracture_parameters(structure, u, report))
        fmt::print("a = {:.6g} mm, K_I = {:.6g} MPa sqrt(mm), J = {:.6g} N/mm\n", tip.a, tip.K_I, tip.J);
}
