#include "coarse/equilibrium/work_balance.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

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

/// In an increment, of one load or several: trapezoids of load and displacement, and of what is moved and what it
/// costs. `half_rise`: of their area, what is above the load that it starts from. A way that bends changes this part.
struct Trapezoid {
    double area = 0.0, half_rise = 0.0;

    void add(double from, double to, double path) {
        area += 0.5 * (from + to) * path;
        half_rise += 0.5 * std::abs((to - from) * path);
    }
};

/// By load cases. Before the first increment everything is zero.
std::vector<Trapezoid> work_of_cases(const WorkBalance& before, const LoadFactors& factors,
                                     const Eigen::VectorXd& displacements, const Eigen::VectorXd& forces,
                                     const Eigen::VectorXd& zone_paths) {
    const auto of = [](const Eigen::VectorXd& all, Eigen::Index k) { return k < all.size() ? all[k] : 0.0; };
    std::vector<Trapezoid> work(at(displacements.size()));
    for (Eigen::Index k = 0; k < displacements.size(); ++k) {
        const double from = of(before.cases, k), to = factors.of_case(k);
        work[at(k)].add(from, to, displacements[k] - of(before.case_displacements, k) + of(zone_paths, k));
        work[at(k)].add(of(before.case_forces, k), forces[k], to - from);
    }
    return work;
}

/// `contact`: what the trapezoids of all loads lack, for faces part or meet on the way. Each lacks its share.
void add_work(WorkBalance& balance, const Trapezoid& main, const std::vector<Trapezoid>& cases, double contact) {
    if (balance.by_cases.size() == 0) balance.by_cases.setZero(std::ssize(cases));
    double half_rise = main.half_rise;
    for (const Trapezoid& each : cases) half_rise += each.half_rise;
    balance.external += main.area + contact;
    for (Eigen::Index k = 0; k < std::ssize(cases); ++k) {
        const double share = half_rise > 0.0 ? cases[at(k)].half_rise / half_rise : 0.0;
        balance.external += cases[at(k)].area;
        balance.by_cases[k] += cases[at(k)].area + share * contact;
    }
    balance.largest = std::max(balance.largest, std::abs(balance.external));
}

}  // namespace

void add_increment(WorkBalance& balance, const Structure& structure, const Eigen::VectorXd& u,
                   const LoadFactors& factors, const MachineReading& machine, const coupling::StepReport& zone) {
    const auto [path, case_paths] = load_displacements(structure, u, factors);
    const double load_factor = factors.main, imposed_force = machine.imposed_force;
    Trapezoid main;
    main.add(balance.load_factor, load_factor, path - balance.load_displacement + zone.energy.load_path);
    main.add(balance.imposed_force, imposed_force, load_factor - balance.load_factor);
    add_work(balance, main,
             work_of_cases(balance, factors, case_paths, machine.imposed_forces_of_cases, zone.energy.case_paths),
             zone.energy.contact);
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
