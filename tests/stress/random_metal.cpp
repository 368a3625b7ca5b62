#include "tests/stress/random_metal.hpp"

#include <algorithm>

#include "common/index.hpp"

namespace stria::test {
namespace {

/// What hardening adds to the yield stress, without the curves whose points begin with it.
void harden(MaterialSection& metal, double factor) {
    metal.isotropic.modulus *= factor;
    metal.isotropic.Q *= factor;
    for (KinematicHardening& term : metal.kinematic) {
        term.C *= factor;
        if (term.C_start) *term.C_start *= factor;
    }
}

}  // namespace

MaterialSection in_units(MaterialSection metal, double stress) {
    metal.young *= stress;
    if (metal.yield_stress) *metal.yield_stress *= stress;
    if (metal.isotropic.reference) *metal.isotropic.reference *= stress;
    for (double& value : metal.isotropic.stress) value *= stress;
    harden(metal, stress);
    return metal;
}

Law random_law(Dice& dice) {
    const std::vector<Law>& laws = catalogue();
    Law law = laws[at(dice.below(static_cast<int>(laws.size())))];
    if (dice.one_in(2)) harden(law.material, dice.decade(-6.0, 3.0));
    if (law.material.yield_stress)  // what softens keeps some of it
        law.material.isotropic.Q = std::max(law.material.isotropic.Q, -0.9 * *law.material.yield_stress);
    if (dice.one_in(3)) law.material.isotropic.n = dice.decade(0.0, 2.0);
    if (dice.one_in(3)) law.material.poisson = 0.4999;
    return law;
}

}  // namespace stria::test
