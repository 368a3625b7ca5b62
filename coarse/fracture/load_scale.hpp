// What the numbers of a load history are in load factors.
#pragma once

#include <vector>

#include "coarse/fracture/fracture_parameters.hpp"
#include "coarse/structure/structure.hpp"

namespace stria::coarse {

/// What a unit of the load history is in load factors: 1, or where K is controlled 1 / K_1(a) of the first tip, times
/// what the gradient of K makes of `grown`, mm. `nominal`: for the load factor 1. Throws CaseError where a crack has no
/// tip that the load opens.
double target_of_unit(const LoadSection& load, const std::vector<TipResult>& nominal, double grown);

/// Largest load factor of a history. Where displacements are controlled it is that of the elastic body with
/// traction-free faces: what yields bears less. Throws CaseError where the loads do not move what is controlled.
double largest_load_factor(const LoadSection& load, const Structure& elastic, const std::vector<TipResult>& nominal,
                           double grown = 0.0);

}  // namespace stria::coarse
