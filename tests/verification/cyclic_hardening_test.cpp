// Uniaxial cycles of every law that hardens against the solution of its differential equations, which is in closed form
// on each branch, and against published values (docs/references.md 6.4, 6.5, 8.6).
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <iostream>
#include <numbers>
#include <utility>
#include <vector>

#include "app/material/cyclic_test.hpp"
#include "app/material/driven_point.hpp"
#include "common/index.hpp"
#include "fine/material/catalogue/material_catalogue.hpp"
#include "fine/material/hardening_curve.hpp"
#include "tests/support/comparison.hpp"
#include "tests/support/material_catalogue.hpp"
#include "tests/support/material_point.hpp"
#include "tests/support/sent_analysis.hpp"

namespace stria::test {
namespace {

/// A bar without error: on a branch of direction s dX = (s C(p) - gamma X) dp, an exponential in dp, and a back stress
/// with a threshold grows by s C dp up to its limit.
class ExactBar {
public:
    explicit ExactBar(const MaterialSection& material)
        : material_(material), curve_(material), back_(material.kinematic.size(), 0.0) {}

    void strain_to(double strain) {
        const double s = strain > strain_ ? 1.0 : -1.0;
        const double dp = flow([&](double by) { return s * (material_.young * (strain - plastic_ - s * by)); }, s);
        go(s, dp);
        strain_ = strain;
    }

    void load_to(double stress) {
        const double s = stress > this->stress() ? 1.0 : -1.0;
        go(s, flow([&](double) { return s * stress; }, s));
        strain_ = plastic_ + stress / material_.young;
    }

    [[nodiscard]] double stress() const { return material_.young * (strain_ - plastic_); }
    [[nodiscard]] double plastic_strain() const { return plastic_; }

private:
    [[nodiscard]] double back_stress(std::size_t k, double s, double dp) const {
        const KinematicHardening& term = material_.kinematic[k];
        const double linear = back_[k] + s * term.C * dp;
        if (term.gamma == 0.0) return linear;
        const double limit = term.C / term.gamma, left = std::exp(-term.gamma * dp);
        if (term.threshold) return std::clamp(linear, -limit, limit);
        const double missing = (term.C_start.value_or(term.C) - term.C) * std::exp(-term.C_rate * p_);
        const double growing = missing * (std::exp(-term.C_rate * dp) - left) / (term.gamma - term.C_rate);
        return s * (limit * (1.0 - left) + growing) + back_[k] * left;
    }

    /// s times the stress on the yield surface.
    [[nodiscard]] double resistance(double s, double dp) const {
        double sum = *material_.yield_stress + curve_.value(p_ + dp);
        for (std::size_t k = 0; k < back_.size(); ++k) sum += s * back_stress(k, s, dp);
        return sum;
    }

    /// The dp at which s times the stress that is asked for is borne.
    template <class Asked> [[nodiscard]] double flow(const Asked& asked, double s) const {
        if (asked(0.0) <= resistance(s, 0.0)) return 0.0;
        double below = 0.0, above = 1.0;
        for (int k = 0; k < 200; ++k) {
            const double middle = 0.5 * (below + above);
            (asked(middle) > resistance(s, middle) ? below : above) = middle;
        }
        return 0.5 * (below + above);
    }

    void go(double s, double dp) {
        for (std::size_t k = 0; k < back_.size(); ++k) back_[k] = back_stress(k, s, dp);
        p_ += dp;
        plastic_ += s * dp;
    }

