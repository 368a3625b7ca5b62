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

/// Advances the end of a crack along a unit vector. On a straight crack its last point moves.
void advance(CrackSection& crack, const Tip& tip, const Vec2& direction, double increment);

}  // namespace stria::coarse
