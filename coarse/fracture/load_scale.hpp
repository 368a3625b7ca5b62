// From the values of a load history to load factors.
#pragma once

#include <vector>

#include "coarse/fracture/nominal_solution.hpp"

namespace stria::coarse {

/// The target that a unit of the load history stands for. It is 1 unless K is controlled. Then it is a load factor:
/// 1 / K_1(a) of the first tip, times what the gradient of K makes of `grown`, the growth so far, mm. `nominal`: one
/// per tip. Throws CaseError where the load does not open the first tip.
double target_of_unit(const LoadSection& load, const std::vector<TipResult>& nominal, double grown);

/// Largest load factor of a history. Where displacements are controlled it is that of the nominal body; a body that
/// yields bears less. Throws CaseError where the loads do not move what is controlled.
double largest_load_factor(const LoadSection& load, const NominalSolution& nominal, double grown = 0.0);

/// The K_I of eq. (3), MPa sqrt(mm), one per tip: the largest nominal one of a history.
std::vector<double> largest_K_I(const LoadSection& load, const NominalSolution& nominal, double grown = 0.0);

}  // namespace stria::coarse
