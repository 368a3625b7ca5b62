#include "coarse/zone/structure_stresses.hpp"

#include <algorithm>
#include <limits>

namespace stria::coarse {
namespace {

bool may_yield(const Structure& structure, int element) { return !structure.scene().mesh.in_insert(element); }

/// A bound that costs less than the stresses.
double stress_bound(const PlainOperator& op, const MandelMatrix& stiffness, double of_unit_strain,
                    const PlainOperator::Values& local) {
    return von_mises(stiffness * op.mean_strain(local)) + of_unit_strain * op.warping(local);
}

double stress_bound(const ElementOperator&, const MandelMatrix&, double, const Eigen::VectorXd&) {
    return std::numeric_limits<double>::infinity();
}

template <class Operator>
double largest_stress(const Operator& op, const MandelMatrix& elastic, const Eigen::VectorXd& u) {
    const auto local = gather(u, op.unknowns);
    double largest = 0.0;
    for (std::size_t q = 0; q < op.points.size(); ++q)
        largest = std::max(largest, von_mises(elastic * op.strain(local, q)));
    return largest;
}

}  // namespace

std::vector<int> elements_beyond(double stress, const Structure& structure, const Eigen::VectorXd& u) {
    const MandelMatrix elastic = structure.scene().elastic.stiffness();
    std::vector<int> found;
    structure.elements().for_each([&](const auto& op) {
        if (may_yield(structure, op.element) && largest_stress(op, elastic, u) > stress) found.push_back(op.element);
    });
    return found;
}

std::vector<int> near_elements_beyond(double stress, const Structure& structure, const Eigen::VectorXd& u) {
    const MandelMatrix elastic = structure.scene().elastic.stiffness();
    const double of_unit_strain = structure.scene().elastic.largest_von_mises();
    std::vector<int> found;
    structure.elements().for_each(structure.elements().near(), [&](const auto& op) {
        if (stress_bound(op, elastic, of_unit_strain, gather(u, op.unknowns)) > stress &&
            may_yield(structure, op.element) && largest_stress(op, elastic, u) > stress)
            found.push_back(op.element);
    });
    return found;
}

double largest_far_stress(const Structure& structure, const Eigen::VectorXd& u) {
    const MandelMatrix elastic = structure.scene().elastic.stiffness();
    double largest = 0.0;
    structure.elements().for_each([&](const auto& op) {
        if (structure.is_far(op.element) && may_yield(structure, op.element))
            largest = std::max(largest, largest_stress(op, elastic, u));
    });
    return largest;
}

double smallest_far_weight(const Structure& structure) {
    double smallest = std::numeric_limits<double>::infinity();
    structure.elements().for_each([&](const auto& op) {
        if (!structure.is_far(op.element) || !may_yield(structure, op.element)) return;
        for (const IntegrationPoint& point : op.points) smallest = std::min(smallest, point.weight);
    });
    return smallest;
}

}  // namespace stria::coarse
