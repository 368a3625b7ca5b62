// The paper's first example in plane stress, on a coarser mesh: converges like plane strain, condensed and monolithic.
#include <gtest/gtest.h>

#include "app/run/monolithic/monolithic.hpp"
#include "tests/support/sent_analysis.hpp"

namespace stria::test {
namespace {

Case sheet_case() {
    return sent_case({mesh_at_tip(0.3), "mesh.size=10.0", "solver.tolerance=1e-12", "model.plane=stress"});
}

TEST(SentInPlaneStress, ReleasesWhatItsModulusSaysAndFlowsMoreThanPlaneStrain) {
    const RunHistory thin = run_direct(sheet_case());
    Case input = sheet_case();
    input.model.plane = PlaneState::Strain;
    const RunHistory thick = run_direct(input);
    EXPECT_EQ(thin.cuts, 0);
    for (const coarse::Increment& increment : thin.increments) EXPECT_LE(increment.newton.count(), 12);
    const coarse::TipResult &tip = thin.at_maximum().tips[0], &other = thick.at_maximum().tips[0];
    EXPECT_NEAR(thin.nominal[0].K_I, thick.nominal[0].K_I, 0.01 * thick.nominal[0].K_I);
    EXPECT_NEAR(thin.nominal[0].J * 0.91, thick.nominal[0].J, 0.02 * thick.nominal[0].J);
    EXPECT_GT(tip.J, thin.nominal[0].J * 2500.0);
    EXPECT_GT(tip.plastic_zone_axis, 2.0 * other.plastic_zone_axis);  // ahead of the tip: no constraint
    EXPECT_GT(thin.at_minimum().zone.contact_length[0], 15.0);
    EXPECT_EQ(thin.at_maximum().zone.contact_length[0], 0.0);
}

TEST(SentInPlaneStress, ConvergesQuadraticallyOnceBranchesHaveSettled) {
    const RunHistory run = run_direct(sheet_case());
    int steps = 0;
    for (const coarse::Increment& increment : run.increments) {
        for (const Correction& correction : settled_corrections(increment)) {
            EXPECT_LT(correction.after, std::max(correction.bound(1e3), 1e-12)) << increment.newton.table();
            ++steps;
        }
    }
    EXPECT_GT(steps, 50);
}

TEST(SentInPlaneStress, MonolithicIsTheSameToRoundingLong) {
    const RunHistory direct = run_direct(sheet_case());
    MonolithicFactory factory(sheet_case());
    const RunHistory whole = run_analysis(sheet_case(), factory);
    ASSERT_EQ(whole.increments.size(), direct.increments.size());
    const coarse::TipResult& scale = direct.at_maximum().tips[0];
    for (std::size_t k = 0; k < whole.increments.size(); ++k) {
        const coarse::TipResult &p = direct.increments[k].tips[0], &q = whole.increments[k].tips[0];
        EXPECT_NEAR(p.J, q.J, 1e-9 * scale.J) << k;
        EXPECT_NEAR(p.K_I, q.K_I, 1e-9 * scale.K_I) << k;
        EXPECT_NEAR(p.CMOD, q.CMOD, 1e-9 * scale.CMOD) << k;
        EXPECT_NEAR(direct.increments[k].work.dissipated, whole.increments[k].work.dissipated,
                    1e-9 * direct.increments.back().work.dissipated)
            << k;
    }
}

}  // namespace
}  // namespace stria::test
