// The handbook's values for the specimen of a case beside those of its nominal solution.
#pragma once

#include <string>
#include <vector>

#include "coarse/fracture/nominal_solution.hpp"

namespace stria::coarse {

struct HandbookLine {
    std::string quantity;
    std::string unit;
    double handbook;
    double own;  // NaN: the solution has no such value
};

/// Empty where the handbook does not apply: it has no formula, the body is of several materials, there is not one
/// straight crack across the width at mid-height (of mt in the middle), or the loads are not what it assumes (uniform
/// tension on ends that turn freely, or forces at both pins). The limit load is a load factor.
std::vector<HandbookLine> compare_with_handbook(const NominalSolution& nominal);

}  // namespace stria::coarse
