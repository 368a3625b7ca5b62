#include "coarse/equilibrium/work_balance.hpp"

#include "common/index.hpp"
#include "common/integration/element_operator.hpp"

namespace stria::coarse {
namespace {

Eigen::VectorXd on_free_places(const Structure& structure, const Eigen::VectorXd& u) {
    return structure.on_free_places(gather(u, structure.gamma()));
}

/// Of the main load, and of each load case.
struct LoadDisplacements {
    double main;
    Eigen::VectorXd cases;
};

LoadDisplacements load_displacements(const Structure& structure, const Eigen::VectorXd& u, const LoadFactors& factors) {
    const Eigen::VectorXd free = on_free_places(structure, u);
    const CondensedLoads& loads = structure.loads();
    LoadDisplacements all{loads.work().displacement.at(free, factors),
                          Eigen::VectorXd(std::ssize(loads.work_of_cases()))};
    for (Eigen::Index k = 0; k < all.cases.size(); ++k)
        all.cases[k] = loads.work_of_cases()[at(k)].displacement.at(free, factors);
    return all;
}

/// In an increment.
struct CaseWork {
    Eigen::VectorXd each;
    double total;
};

/// By load cases: trapezoids of load and displacement, and of what is moved and what it costs. Before the first
/// increment everything is zero.
CaseWork work_of_cases(const WorkBalance& before, const LoadFactors& factors, const Eigen::VectorXd& displacements,
                       const Eigen::VectorXd& forces, const Eigen::VectorXd& zone_paths) {
    const auto of = [](const Eigen::VectorXd& all, Eigen::Index k) { return k < all.size() ? all[k] : 0.0; };
    CaseWork work{Eigen::VectorXd(displacements.size()), 0.0};
    for (Eigen::Index k = 0; k < displacements.size(); ++k) {
        const double path = displacements[k] - of(before.case_displacements, k) + of(zone_paths, k);
        const double of_loads = 0.5 * (of(before.cases, k) + factors.of_case(k)) * path;
        const double of_imposed =
            0.5 * (of(before.case_forces, k) + forces[k]) * (factors.of_case(k) - of(before.cases, k));
        work.each[k] = of_loads + of_imposed;
        work.total += of_loads;
        work.total += of_imposed;
    }
    return work;
}

}  // namespace

void add_increment(WorkBalance& balance, const Structure& structure, const Eigen::VectorXd& u,
                   const LoadFactors& factors, const MachineReading& machine, const coupling::StepReport& zone) {
    const auto [path, case_paths] = load_displacements(structure, u, factors);
    const double load_factor = factors.main, imposed_force = machine.imposed_force;
    balance.external +=
        0.5 * (balance.load_factor + load_factor) * (path - balance.load_displacement + zone.energy.load_path);
    balance.external += 0.5 * (balance.imposed_force + imposed_force) * (load_factor - balance.load_factor);
    const CaseWork of_cases =
        work_of_cases(balance, factors, case_paths, machine.imposed_forces_of_cases, zone.energy.case_paths);
    balance.external += of_cases.total;
    if (balance.by_cases.size() == 0) balance.by_cases.setZero(of_cases.each.size());
    balance.by_cases += of_cases.each;
    balance.released += zone.energy.released;
    balance.stored = structure.loads().stored_energy(structure.tangent(), on_free_places(structure, u), factors) +
                     zone.energy.stored;
    balance.by_friction += zone.energy.friction;
    balance.dissipated += zone.dissipation + zone.energy.friction;
    balance.load_factor = load_factor;
    balance.load_displacement = path;
    balance.imposed_force = imposed_force;
    balance.cases = factors.cases;
    balance.case_displacements = case_paths;
    balance.case_forces = machine.imposed_forces_of_cases;
}

void begin_here(WorkBalance& balance) {
    balance.at_start = balance.stored + balance.dissipated + balance.released - balance.external;
}

void restart(WorkBalance& balance, const Structure& structure, const Eigen::VectorXd& u) {
    const auto [path, case_paths] = load_displacements(structure, u, {balance.load_factor, balance.cases});
    balance.load_displacement = path;
    balance.case_displacements = case_paths;
}

}  // namespace stria::coarse
