// Random metals, of every law of the catalogue and with hardening that is extreme, in any units.
#pragma once

#include "tests/stress/random_crack.hpp"
#include "tests/support/material_catalogue.hpp"

namespace stria::test {

/// In units of stress that are so much smaller.
MaterialSection in_units(MaterialSection metal, double stress);

/// That of a law of the catalogue, or harder and softer by decades; nu to 0.4999.
Law random_law(Dice& dice);

}  // namespace stria::test
