// From the values of a load history to load factors.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "coarse/load/case_histories.hpp"
#include "common/case/case.hpp"

namespace stria::coarse {

/// Of the nominal body (nominal_solution.hpp) at the load factor 1, mm.
struct UnitDisplacement {
    double mean = 0.0;                  // of the loaded boundary along its direction
    double largest = 0.0;               // largest magnitude of a component
    std::vector<double> of_cases = {};  // as `mean`, of each load case alone at its factor 1
    double initial = 0.0;               // likewise, of the initial stress alone

    /// Where the boundary stands without [load], mm: an initial stress and load cases have moved it.
    [[nodiscard]] double beside(const Eigen::VectorXd& cases) const {
        double displacement = initial;
        for (Eigen::Index k = 0; k < std::min(cases.size(), std::ssize(of_cases)); ++k)
            displacement += cases[k] * of_cases[static_cast<std::size_t>(k)];
        return displacement;
    }
    /// The load factor with which it comes to a mean displacement, mm, beside these.
    [[nodiscard]] double load_factor_at(double displacement, const Eigen::VectorXd& cases) const {
        return (displacement - beside(cases)) / mean;
    }
};

/// What a load history asks of the nominal body, at the load factor 1.
struct UnitResponse {
    std::vector<double> K_I = {}, K_II = {};  // MPa sqrt(mm), one per tip
    // K_I and K_II of the initial stress without load; empty: there is none.
    std::vector<double> K_initial = {}, K_II_initial = {};
    std::vector<std::vector<double>> K_I_of_cases = {}, K_II_of_cases = {};  // of each at its factor 1; or empty
    std::vector<std::optional<double>> friction = {};  // of each tip's crack; none: its faces never touch
    UnitDisplacement displacement = {};
};

/// The target that a unit of the load history stands for. It is 1 unless K is controlled. Then it is a load factor:
/// 1 / K_1(a) of the first tip, times what the gradient of K makes of `grown`, the growth so far, mm. `K_I`: of the
/// nominal body, one per tip. Throws CaseError where the load does not open the first tip.
double target_of_unit(const LoadSection& load, const std::vector<double>& K_I, double grown);

/// The largest load factor of the history, not below zero, and the smallest, not above: it begins without [load]. Where
/// displacements are controlled they are those of the nominal body beside dead loads, and it begins where a pressure
/// that travels has moved the boundary, too; a body that yields bears less. Throws CaseError where the loads do not
/// move what is controlled.
struct LoadRange {
    double largest, smallest;
};
LoadRange range_of_load(const Case& input, const UnitResponse& nominal, double grown = 0.0);

/// The K of eq. (3), MPa sqrt(mm), one per tip: sqrt(K_I^2 + 3 K_II^2) at the extreme of the history where it is
/// larger, for a strip that yields in shear (Dugdale) is three times as long as one that yields in tension. Nominal,
/// with K of the initial stress. Faces that touch under pressure leave no K_I, and friction takes mu |K_I| off
/// |K_II|, as along a straight crack. With load cases no less than that: as if all were at their largest at once; of a
/// pressure that travels K_II counts where it opens the crack, for elsewhere what faces without tractions would do says
/// nothing. Where displacements are controlled a load case that changes takes from [load], or adds to it, what holds
/// the boundary.
std::vector<double> largest_K(const Case& input, const UnitResponse& nominal, double grown = 0.0);

/// The history with equal increments where the case does not grade them, no load case lags and the load presses faces
/// with friction together at an extreme (by nominal K_I, by more than a hundredth of the largest K, with each load case
/// at its least). What they slide on the way back a trapezoid tells per increment.
LoadSection graded_load(const Case& input, const UnitResponse& nominal);

/// The K_I of largest_K, MPa sqrt(mm), one per tip; 0 where nothing opens the crack.
std::vector<double> largest_K_I(const Case& input, const UnitResponse& nominal, double grown = 0.0);

/// The K_I with which the load presses the faces at an extreme of the history, with each load case at its least, MPa
/// sqrt(mm), one per tip; 0 where it presses none, or by less than a hundredth of the largest K.
[[nodiscard]] std::vector<double> least_K_I(const Case& input, const UnitResponse& nominal);

/// The K_I of the cycles that opening loads are asked of, MPa sqrt(mm), one per tip: by a maximum up to which the
/// cycles make half of the growth (median_maximum), so that a few peaks do not stand for all. Without growth the
/// largest. `grown`: as above. `passed`: cycles; those ahead count (cycles_ahead).
std::vector<double> common_K_I(const Case& input, const UnitResponse& nominal, double grown = 0.0, int passed = 0);

}  // namespace stria::coarse