    const MaterialSection& material_;
    fine::HardeningCurve curve_;
    std::vector<double> back_;
    double p_ = 0.0, plastic_ = 0.0, strain_ = 0.0;
};

/// Of one cycle: stress and plastic strain at its minimum and at the maximum that ends it.
struct Turns {
    double stress_at_min, stress_at_max, plastic_at_min, plastic_at_max;
};

std::vector<Turns> turns_of(const Case& input) {
    std::vector<Turns> all;
    const std::vector<material::TestRow> rows = material::go_through_cycles(input);
    const int half = input.material_test->steps / 2;
    for (std::size_t end = at(3 * half); end < rows.size(); end += at(2 * half)) {
        const material::TestRow &minimum = rows[end - at(half)], &maximum = rows[end];
        all.push_back({minimum.stress, maximum.stress, minimum.plastic_strain, maximum.plastic_strain});
    }
    return all;
}

/// Backward Euler is of first order: twice as many increments halve the error, and twice theirs less these have none.
std::vector<Turns> extrapolated_turns(Case input) {
    const std::vector<Turns> some = turns_of(input);
    input.material_test->steps *= 2;
    std::vector<Turns> more = turns_of(input);
    for (std::size_t k = 0; k < more.size(); ++k)
        for (double Turns::*value :
             {&Turns::stress_at_min, &Turns::stress_at_max, &Turns::plastic_at_min, &Turns::plastic_at_max})
            more[k].*value = 2.0 * more[k].*value - some[k].*value;
    return more;
}

Case tested(const MaterialSection& material, PlaneState plane, TestControl control, LoadBlock block, int steps) {
    Case input;
    input.material = material;
    input.model.plane = plane;
    input.fine.substeps = 1;
    input.material_test = {.control = control, .mode = TestMode::Uniaxial, .blocks = {block}, .steps = steps};
    return input;
}

class CyclicBar : public testing::TestWithParam<Law> {};

INSTANTIATE_TEST_SUITE_P(Catalogue, CyclicBar, testing::ValuesIn(catalogue().begin() + 1, catalogue().end()),
                         [](const auto& law) { return law.param.name; });

// Between strains of -0.2 and 1 %: what recalls loses its mean stress.
TEST_P(CyclicBar, RelaxesItsMeanStress) {
    const Law& law = GetParam();
    if (!law.material.yield_stress) return;
    const LoadBlock block{.cycles = 12, .max = 0.01, .min = -0.002};
    const std::vector<Turns> found =
        extrapolated_turns(tested(law.material, law.plane, TestControl::Strain, block, 400));
    ExactBar exact(law.material);
    exact.strain_to(block.max);
    const double scale = exact.stress();
    for (const Turns& turns : found) {
        exact.strain_to(block.min);
        const double at_min = exact.stress();
        EXPECT_NEAR(turns.stress_at_min, at_min, 1e-4 * scale);
        exact.strain_to(block.max);
        EXPECT_NEAR(turns.stress_at_max, exact.stress(), 1e-4 * scale);
        EXPECT_NEAR(turns.stress_at_max + turns.stress_at_min, exact.stress() + at_min, 1e-4 * scale);
    }
}

// Between stresses that the metal bears and that make it flow.
TEST_P(CyclicBar, RatchetsFromCycleToCycle) {
    const Law& law = GetParam();
    if (law.material.kinematic.empty()) return;
    const LoadBlock block{.cycles = 8, .max = 430.0, .min = -380.0};
    const std::vector<Turns> found =
        extrapolated_turns(tested(law.material, law.plane, TestControl::Stress, block, 600));
    ExactBar exact(law.material);
    exact.load_to(block.max);
    const double scale = exact.plastic_strain();
    for (const Turns& turns : found) {
        exact.load_to(block.min);
        EXPECT_NEAR(turns.plastic_at_min, exact.plastic_strain(), 1e-4 * scale);
        exact.load_to(block.max);
        EXPECT_NEAR(turns.plastic_at_max, exact.plastic_strain(), 1e-4 * scale);
    }
}

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

const std::vector<std::string> two_back_stresses_and_voce{
    "material.kinematic=[{C=60e3, gamma=300.0}, {C=4e3, gamma=20.0}]",
    "material.isotropic={law=\"voce\", Q=60.0, b=10.0}"};

// What a run costs beside Prager's metal, in counts: the crack grows and closes in each of four cycles.
TEST(CyclicHardening, AClosureRunWithTwoBackStressesLosesNoIncrement) {
    const auto iterations = [](const std::vector<std::string>& metal) {
        std::vector<std::string> scene{mesh_at_tip(0.4), "load.blocks=[{cycles=4, max=45.0, ratio=0.0}]",
                                       "growth.increment=0.4", "closure.distance=0.5"};
        scene.insert(scene.end(), metal.begin(), metal.end());
        const RunHistory run = run_direct(sent_case(scene));
        EXPECT_EQ(run.cuts, 0);
        int count = 0;
        for (const auto& [step, report] : run.attempts) count += report.count();
        return count;
    };
    const int prager = iterations({"material.kinematic=[{C=4000.0}]"}),
              recalling = iterations(two_back_stresses_and_voce);
    EXPECT_LT(recalling, 1.1 * prager);
}

// The same of a crack that grows through small elements (bench/growing_cycle). What a point costs more is told beside
// it: in plane strain Prager's metal returns in closed form.
TEST(CyclicHardening, TwoBackStressesAskForLittleMoreThanPragersLong) {
    struct Effort {
        std::int64_t iterations = 0, points = 0;
        double seconds = 0.0;
    };
    const auto effort_of = [](const char* plane, const std::vector<std::string>& metal) {
        std::vector<std::string> scene{fmt::format("model.plane={}", plane),
                                       "load.blocks=[{cycles=5, max=50.0, ratio=0.0}]"};
        scene.insert(scene.end(), metal.begin(), metal.end());
        const Case input = read_case(std::string(source_folder) + "/bench/growing_cycle/case.toml", scene);
        const std::clock_t start = std::clock();
        const RunHistory run = run_direct(input);
        Effort effort{.points = run.increments.back().zone.work.points_evaluated};
        for (const auto& [step, report] : run.attempts) effort.iterations += report.count();
        effort.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        return effort;
    };
    for (const char* plane : {"strain", "stress"}) {
        const Effort prager = effort_of(plane, {}), recalling = effort_of(plane, two_back_stresses_and_voce);
        std::cout << fmt::format(
            "plane {}, Prager, two back stresses and Voce: {} and {} iterations, {} and {} points, "
            "{:.2f} and {:.2f} s\n",
            plane, prager.iterations, recalling.iterations, prager.points, recalling.points, prager.seconds,
            recalling.seconds);
        EXPECT_LT(10 * recalling.iterations, 11 * prager.iterations) << plane;
        EXPECT_LT(10 * recalling.points, 11 * prager.points) << plane;
    }
}

}  // namespace
}  // namespace stria::test
