#include "fine/bulk/joining_elements.hpp"

#include <algorithm>

#include "common/index.hpp"

namespace stria::fine {

Eigen::VectorXd force_of_joining(const Bulk& bulk, const EnrichedMesh& before) {
    const EnrichedMesh& mesh = bulk.elements().mesh();
    Eigen::VectorXd force = Eigen::VectorXd::Zero(mesh.unknowns);
    for (int e = 0; e < bulk.elements().count(); ++e)
        if (!std::ranges::binary_search(before.element_ids, mesh.element_ids[at(e)]))
            force(bulk.elements().op(e).unknowns) += bulk.trial_force(e);
    return force;
}

}  // namespace stria::fine
