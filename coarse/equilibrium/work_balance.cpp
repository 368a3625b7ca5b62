#include "coarse/equilibrium/work_balance.hpp"

#include "common/integration/element_operator.hpp"

namespace stria::coarse {
namespace {

Eigen::VectorXd on_free_places(const Structure& structure, const Eigen::VectorXd& u) {
    return structure.on_free_places(gather(u, structure.gamma()));
}

double load_displacement(const Structure& structure, const Eigen::VectorXd& u, double load_factor) {
    return structure.loads().load_displacement().at(on_free_places(structure, u), load_factor);
}

}  // namespace

void add_increment(WorkBalance& balance, const Structure& structure, const Eigen::VectorXd& u, double load_factor,
                   double imposed_force, const coupling::StepReport& zone) {
    const double path = load_displacement(structure, u, load_factor);
    balance.external +=
        0.5 * (balance.load_factor + load_factor) * (path - balance.load_displacement + zone.energy.load_path);
    balance.external += 0.5 * (balance.imposed_force + imposed_force) * (load_factor - balance.load_factor);
    balance.released += zone.energy.released;
    balance.stored = structure.loads().stored_energy(structure.tangent(), on_free_places(structure, u), load_factor) +
                     zone.energy.stored;
    balance.by_friction += zone.energy.friction;
    balance.dissipated = zone.dissipation + balance.by_friction;
    balance.load_factor = load_factor;
    balance.load_displacement = path;
    balance.imposed_force = imposed_force;
}

void begin_here(WorkBalance& balance) {
    balance.at_start = balance.stored + balance.dissipated + balance.released - balance.external;
}

void restart(WorkBalance& balance, const Structure& structure, const Eigen::VectorXd& u) {
    balance.load_displacement = load_displacement(structure, u, balance.load_factor);
}

}  // namespace stria::coarse
