// By how much a displacement changes the stresses of an element elastically.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "common/index.hpp"
#include "common/integration/element_operator.hpp"
#include "common/mandel.hpp"

namespace stria::fine {

/// The square of the von Mises stress of an elastic strain, MPa2, as the isotropic elastic stiffness (Mandel form)
/// makes it: normal (xx^2 + yy^2) + mixed xx yy + shear (2 xy)^2. A mean dilatation has no part in it.
struct VonMisesForm {
    explicit VonMisesForm(const MandelMatrix& elastic)
        : normal(squared(elastic, {1.0, 0.0, 0.0, 0.0})), mixed(squared(elastic, {1.0, 1.0, 0.0, 0.0}) - 2.0 * normal),
          shear(0.5 * squared(elastic, {0.0, 0.0, 0.0, 1.0})) {}

    /// No more than so much times the square of the norm of a displacement gradient.
    [[nodiscard]] double steepest() const { return std::max(normal + 0.5 * std::abs(mixed), 2.0 * shear); }

    double normal, mixed, shear;

private:
    [[nodiscard]] static double squared(const MandelMatrix& elastic, const Mandel& strain) {
        return 1.5 * deviator(elastic * strain).squaredNorm();
    }
};

/// The largest square of a von Mises stress, MPa2, over an element's points. Element by element all that this takes
/// lies together: elements at rest are many, and seldom in a cache.
class StressChanges {
public:
    /// Numbered as they come; looked at without displacement. `corners`: of the element.
    void add_element(const ElementOperator& op, const std::array<Vec2, 4>& corners, const VonMisesForm& form);
    /// That of another list, looked at where it was there, with an operator that differs in the numbers of its unknowns
    /// only.
    void add_element_of(const StressChanges& other, int element, const ElementOperator& op);
    /// So many are to come.
    void reserve(std::span<const ElementOperator> operators);

    /// Its changes are those from here on: a displacement in the order of its unknowns, mm.
    void look_at(int element, const Eigen::VectorXd& element_u);

    /// Of the changes since then, to a displacement of all unknowns of the mesh, mm: whether it is less than a limit,
    /// MPa2. What is not a number is not.
    [[nodiscard]] bool stay_below(int element, const Eigen::VectorXd& u, double limit) const;

private:
    struct Record {
        Eigen::Index unknowns, points;        // how many; points: those that tell of the others too
        std::ptrdiff_t first_unknown, first;  // in unknowns_ and in values_
        VonMisesForm form;
        double steepest;  // no more than so much times the square of what its functions move by, MPa2/mm2
    };
    void add_record(const ElementOperator& op, Eigen::Index points, const VonMisesForm& form, double steepest);
    template <int unknowns>
    [[nodiscard]] bool stay_below(const Record& record, const Eigen::VectorXd& u, double limit) const;
    template <int unknowns>
    [[nodiscard]] double largest(const Record& record, const Eigen::Matrix<double, unknowns, 1>& moved) const;
    /// Of the points from `first` on, `points` of them. `moved`: the element's unknowns since the look, mm.
    template <int unknowns, int points>
    [[nodiscard]] double largest_of(const Record& record, Eigen::Index first,
                                    const Eigen::Matrix<double, unknowns, 1>& moved) const;

    std::vector<Record> records_;
    std::vector<int> unknowns_;
    // Of an element: its displacement when it was looked at; per function its derivatives by x at its points, then
    // those by y.
    std::vector<double> values_;
};

}  // namespace stria::fine
