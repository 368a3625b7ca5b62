#include "fine/bulk/resting_elements.hpp"

#include "fine/bulk/element_kernels.hpp"

namespace stria::fine {

RestingElements::RestingElements(const std::vector<ElementOperator>& operators, const Eigen::VectorXd& displacement)
    : elements_(operators.size()), displacement_(displacement), looked_at_(operators),
      elastic_half_cycles_(operators.size(), 0) {}

void RestingElements::rest(const ElementSet& elements, const Eigen::VectorXd& displacement,
                           const std::vector<ElementOperator>& operators) {
    displacement_ = displacement;
    elements_ |= elements;
    for (int e = 0; e < elements.size(); ++e)
        if (elements.contains(e)) looked_at_.of(e) = gather(displacement_, operators[at(e)].unknowns);
}

std::vector<int> RestingElements::would_yield(const Eigen::VectorXd& u, const BulkElements& bulk, PointHistory& history,
                                              ElasticBound& bound) {
    const Eigen::VectorXd since_rest = u - displacement_;
    std::vector<int> found;
    for (int e = 0; e < bulk.count(); ++e)
        if (contains(e) && would_yield(e, u, since_rest, bulk, history, bound)) found.push_back(e);
    return found;
}

// The energy of what it has moved since it was looked at the last time proves most elements elastic. Of the others the
// law tells, as of any point, and how much is left until one yields.
bool RestingElements::would_yield(int e, const Eigen::VectorXd& u, const Eigen::VectorXd& since_rest,
                                  const BulkElements& bulk, PointHistory& history, ElasticBound& bound) {
    const Eigen::VectorXd now = gather(u, bulk.op(e).unknowns);
    const Eigen::VectorXd moved = now - looked_at_.of(e);
    double work = 0.0;
    with_kernel(bulk.op(e), [&](const auto& kernel) { work = kernel.work(bulk.stiffness()[at(e)], moved); });
    if (bound.proves(at(e), work)) return false;
    history.update(bulk.operators(), e, e + 1, since_rest);
    const bool yields = history.yields(e);
    if (!yields) {
        bound.set_margin(at(e), history.trial_elastic_margin(e));
        looked_at_.of(e) = now;
    }
    history.set_elastic(e);
    history.rollback(e);
    return yields;
}

void RestingElements::count_half_cycle(const PointHistory& history) {
    for (int e = 0; e < elements_.size(); ++e) {
        int& count = elastic_half_cycles_[at(e)];
        count = history.is_plastic(e) ? 0 : count + 1;
    }
}

ElementSet RestingElements::may_rest(const PointHistory& history) const {
    constexpr int whole_cycle = 2;
    ElementSet may(elements_.size());
    for (int e = 0; e < may.size(); ++e)
        if (elastic_half_cycles_[at(e)] >= whole_cycle || !history.law(e).can_yield()) may.insert(e);
    return may;
}

}  // namespace stria::fine
