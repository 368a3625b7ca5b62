#include "fine/material/elastic.hpp"

#include <algorithm>
#include <cstddef>

namespace stria::fine {

void Elastic::update(int points, int stride, const double* strain_increment, const double* committed, double* trial,
                     double* tangent, unsigned char* yielding) const {
    const auto at = [stride](int component) { return static_cast<std::ptrdiff_t>(component) * stride; };
    for (int component = 0; component < state_size(); ++component)
        std::copy_n(committed + at(component), points, trial + at(component));
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
            for (int q = 0; q < points; ++q) trial[at(i) + q] += stiffness_(i, j) * strain_increment[at(j) + q];
            std::fill_n(tangent + at(4 * i + j), points, stiffness_(i, j));
        }
    for (int i = 0; i < 4; ++i)  // trapezoid rule: exact, the stress is linear in the increment
        for (int q = 0; q < points; ++q)
            trial[at(state::work) + q] += 0.5 * (committed[at(i) + q] + trial[at(i) + q]) * strain_increment[at(i) + q];
    std::fill_n(yielding, points, static_cast<unsigned char>(0));
}

}  // namespace stria::fine
