#include "coarse/zone/structure_stresses.hpp"

#include <algorithm>
#include <limits>

namespace stria::coarse {
namespace {

/// A bound that costs less than the stresses.
double stress_bound(const PlainOperator& op, const MandelMatrix& stiffness, double of_unit_strain,
                    const PlainOperator::Values& local) {
    return von_mises(stiffness * op.mean_strain(local)) + of_unit_strain * op.warping(local);
}

double stress_bound(const ElementOperator&, const MandelMatrix&, double, const Eigen::VectorXd&) {
    return std::numeric_limits<double>::infinity();
}

/// `initial`: null where only the displacement counts.
template <class Operator>
double largest_stress(const Operator& op, const MandelMatrix& elastic, const Eigen::VectorXd& u, const Scene* initial) {
    const auto local = gather(u, op.unknowns);
    double largest = 0.0;
    for (std::size_t q = 0; q < op.points.size(); ++q) {
        Mandel stress = elastic * op.strain(local, q);
        if (initial != nullptr) stress += initial->initial_stress(op.element, op.points[q].x);
        largest = std::max(largest, von_mises(stress));
    }
    return largest;
}

/// Whose initial stress counts; null: there is none.
const Scene* initial_of(const Structure& structure) {
    return structure.scene().initial_stress().any() ? &structure.scene() : nullptr;
}

/// Calls visit(op, weight, elastic stiffness) with what counts of its stress, where any of it does.
template <class Visit> auto where_it_counts(const Structure& structure, const Visit& visit) {
    return [&structure, visit](const auto& op) {
        const Scene& scene = structure.scene();
        const double weight = scene.stress_weight(op.element);
        if (weight > 0.0) visit(op, weight, scene.stiffness(op.element));
    };
}

}  // namespace

std::vector<int> elements_beyond(double stress, const Structure& structure, const Eigen::VectorXd& u) {
    const Scene* initial = initial_of(structure);
    std::vector<int> found;
    structure.elements().for_each(where_it_counts(structure, [&](const auto& op, double weight, const auto& elastic) {
        if (weight * largest_stress(op, elastic, u, initial) > stress) found.push_back(op.element);
    }));
    return found;
}

std::vector<int> near_elements_beyond(double stress, const Structure& structure, const Eigen::VectorXd& u) {
    const Scene* initial = initial_of(structure);
    std::vector<int> found;
    const auto look_at = [&](const auto& op, double weight, const MandelMatrix& elastic) {
        const double of_unit_strain = structure.scene().elastic(op.element).largest_von_mises();
        const bool may =
            initial != nullptr || weight * stress_bound(op, elastic, of_unit_strain, gather(u, op.unknowns)) > stress;
        if (may && weight * largest_stress(op, elastic, u, initial) > stress) found.push_back(op.element);
    };
    structure.elements().for_each(structure.elements().near(), where_it_counts(structure, look_at));
    return found;
}

double largest_far_stress(const Structure& structure, const Eigen::VectorXd& u, StressPart part) {
    const Scene* initial = part == StressPart::Whole ? initial_of(structure) : nullptr;
    double largest = 0.0;
    structure.elements().for_each(where_it_counts(structure, [&](const auto& op, double weight, const auto& elastic) {
        if (structure.is_far(op.element)) largest = std::max(largest, weight * largest_stress(op, elastic, u, initial));
    }));
    return largest;
}

double largest_far_response(const Structure& structure) {
    double largest = 0.0;
    structure.elements().for_each(where_it_counts(structure, [&](const auto& op, double weight, const auto&) {
        if (!structure.is_far(op.element)) return;
        const double shear = structure.scene().elastic(op.element).shear_modulus();
        for (const IntegrationPoint& point : op.points)
            largest = std::max(largest, 3.0 * weight * weight * shear / point.weight);
    }));
    return largest;
}

}  // namespace stria::coarse
