#include "fine/material/elastic.hpp"

#include <algorithm>
#include <cstddef>

namespace stria::fine {

void Elastic::update(int points, int stride, const double* strain_increment, const double* committed, double* trial,
                     double* /*tangent*/, unsigned char* yielding) const {
    const auto at = [stride](int component) { return static_cast<std::ptrdiff_t>(component) * stride; };
    for (int i = 0; i < 4; ++i) {
        std::copy_n(committed + at(i), points, trial + at(i));
        for (int j = 0; j < 4; ++j)
            for (int q = 0; q < points; ++q) trial[at(i) + q] += stiffness_(i, j) * strain_increment[at(j) + q];
    }
    std::fill_n(yielding, points, static_cast<unsigned char>(0));
}

}  // namespace stria::fine
