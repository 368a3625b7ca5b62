// Which elements surely stay elastic in an increment: their points need not be looked at until it is committed.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include "common/integration/element_operator.hpp"

namespace stria::fine {

/// The energy of the increment in an element, du^T K du / 2 with its elastic matrix, is the sum of w e over its points,
/// e the energy density of the stress increment, which is at least vm^2 / (6 mu). So no point's von Mises stress
/// changes by more than sqrt(3 mu du^T K du / w), w its weight, and where the smallest distance to the yield surface is
/// larger nothing flows. A point without weight proves nothing.
class ElasticBound {
public:
    void add_element(const ElementOperator& op, double shear_modulus) {
        const double least = std::ranges::min(op.points, {}, &IntegrationPoint::weight).weight;
        per_energy_.push_back(least > 0.0 ? 3.0 * shear_modulus / least : std::numeric_limits<double>::infinity());
        margin_.push_back(0.0);
    }

    /// The smallest distance to the yield surface of an element's committed points, MPa.
    void set_margin(std::size_t element, double margin) { margin_[element] = margin; }

    /// `work`: du^T K du, N.
    [[nodiscard]] bool proves(std::size_t element, double work) const {
        return per_energy_[element] * work < safety * margin_[element] * margin_[element];
    }

private:
    static constexpr double safety = 1.0 - 1e-6;  // what rounding may do

    std::vector<double> per_energy_, margin_;  // per element
};

}  // namespace stria::fine
