// How far and where a crack grows.
#pragma once

#include "coarse/analysis/cycle_result.hpp"
#include "coarse/fracture/fracture_parameters.hpp"
#include "coarse/load/load_controller.hpp"
#include "coarse/model/scene.hpp"
#include "common/case/case.hpp"
#include "common/enrichment/enriched_mesh.hpp"

namespace stria::coarse {

/// Angle from a tip's direction to the largest hoop stress, radians, within 70.6 degrees; 0 where |K_II| is below 0.005
/// K_I. Erdogan and Sih, J. Basic Eng. 85 (1963) 519.
double hoop_stress_angle(double K_I, double K_II);

/// da/dN of a tip by the law, mm/cycle; 0 where nothing drives it. Prescribed: the increment.
double growth_rate(const GrowthSection& growth, const CycleResult& cycle);

double fastest_rate(const GrowthSection& growth, const std::vector<CycleResult>& cycles);

/// What each tip advances next: the fastest one by the increment, the others in proportion; by a prescribed law, and
/// before the first cycle is over (`last` is empty), all alike.
std::vector<double> advances(const GrowthSection& growth, const std::vector<CycleResult>& last, std::size_t tips);

/// Cycles that it took to grow by `grown`, mm, from one state to another with the rates da/dN, mm/cycle, of the fastest
/// tip (trapezoidal rule). Prescribed: 1, the cycle itself.
double cycles_passed(const GrowthSection& growth, double grown, double rate_before, double rate_after);

/// The case with each tip advanced by its length, mm, along its growth direction. `nominal`: one a tip.
Case with_longer_cracks(const Scene& scene, const std::vector<TipResult>& nominal,
                        const std::vector<double>& advance_by);

/// Advances the end of a crack along a unit vector. On a straight crack its last point moves.
void advance(CrackSection& crack, const Tip& tip, const Vec2& direction, double increment);

}  // namespace stria::coarse
