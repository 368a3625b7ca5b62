// What must hold for a metal wherever its strain goes.
#pragma once

#include "tests/stress/tally.hpp"

namespace stria::test {

/// A random law on a random path, at once and in parts: yield surface, dissipation, the stress of the elastic strain,
/// and the same in other units.
void try_law(unsigned seed, Tally& tally);

}  // namespace stria::test
