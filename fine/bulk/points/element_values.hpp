// Nodal values that each element has for itself: its share of the nodal forces, or the displacement it was looked at.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "common/integration/element_operator.hpp"

namespace stria::fine {

/// Element by element a value on each of its unknowns, in their order: 2f numbers where it has f functions.
class ElementValues {
public:
    /// All zero.
    explicit ElementValues(const std::vector<ElementOperator>& operators) {
        for (const ElementOperator& op : operators) first_.push_back(first_.back() + std::ssize(op.unknowns));
        values_.assign(at(first_.back()), 0.0);
    }

    [[nodiscard]] auto of(int element) {
        return Eigen::Map<Eigen::VectorXd>(values_.data() + first_[at(element)], size(element));
    }
    [[nodiscard]] auto of(int element) const {
        return Eigen::Map<const Eigen::VectorXd>(values_.data() + first_[at(element)], size(element));
    }

private:
    [[nodiscard]] Eigen::Index size(int element) const { return first_[at(element) + 1] - first_[at(element)]; }

    std::vector<std::ptrdiff_t> first_{0};  // of each element, and behind the last
    std::vector<double> values_;
};

}  // namespace stria::fine
