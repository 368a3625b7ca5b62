// What must hold for a crack wherever it lies in the mesh.
#pragma once

#include "tests/stress/random_crack.hpp"
#include "tests/stress/tally.hpp"

namespace stria::test {

/// Patch test, pressure under uniform compression, stress intensities of exact fields, and conditioning. `seed`: what
/// failures are reported with.
void try_crack(const CrackedPlate& plate, unsigned seed, Tally& tally);

}  // namespace stria::test
