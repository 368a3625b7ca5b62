// How far and where a crack grows.
#pragma once

#include "coarse/load_controller.hpp"
#include "common/fem/enriched_mesh.hpp"
#include "common/io/case.hpp"

namespace stria::coarse {

/// Whether the cracks advance when a step of the load has been reached.
bool grows_at(const GrowthSection& growth, const LoadStep& step);

/// What a tip advances in a whole run, mm.
double planned_growth(const GrowthSection& growth, const LoadSection& load);

/// Angle from a tip's direction to the largest hoop stress, radians, within 70.6 degrees; 0 where |K_II| is below 0.005
/// K_I. Erdogan and Sih, J. Basic Eng. 85 (1963) 519.
double hoop_stress_angle(double K_I, double K_II);

/// Cycles that the growth by one increment takes; `K_min` or `K_op` by what drives the law. Prescribed: `every`.
double cycles_of_increment(const GrowthSection& growth, double K_max, double K_min, double K_op);

/// Advances the end of a crack along a unit vector. On a straight crack its last point moves.
void advance(CrackSection& crack, const Tip& tip, const Vec2& direction, double increment);

}  // namespace stria::coarse
