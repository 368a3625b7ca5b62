// What must hold for a body that flows: up to its limit load, beyond it, and in any units.
#pragma once

#include "tests/stress/tally.hpp"

namespace stria::test {

/// A random specimen of a random metal. What bears its load has the same J in other units; beyond the limit load of
/// perfect plasticity the run ends with its sentence.
void try_body(unsigned seed, Tally& tally);

}  // namespace stria::test
