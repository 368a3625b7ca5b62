// What the handbook of the case's specimen says, beside what the elastic structure says.
#pragma once

#include <string>
#include <vector>

#include "coarse/fracture/fracture_parameters.hpp"

namespace stria::coarse {

struct HandbookLine {
    std::string quantity;
    std::string unit;
    double handbook;
    double own;  // not a number: nothing of our own to compare
};

/// `u`, `tips`: the elastic, traction-free solution for the load factor 1. Empty where the handbook does not apply: no
/// formula, not one straight crack across the width at mid-height (of mt in the middle), or loads that are not what
/// it assumes (uniform tension on ends that turn freely, or forces at both pins). The limit load is a load factor.
std::vector<HandbookLine> compare_with_handbook(const Structure& structure, const Eigen::VectorXd& u,
                                                const std::vector<TipResult>& tips);

}  // namespace stria::coarse
