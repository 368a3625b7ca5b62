#include "fine/bulk/resting_elements.hpp"

#include <algorithm>

namespace stria::fine {
namespace {

constexpr int all_recent = 3;  // half cycles, one a bit

}  // namespace

RestingElements::RestingElements(const BulkElements& bulk, const Eigen::VectorXd& displacement)
    : elements_(bulk.count()), awake_(elements_.complement().members()), displacement_(displacement),
      recent_flow_(at(bulk.count()), all_recent) {}

void RestingElements::rest(const ElementSet& elements, const Eigen::VectorXd& displacement) {
    displacement_ = displacement;
    elements_ |= elements;
    awake_ = elements_.complement().members();
}

void RestingElements::wake(const ElementSet& waking) {
    for (const int e : waking.members()) elements_.erase(e);
    awake_ = elements_.complement().members();
}

void RestingElements::note_half_cycle(const PointHistory& history) {
    for (int e = 0; e < elements_.size(); ++e) {
        int& flow = recent_flow_[at(e)];
        flow = ((flow << 1) | (history.is_plastic(e) ? 1 : 0)) & all_recent;
    }
}

ElementSet RestingElements::may_rest(const BulkElements& bulk, const PointHistory& history,
                                     const ElementSet& softened) const {
    constexpr int same_direction = 2;
    const EnrichedMesh& mesh = bulk.mesh();
    std::vector<char> flows(mesh.nodes.size(), 0);
    for (int e = 0; e < elements_.size(); ++e)
        if ((recent_flow_[at(e)] & same_direction) != 0)
            for (const int node : mesh.elements[at(e)]) flows[at(node)] = 1;
    ElementSet may(elements_.size());
    const auto still = [&](int node) { return flows[at(node)] == 0; };
    for (int e = 0; e < may.size(); ++e)
        if (!softened.contains(e) && (!history.law(e).can_yield() || std::ranges::all_of(mesh.elements[at(e)], still)))
            may.insert(e);
    return may;
}

}  // namespace stria::fine
