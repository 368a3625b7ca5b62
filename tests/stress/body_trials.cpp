#include "tests/stress/body_trials.hpp"

#include <cmath>
#include <fmt/format.h>
#include <optional>

#include "coarse/specimen/handbook.hpp"
#include "common/error.hpp"
#include "tests/stress/random_metal.hpp"
#include "tests/support/sent_analysis.hpp"
#include "tests/support/specimens.hpp"

namespace stria::test {
namespace {

enum class Hardening { None, Some, Extreme };

struct RandomBody {
    Case input;
    Hardening hardening = Hardening::None;
    double share = 0.0;  // of the limit load without hardening

    /// The elements bear more than the formula says: what lies between that and twice as much nobody knows.
    [[nodiscard]] bool must_bear() const { return share < 1.0 || hardening != Hardening::None; }
    [[nodiscard]] bool beyond() const { return share > 2.0 && hardening == Hardening::None; }
    [[nodiscard]] std::string text() const {
        return fmt::format("{}, plane {}, {:.2f} of the limit load, nu = {:.4g}: ", input.mesh.specimen,
                           input.model.plane == PlaneState::Strain ? "strain" : "stress", share,
                           input.material.poisson);
    }
    [[nodiscard]] std::string kind() const {
        return hardening == Hardening::None   ? "perfect plasticity"
               : hardening == Hardening::Some ? "little hardening"
                                              : "extreme hardening";
    }
};

MaterialSection random_metal(Hardening hardening, Dice& dice) {
    MaterialSection metal = linear_steel(0.0, {});
    if (hardening == Hardening::Some) metal.isotropic.modulus = metal.young * dice.decade(-6.0, -3.0);
    if (hardening == Hardening::Extreme) metal.isotropic.modulus = metal.young * dice.decade(-0.5, 2.0);
    if (hardening == Hardening::Extreme && dice.one_in(2)) {
        metal.kinematic = {{metal.isotropic.modulus, dice.one_in(2) ? 100.0 : 0.0}};
        metal.isotropic.modulus = 0.0;
    }
    if (dice.one_in(2)) metal.poisson = dice.one_in(2) ? 0.4999 : dice.between(0.0, 0.49);
    return metal;
}

RandomBody random_body(unsigned seed) {
    Dice dice(seed);
    RandomBody body;
    const bool edge = dice.one_in(2);
    const double x = dice.between(0.3, 0.6);
    body.input = edge ? edge_crack(x, 2.0, End::Pulled) : middle_crack(x, 2.0);
    body.input.mesh.size = 0.1;
    body.input.model.plane = dice.one_in(2) ? PlaneState::Strain : PlaneState::Stress;
    body.hardening = static_cast<Hardening>(dice.below(3));
    body.input.material = random_metal(body.hardening, dice);
    body.share = dice.one_in(3) ? 2.5 : dice.between(0.2, 1.0);
    if (body.hardening != Hardening::None) body.share = dice.between(0.2, 0.9);
    const double sigma = *body.input.material.yield_stress;
    const double limit = edge ? coarse::sent_limit_load(1.0, x, sigma, body.input.model.plane)
                              : coarse::mt_limit_load(1.0, 0.5 * x, sigma, body.input.model.plane);
    const double load = body.share * limit;
    body.input.solver.tolerance = 1e-10;
    body.input.load = {.steps = 16, .blocks = {{.cycles = 0, .max = load, .min = 0.0}}};
    return body;
}

Case case_in_units(Case input, double length, double stress) {
    input.mesh.width *= length;
    input.mesh.height *= length;
    input.mesh.size *= length;
    for (Vec2& point : input.cracks[0].points) point *= length;
    input.material = in_units(input.material, stress);
    input.load.blocks[0].max *= stress;
    return input;
}

/// J of each tip at the end, N/mm.
std::vector<double> J_of(const Case& input) {
    const RunHistory history = run_direct(input);
    std::vector<double> found;
    for (const coarse::TipResult& tip : history.increments.back().tips) found.push_back(tip.J);
    return found;
}

void compare_units(const RandomBody& body, unsigned seed, Tally& tally) {
    const std::vector<double> here = J_of(body.input);
    if (body.beyond()) return tally.fail(body.kind(), seed, body.text() + "it is borne");
    for (const auto& [length, stress] : {std::pair{0x1p-20, 1.0}, {0x1p20, 1.0}, {1.0, 0x1p-20}, {1.0, 0x1p20}}) {
        const std::vector<double> there = J_of(case_in_units(body.input, length, stress));
        double off = here.size() == there.size() ? 0.0 : INFINITY;
        for (std::size_t t = 0; t < here.size() && t < there.size(); ++t)
            off = std::max(off, std::abs(there[t] / (length * stress * here[t]) - 1.0));
        tally.measure("J, in other units, " + body.kind(), seed, off, 1e-8);
    }
}

}  // namespace

void try_body(unsigned seed, Tally& tally) {
    const RandomBody body = random_body(seed);
    try {
        compare_units(body, seed, tally);
    } catch (const NumericalFailure& failure) {
        if (body.must_bear()) return tally.fail(body.kind(), seed, body.text() + failure.what());
        tally.refuse(failure.what(), seed);
    } catch (const std::exception& error) {
        tally.fail(body.kind(), seed, body.text() + error.what());
    }
}

}  // namespace stria::test
