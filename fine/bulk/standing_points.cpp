#include "fine/bulk/standing_points.hpp"

#include <algorithm>

#include "common/fem/centre.hpp"

namespace stria::fine {

StandingPoints::StandingPoints(const BulkElements& elements, const StandingPoints* old)
    : displacement_(elements.operators()), force_(displacement_), times_moved_(at(elements.count())) {
    bound_.reserve(elements.operators());
    for (int e = 0; e < elements.count(); ++e) {
        const ElementOperator& op = elements.op(e);
        if (old == nullptr || !elements.has_stayed(e)) {
            bound_.add_element(op, corners_of_element(elements.mesh(), e), VonMisesForm(elements.elastic_stiffness(e)));
            continue;
        }
        const int was = elements.was(e);
        bound_.add_element_of(old->bound_, was, op);
        displacement_.of(e) = old->displacement_.of(was);
        force_.of(e) = old->force_.of(was);
    }
}

void StandingPoints::stand_at(int e, const Eigen::VectorXd& element_u, const BulkElements& elements,
                              const PointHistory& history) {
    displacement_.of(e) = element_u;
    ++times_moved_[at(e)];
    look_back(e, history);
    with_kernel(elements.op(e), [&](const auto& kernel) {
        const auto force = kernel.force(history.stresses(e), history.points());
        std::copy_n(force.data(), force.size(), force_.of(e).data());
    });
}

void StandingPoints::bring_to(int e, const Eigen::VectorXd& u, const BulkElements& elements, PointHistory& history) {
    const ElementOperator& op = elements.op(e);
    const Eigen::VectorXd way = ahead(op, e, u);
    if (way.isZero(0.0)) return;
    history.update(op, e, way);
    history.commit(e, e + 1);
    history.set_elastic(e);
    stand_at(e, gather(u, op.unknowns), elements, history);
}

void StandingPoints::find_force(int e, const Eigen::VectorXd& u, const BulkElements& elements,
                                ElementValues& force) const {
    with_kernel(elements.op(e), [&](const auto& kernel) {
        const auto ahead = (kernel.gather(u) - kernel.nodal(displacement_.of(e).data())).eval();
        const auto change = kernel.elastic_force(elements.stiffness()[at(e)], ahead);
        const double* standing = force_.of(e).data();
        double* sum = force.of(e).data();
        for (Eigen::Index k = 0; k < change.size(); ++k) sum[k] = standing[k] + change.data()[k];
    });
}

double StandingPoints::stored(int e, const Eigen::VectorXd& u, const BulkElements& elements) const {
    double stored = 0.0;
    with_kernel(elements.op(e), [&](const auto& kernel) {
        const auto ahead = (kernel.gather(u) - kernel.nodal(displacement_.of(e).data())).eval();
        const auto change = kernel.elastic_force(elements.stiffness()[at(e)], ahead);
        stored = ahead.cwiseProduct(kernel.nodal(force_.of(e).data()) + 0.5 * change).sum();
    });
    return stored;
}

// What its stresses have changed by since it was looked at the last time proves most elements elastic. Of the others
// the yield surface tells how much is left until a point yields: nobody needs to know to where it would return.
bool StandingPoints::would_yield_at(int e, const Eigen::VectorXd& u, const BulkElements& elements,
                                    PointHistory& history) {
    if (bound_.proves_at(e, u)) return false;
    const ElementOperator& op = elements.op(e);
    const double margin = history.elastic_margin_behind(op, e, ahead(op, e, u), elements.elastic_stiffness(e));
    if (margin < 0.0) return true;
    bound_.look_at(e, gather(u, op.unknowns), margin);
    return false;
}

}  // namespace stria::fine
