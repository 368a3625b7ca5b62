#include "app/material/driven_point.hpp"

#include <gtest/gtest.h>

#include "app/material/cyclic_test.hpp"
#include "common/error.hpp"
#include "fine/material/catalogue/material_catalogue.hpp"
#include "tests/support/material_catalogue.hpp"

namespace stria::test {
namespace {

using material::Target;

TEST(DrivenPoint, BringsEachComponentToItsStrainOrStress) {
    for (const Law& law : catalogue()) {
        const auto own = fine::make_material_law(law.material, law.plane);
        material::DrivenPoint point(*own);
        const material::Targets targets{Target{Target::Of::Stress, 50.0}, Target{Target::Of::Strain, 4e-3},
                                        Target{Target::Of::Strain, 0.0}, Target{Target::Of::Stress, -60.0}};
        for (int repeated = 0; repeated < 2; ++repeated) {
            point.reach(targets);
            EXPECT_NEAR(point.tensor(fine::state::stress)[0], 50.0, 1e-8) << law.name;
            EXPECT_NEAR(point.tensor(fine::state::stress)[3], -60.0, 1e-8) << law.name;
            EXPECT_NEAR(point.strain()[1], 4e-3, 1e-15) << law.name;
            EXPECT_EQ(point.strain()[2], 0.0) << law.name;
        }
    }
}

TEST(DrivenPoint, GoesInPartsWhereOneIncrementIsTooLarge) {
    const auto law = fine::make_material_law(linear_steel(0.0, {{60e3, 300.0}}), PlaneState::Strain);
    material::DrivenPoint point(*law);
    material::Targets targets;
    for (const int c : {0, 1, 2}) targets[static_cast<std::size_t>(c)].of = Target::Of::Stress;
    targets[1].value = 549.9;  // of 550 that it bears at most
    point.reach(targets);
    EXPECT_NEAR(point.tensor(fine::state::stress)[1], 549.9, 1e-7);
}

TEST(DrivenPoint, FailsWhereTheMetalDoesNotBearTheStress) {
    const auto law = fine::make_material_law(linear_steel(0.0, {}), PlaneState::Stress);
    material::DrivenPoint point(*law);
    material::Targets targets;
    targets[0].of = Target::Of::Stress;
    targets[1] = {Target::Of::Stress, 351.0};
    EXPECT_THROW(point.reach(targets), NumericalFailure);
}

Case tested(TestMode mode, TestControl control, double size) {
    Case input;
    input.material = linear_steel(2000.0, {{4000.0, 0.0}});
    input.material_test = {.control = control, .mode = mode, .blocks = {{.cycles = 2, .max = size, .min = -size}}};
    return input;
}

// Hardening by 6000 MPa in all: plastic strains and stresses of the first maximum in closed form.
TEST(CyclicTest, FirstMaximumOfEachMode) {
    const double E = 200e3, nu = 0.3, H = 6000.0, G = E / (2.0 * (1.0 + nu));
    const auto first_maximum = [](const Case& input) {
        return material::go_through_cycles(input)[static_cast<std::size_t>(input.material_test->steps / 2)];
    };
    const double pulled = first_maximum(tested(TestMode::Uniaxial, TestControl::Strain, 0.01)).stress;
    EXPECT_NEAR(pulled, 350.0 + H / (1.0 + H / E) * (0.01 - 350.0 / E), 1e-8);
    // tau sqrt(3) = 350 + H gamma_p / sqrt(3)
    const double tau = first_maximum(tested(TestMode::Shear, TestControl::Strain, 0.02)).stress;
    EXPECT_NEAR(tau * std::sqrt(3.0), 350.0 + H * (0.02 - tau / G) / std::sqrt(3.0), 1e-8);
    const material::TestRow sheared = first_maximum(tested(TestMode::Shear, TestControl::Stress, 220.0));
    EXPECT_NEAR(sheared.strain, 220.0 / G + (220.0 * std::sqrt(3.0) - 350.0) * std::sqrt(3.0) / H, 1e-10);
    EXPECT_NEAR(sheared.back_stress, 4000.0 / 3.0 * sheared.plastic_strain, 1e-8);
    // In plane strain at most 2 / sqrt(3) times the stress at a plastic strain that is all of the strain.
    const double plane = first_maximum(tested(TestMode::Plane, TestControl::Strain, 0.01)).stress;
    const double most = 2.0 / std::sqrt(3.0) * (350.0 + H * 2.0 / std::sqrt(3.0) * 0.01);
    EXPECT_GT(plane, 0.95 * most);
    EXPECT_LT(plane, most);
}

TEST(CyclicTest, SumsUpEachCycle) {
    Case input = tested(TestMode::Uniaxial, TestControl::Strain, 0.01);
    input.material_test->blocks.push_back({.cycles = 1, .max = 0.02, .min = 0.0});
    const std::vector<material::TestRow> rows = material::go_through_cycles(input);
    const std::vector<material::CycleSummary> cycles = material::summaries(rows);
    ASSERT_EQ(cycles.size(), 3U);
    EXPECT_EQ(rows.size(), 1U + 7U * 100U);
    EXPECT_EQ(cycles[0].cycle, 1);
    EXPECT_NEAR(cycles[0].strain_max, 0.01, 1e-15);
    EXPECT_NEAR(cycles[0].strain_min, -0.01, 1e-15);
    EXPECT_NEAR(cycles[1].strain_max, 0.02, 1e-15);  // the way to the maximum of the next block belongs to it
    EXPECT_NEAR(cycles[2].strain_min, 0.0, 1e-15);
    double work = rows[100].work;
    for (const material::CycleSummary& cycle : cycles) work += cycle.dissipation + cycle.stored;
    EXPECT_NEAR(work, rows.back().work, 1e-3 * work);
}

}  // namespace
}  // namespace stria::test
