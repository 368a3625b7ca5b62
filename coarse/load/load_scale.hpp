// From the values of a load history to load factors.
#pragma once

#include <vector>

#include "coarse/load/case_histories.hpp"
#include "common/case/case.hpp"

namespace stria::coarse {

/// Of the nominal body (nominal_solution.hpp) at the load factor 1, mm.
struct UnitDisplacement {
    double mean = 0.0;     // of the loaded boundary along its direction
    double largest = 0.0;  // largest magnitude of a component
};

/// What a load history asks of the nominal body, at the load factor 1.
struct UnitResponse {
    std::vector<double> K_I = {};        // MPa sqrt(mm), one per tip
    std::vector<double> K_initial = {};  // likewise, of the initial stress without load; empty: there is none
    std::vector<std::vector<double>> K_of_cases = {};  // likewise of each load case at its factor 1; or empty
    UnitDisplacement displacement = {};
};

/// The target that a unit of the load history stands for. It is 1 unless K is controlled. Then it is a load factor:
/// 1 / K_1(a) of the first tip, times what the gradient of K makes of `grown`, the growth so far, mm. `K_I`: of the
/// nominal body, one per tip. Throws CaseError where the load does not open the first tip.
double target_of_unit(const LoadSection& load, const std::vector<double>& K_I, double grown);

/// Largest load factor of a history. Where displacements are controlled it is that of the nominal body; a body that
/// yields bears less. Throws CaseError where the loads do not move what is controlled.
double largest_load_factor(const LoadSection& load, const UnitResponse& nominal, double grown = 0.0);

/// The K_I of eq. (3), MPa sqrt(mm), one per tip: the largest nominal one of a history, that of the initial stress
/// included. With load cases no less than that: as if all were at their largest at once.
std::vector<double> largest_K_I(const LoadSection& load, const UnitResponse& nominal, double grown = 0.0,
                                const CaseHistories& cases = {});

/// The K_I of the cycles that opening loads are asked of, MPa sqrt(mm), one per tip: by a maximum up to which the
/// cycles make half of the growth (median_maximum), so that a few peaks do not stand for all. Without growth
/// largest_K_I.
std::vector<double> common_K_I(const Case& input, const UnitResponse& nominal);

}  // namespace stria::coarse
