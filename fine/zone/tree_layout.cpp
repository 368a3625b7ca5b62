#include "fine/zone/tree_layout.hpp"

#include <limits>

#include "common/fem/centre.hpp"
#include "common/index.hpp"

namespace stria::fine {

FrontTree::Layout layout_of_tree(const ZoneSystem& system) {
    const coupling::Patch& patch = system.patch();
    const ContactInterface& contact = system.contact();
    FrontTree::Layout layout;
    layout.unknowns = patch.mesh.unknowns + contact.tractions();
    layout.multipliers = contact.tractions();
    layout.boundary = patch.boundary;
    layout.busy = busy_places(patch.mesh);
    for (const ElementOperator& op : system.bulk().operators()) {
        layout.element_unknowns.push_back(op.unknowns);
        layout.centres.push_back(centre(patch.mesh, op.element));
    }
    for (int k = 0; k < contact.multipliers(); ++k) {
        layout.element_unknowns.push_back(contact.unknowns_of(k, patch.mesh.unknowns));
        layout.centres.push_back(contact.operators().keys()[at(k)].x);
    }
    return layout;
}

std::vector<Vec2> busy_places(const EnrichedMesh& mesh) {
    std::vector<Vec2> places;
    for (const Tip& tip : mesh.tips) {
        Vec2 nearest = Vec2::Zero();
        double least = std::numeric_limits<double>::infinity();
        for (int e = 0; e < std::ssize(mesh.elements); ++e) {
            const Vec2 here = centre(mesh, e);
            const double distance = (here - tip.position).squaredNorm();
            if (distance < least) nearest = here, least = distance;
        }
        places.push_back(nearest);
    }
    return places;
}

}  // namespace stria::fine
