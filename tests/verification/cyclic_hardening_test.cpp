// Uniaxial cycles of laws that harden against closed forms and published values (docs/references.md 6.4, 6.5, 8.6, 8.8,
// 8.9).
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "app/material/driven_point.hpp"
#include "common/index.hpp"
#include "fine/material/catalogue/material_catalogue.hpp"
#include "tests/support/comparison.hpp"
#include "tests/support/cyclic_turns.hpp"
#include "tests/support/material_catalogue.hpp"
#include "tests/support/material_point.hpp"

namespace stria::test {
namespace {

// Where the limits of the same curve are thresholds nothing ratchets.
TEST(CyclicHardening, ThresholdsDoNotRatchetInABar) {
    MaterialSection steel = linear_hardening(250.0);
    steel.kinematic = multilinear;
    const std::vector<Turns> found = turns_of(
        tested(steel, PlaneState::Strain, TestControl::Stress, {.cycles = 6, .max = 430.0, .min = -380.0}, 200));
    for (std::size_t k = 1; k < found.size(); ++k) EXPECT_NEAR(found[k].plastic_at_max, found[0].plastic_at_max, 1e-10);
    for (KinematicHardening& term : steel.kinematic) term.threshold = false;
    const std::vector<Turns> recalled = turns_of(
        tested(steel, PlaneState::Strain, TestControl::Stress, {.cycles = 6, .max = 430.0, .min = -380.0}, 200));
    for (std::size_t k = 1; k < recalled.size(); ++k)
        EXPECT_GT(recalled[k].plastic_at_max - recalled[k - 1].plastic_at_max, 1e-4);
}

MaterialSection armstrong_frederick() {
    MaterialSection steel = linear_hardening(200.0);
    steel.kinematic = {{62400.0, 300.0}};
    return steel;
}

// references 6.5: the stress cycle between 300 and -250 MPa.
TEST(CyclicHardening, ArmstrongAndFrederickRatchetBySoMuchACycle) {
    const double L = 62400.0 / 300.0, at_max = 300.0 - 200.0, at_min = -250.0 + 200.0;
    const double ratchet = std::log((L * L - at_min * at_min) / (L * L - at_max * at_max)) / 300.0;
    for (const PlaneState plane : {PlaneState::Strain, PlaneState::Stress}) {
        const Case input =
            tested(armstrong_frederick(), plane, TestControl::Stress, {.cycles = 5, .max = 300.0, .min = -250.0}, 800);
        const std::vector<Turns> found = extrapolated_turns(input);
        double before = 2.18468951e-3;
        for (const Turns& turns : found) {
            EXPECT_NEAR(turns.plastic_at_max - before, ratchet, 1e-4 * ratchet);
            before = turns.plastic_at_max;
        }
        const auto row = [&](const std::string& quantity, double reference, double ours, double scale) {
            verify({.scene = fmt::format("Armstrong and Frederick, 300 and -250 MPa, {}",
                                         plane == PlaneState::Strain ? "plane strain" : "plane stress"),
                    .source = "closed form (6.5)",
                    .quantity = quantity,
                    .reference = reference,
                    .ours = ours,
                    .within = 1e-4,
                    .mesh = "800 and 1600 a cycle",
                    .scale = scale});
        };
        row("first minimum of the plastic strain, of its maximum", -4.03263e-5, found[0].plastic_at_min, 2.18468951e-3);
        row("ratchet of the fifth cycle", ratchet, found[4].plastic_at_max - found[3].plastic_at_max, ratchet);
    }
}

// With parts within an error bound the increments of a run are enough: nothing is extrapolated.
TEST(CyclicHardening, TwentyIncrementsInPartsRatchetAsExactly) {
    const double L = 62400.0 / 300.0, at_max = 300.0 - 200.0, at_min = -250.0 + 200.0;
    for (const PlaneState plane : {PlaneState::Strain, PlaneState::Stress}) {
        Case input =
            tested(armstrong_frederick(), plane, TestControl::Stress, {.cycles = 5, .max = 300.0, .min = -250.0}, 20);
        input.fine.substeps = 40;
        const std::vector<Turns> found = turns_of(input);
        verify({.scene = fmt::format("Armstrong and Frederick in parts, 300 and -250 MPa, {}",
                                     plane == PlaneState::Strain ? "plane strain" : "plane stress"),
                .source = "closed form (6.5)",
                .quantity = "ratchet of the fifth cycle",
                .reference = std::log((L * L - at_min * at_min) / (L * L - at_max * at_max)) / 300.0,
                .ours = found[4].plastic_at_max - found[3].plastic_at_max,
                .within = 1e-4,
                .mesh = "20 a cycle"});
    }
}

/// references 6.5, with R = Q: sigma = sigma_y + Q + C / gamma tanh(gamma (eps - sigma / E)), by bisection.
double settled_stress(const MaterialSection& steel, double Q, double strain) {
    const KinematicHardening& back = steel.kinematic[0];
    double below = 0.0, above = steel.young * strain;
    for (int halving = 0; halving < 60; ++halving) {
        const double stress = 0.5 * (below + above), plastic = strain - stress / steel.young;
        const double borne = *steel.yield_stress + Q + back.C / back.gamma * std::tanh(back.gamma * plastic);
        (stress < borne ? below : above) = stress;
    }
    return below;
}

// The range of the stress falls, from the first pull on, and settles.
TEST(CyclicHardening, ASteelThatSoftensUnderCyclesSettles) {
    MaterialSection steel = armstrong_frederick();
    steel.isotropic = {.law = HardeningLaw::Voce, .Q = -70.0, .b = 20.0};
    constexpr double strain = 0.006;
    for (const PlaneState plane : {PlaneState::Strain, PlaneState::Stress}) {
        const std::vector<Turns> found = extrapolated_turns(
            tested(steel, plane, TestControl::Strain, {.cycles = 60, .max = strain, .min = -strain}, 200));
        for (std::size_t k = 1; k < 30; ++k) EXPECT_LT(found[k].stress_at_max, found[k - 1].stress_at_max);
        EXPECT_GT(found[0].stress_at_max, found.back().stress_at_max + 30.0);
        verify({.scene = fmt::format("Armstrong and Frederick that soften by 70 MPa, strain +-0.006, settled, {}",
                                     plane == PlaneState::Strain ? "plane strain" : "plane stress"),
                .source = "closed form (6.5)",
                .quantity = "stress, MPa",
                .reference = settled_stress(steel, -70.0, strain),
                .ours = found.back().stress_at_max,
                .within = 1e-4,
                .mesh = "200 and 400 a cycle"});
    }
}

// references 6.5: the stress at the tip of a cycle that repeats itself.
TEST(CyclicHardening, StabilisedCyclesOfArmstrongAndFrederick) {
    for (const auto& [amplitude, stress] : {std::pair{0.006, 375.648175}, {0.004, 326.962823}, {0.01, 404.558006}}) {
        const Case input = tested(armstrong_frederick(), PlaneState::Strain, TestControl::Strain,
                                  {.cycles = 12, .max = amplitude, .min = -amplitude}, 400);
        const Turns last = extrapolated_turns(input).back();
        verify({.scene = fmt::format("Armstrong and Frederick, strain +-{}, settled", amplitude),
                .source = "closed form (6.5)",
                .quantity = "stress, MPa",
                .reference = stress,
                .ours = last.stress_at_max,
                .within = 2e-5,
                .mesh = "400 and 800 a cycle"});
        EXPECT_NEAR(last.stress_at_min, -stress, 2e-5 * stress);
        EXPECT_NEAR(last.plastic_at_max, amplitude - stress / 200e3, 2e-5 * amplitude);
    }
}

/// p, eps_xx and eps_xy of references 6.4: sigma_xx and sigma_xy grow alike up to 143.5 MPa.
Eigen::Vector3d chaboche_in_tension_and_shear(int steps) {
    MaterialSection steel = linear_hardening(87.0);
    steel.young = 145200.0;
    steel.isotropic = {.law = HardeningLaw::Voce, .Q = 64.0, .b = 2.3};
    for (const auto& [limit, gamma] : {std::pair{187.0, 341.0}, {29.0, 17184.0}})
        steel.kinematic.push_back({limit * gamma, gamma, false, (1.0 - 0.57) * limit * gamma, 6.09});
    const auto law = fine::make_material_law(steel, PlaneState::Strain);
    material::DrivenPoint point(*law);
    material::Targets targets;
    for (material::Target& target : targets) target.of = material::Target::Of::Stress;
    for (int k = 1; k <= steps; ++k) {
        targets[0].value = 143.5 * k / steps;
        targets[3].value = std::numbers::sqrt2 * targets[0].value;
        point.reach(targets);
    }
    return {point.scalar(fine::state::accumulated), point.strain()[0], point.strain()[3] / std::numbers::sqrt2};
}

TEST(CyclicHardening, ChabocheInTensionAndShearSsnv101) {
    const Eigen::Vector3d exact{0.191988, 0.096982, 0.145276};
    const Eigen::Vector3d some = chaboche_in_tension_and_shear(2000), more = chaboche_in_tension_and_shear(4000);
    const Eigen::Vector3d found = 2.0 * more - some;
    const std::array quantities{"p", "eps_xx", "eps_xy"};
    for (int i = 0; i < 3; ++i)
        verify({.scene = "Chaboche's law in tension and shear",
                .source = "Code_Aster SSNV101 (6.4)",
                .quantity = quantities[at(i)],
                .reference = exact[i],
                .ours = found[i],
                .within = 1e-4,
                .mesh = "2000 and 4000 increments"});
}

// references 8.6.
TEST(CyclicHardening, VoceAndTwoBackStressesThatForget) {
    MaterialSection steel = linear_hardening(318.5);
    steel.young = 179800.0;
    steel.isotropic = {.law = HardeningLaw::Voce, .Q = 100.7, .b = 8.0};
    steel.kinematic = {{11608.2, 145.2}, {1026.0, 4.7}};
    const auto pulled = [&](PlaneState plane, double strain, int steps) {
        MaterialPoint bar(steel, plane);
        double stress = 0.0;
        for (int k = 1; k <= steps; ++k) stress = bar.uniaxial(strain * k / steps);
        return stress;
    };
    for (const PlaneState plane : {PlaneState::Strain, PlaneState::Stress}) {
        for (const auto& [strain, stress] : {std::pair{0.002, 321.32308726}, {0.05, 473.69256403}}) {
            const double some = pulled(plane, strain, 200), more = pulled(plane, strain, 400);
            verify({.scene = fmt::format("Voce and two back stresses, {}",
                                         plane == PlaneState::Strain ? "plane strain" : "plane stress"),
                    .source = "Hartloper and others, UVC (8.6)",
                    .quantity = fmt::format("stress at the strain {}, MPa", strain),
                    .reference = stress,
                    .ours = more,
                    .within = 1e-4,
                    .mesh = "400 increments"});
            EXPECT_NEAR((some - stress) / (more - stress), 2.0, 0.05);
        }
    }
}

// references 8.7: two back stresses ratchet between 320 and -240 MPa.
TEST(CyclicHardening, TwoBackStressesRatchet) {
    MaterialSection steel = linear_hardening(200.0);
    steel.kinematic = {{60000.0, 600.0}, {20000.0, 50.0}};
    const std::vector<Turns> found = extrapolated_turns(
        tested(steel, PlaneState::Strain, TestControl::Stress, {.cycles = 10, .max = 320.0, .min = -240.0}, 800));
    for (const auto& [cycle, plastic_strain] : {std::pair(2, 0.0029907969), {5, 0.0042713754}, {10, 0.0061539777}})
        verify({.scene = "two back stresses, 320 and -240 MPa",
                .source = "closed form (8.7)",
                .quantity = fmt::format("plastic strain at the maximum of cycle {}", cycle),
                .reference = plastic_strain,
                .ours = found[at(cycle - 2)].plastic_at_max,  // a turn begins with its minimum
                .within = 1e-4,
                .mesh = "800 and 1600 a cycle"});
}

// references 8.7: the mean stress of strains between 0 and 1 % relaxes.
TEST(CyclicHardening, TheMeanStressOfArmstrongAndFrederickRelaxes) {
    const std::vector<Turns> found = extrapolated_turns(tested(
        armstrong_frederick(), PlaneState::Strain, TestControl::Strain, {.cycles = 40, .max = 0.01, .min = 0.0}, 400));
    const auto row = rows_of({.scene = "Armstrong and Frederick, strain 0 to 0.01",
                              .source = "closed form (8.7)",
                              .within = 1e-4,
                              .mesh = "400 and 800 a cycle"});
    row("stress at the first minimum, MPa", -348.175393, found.front().stress_at_min);
    row("stress at the last minimum, MPa", -355.440854, found.back().stress_at_min);
    row("stress at the last maximum, MPa", 355.440854, found.back().stress_at_max);
}

// references 8.8: four layers side by side that yield at 100 to 400 MPa are one yield stress and three thresholds, of
// 50 MPa each, that are reached where the next layer yields.
TEST(CyclicHardening, ThresholdsAreBesselingsLayers) {
    MaterialSection layers = linear_hardening(100.0);
    for (const double plastic_strain : {1.25e-4, 3.75e-4, 7.5e-4}) {
        const double C = 50.0 / plastic_strain;
        layers.kinematic.push_back({C, C / 50.0, true});
    }
    MaterialPoint bar(layers);
    double strain = 0.0;
    for (const auto& [next, stress] :
         {std::pair(0.0005, 100.0), {0.001, 175.0}, {0.003, 250.0}, {0.0015, -25.0}, {0.0, -200.0}, {-0.003, -250.0}}) {
        double found = 0.0;
        for (int k = 1; k <= 100; ++k) found = bar.uniaxial(strain + (next - strain) * k / 100);
        strain = next;
        verify({.scene = "four layers in parallel, as thresholds",
                .source = "Besseling 1958, closed form (8.8)",
                .quantity = fmt::format("stress at the strain {}, MPa", next),
                .reference = stress,
                .ours = found,
                .within = 1e-6,
                .mesh = "100 increments"});
    }
}

// references 8.9: a structural steel of class S355, saturated.
TEST(CyclicHardening, AFittedStructuralSteelSaturates) {
    MaterialSection steel = linear_hardening(255.416);
    steel.young = 185115.0;
    steel.isotropic = {.law = HardeningLaw::Voce, .Q = 91.727, .b = 9.595};
    steel.kinematic = {{1761.99, 3.549}, {17430.5, 157.279}};
    const Turns last = extrapolated_turns(tested(steel, PlaneState::Strain, TestControl::Strain,
                                                 {.cycles = 60, .max = 0.01, .min = -0.01}, 200))
                           .back();
    verify({.scene = "fitted structural steel, strain +-0.01, saturated",
            .source = "RESSPyLab, S355 (8.9)",
            .quantity = "stress, MPa",
            .reference = 452.4467,
            .ours = last.stress_at_max,
            .within = 1e-4,
            .mesh = "200 and 400 a cycle"});
}

}  // namespace
}  // namespace stria::test
