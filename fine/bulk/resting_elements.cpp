#include "fine/bulk/resting_elements.hpp"

#include <algorithm>

namespace stria::fine {
namespace {

constexpr int all_recent = 3;  // half cycles, one a bit

}  // namespace

RestingElements::RestingElements(const BulkElements& bulk, const Eigen::VectorXd& displacement)
    : elements_(bulk.count()), awake_(elements_.complement().members()), displacement_(displacement),
      recent_flow_(at(bulk.count()), all_recent) {}

void RestingElements::rest(const ElementSet& elements, const Eigen::VectorXd& displacement, ElasticBound& bound) {
    displacement_ = displacement;
    elements_ |= elements;
    awake_ = elements_.complement().members();
    for (int e = 0; e < elements.size(); ++e)
        if (elements.contains(e)) bound.look_at(e, displacement_);
}

void RestingElements::wake(const ElementSet& waking) {
    for (const int e : waking.members()) elements_.erase(e);
    awake_ = elements_.complement().members();
}

std::vector<int> RestingElements::would_yield(const Eigen::VectorXd& u, const BulkElements& bulk, PointHistory& history,
                                              ElasticBound& bound) {
    const Eigen::VectorXd since_rest = u - displacement_;
    std::vector<int> found;
    for (int e = 0; e < bulk.count(); ++e)
        if (contains(e) && would_yield(e, u, since_rest, bulk, history, bound)) found.push_back(e);
    return found;
}

// What its stresses have changed by since it was looked at the last time proves most elements elastic. Of the others
// the law tells, as of any point, and how much is left until one yields.
bool RestingElements::would_yield(int e, const Eigen::VectorXd& u, const Eigen::VectorXd& since_rest,
                                  const BulkElements& bulk, PointHistory& history, ElasticBound& bound) {
    if (bound.proves_at(e, u)) return false;
    history.update(bulk.operators(), e, e + 1, since_rest);
    const bool yields = history.yields(e);
    if (!yields) {
        bound.set_margin(e, history.trial_elastic_margin(e));
        bound.look_at(e, u);
    }
    history.set_elastic(e);
    history.rollback(e);
    return yields;
}

void RestingElements::note_half_cycle(const PointHistory& history) {
    for (int e = 0; e < elements_.size(); ++e) {
        int& flow = recent_flow_[at(e)];
        flow = ((flow << 1) | (history.is_plastic(e) ? 1 : 0)) & all_recent;
    }
}

ElementSet RestingElements::may_rest(const BulkElements& bulk, const PointHistory& history,
                                     const ElementSet& yielded) const {
    constexpr int same_direction = 2;
    const EnrichedMesh& mesh = bulk.mesh();
    std::vector<char> flows(mesh.nodes.size(), 0);
    for (int e = 0; e < elements_.size(); ++e)
        if ((recent_flow_[at(e)] & same_direction) != 0)
            for (const int node : mesh.elements[at(e)]) flows[at(node)] = 1;
    ElementSet may(elements_.size());
    const auto still = [&](int node) { return flows[at(node)] == 0; };
    for (int e = 0; e < may.size(); ++e)
        if (!yielded.contains(e) && (!history.law(e).can_yield() || std::ranges::all_of(mesh.elements[at(e)], still)))
            may.insert(e);
    return may;
}

}  // namespace stria::fine
