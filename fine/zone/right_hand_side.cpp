#include "fine/zone/right_hand_side.hpp"

#include "common/index.hpp"

namespace stria::fine {

Eigen::VectorXd right_hand_side_of(const ZoneSystem& system) {
    const ContactInterface& contact = system.contact();
    Eigen::VectorXd open = contact.awake(system.traction()), forces = system.load();
    for (int k = 0; k < contact.multipliers(); ++k) {
        if (!is_closed(contact.statuses()[at(k)])) continue;
        open[k] = 0.0;
        if (contact.shear_of(k) >= 0) open[contact.shear_of(k)] = 0.0;
    }
    contact.operators().add_force(open, forces);
    Eigen::VectorXd right(forces.size() + open.size());
    right << forces, system.contact_right_hand_side();
    return right;
}

}  // namespace stria::fine
