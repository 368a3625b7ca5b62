// The residual's work along a correction is the same number however the body is shared out: what a line search goes by.
#include <gtest/gtest.h>

#include "app/run/monolithic/monolithic.hpp"
#include "coarse/equilibrium/condensed/condensed_factory.hpp"
#include "coarse/zone/zone_selection.hpp"
#include "coupling/ranks/fine_ranks.hpp"
#include "tests/support/sent_analysis.hpp"

namespace stria::test {
namespace {

class LineSearch : public testing::Test {
protected:
    /// Along the third correction, N: before it, behind it, and where some of it has been given back. (Before the first
    /// one the condensed structure bears its load already, and the monolithic one does not; the second one parts the
    /// faces, which touch at first.)
    struct Work {
        double before, behind, back;
    };

    [[nodiscard]] Work of_third_correction(coarse::EquilibriumFactory& factory) const {
        const Eigen::VectorXd at_rest = Eigen::VectorXd::Zero(scene.enriched.unknowns);
        const coupling::Patch patch = coarse::make_patch(scene, structure.in_zone(), structure.gamma(), at_rest);
        const std::unique_ptr<coarse::Equilibrium> body = factory.make(structure, &patch, at_rest, 0.0);
        body->begin({Control::Load, 150.0}, {});
        EXPECT_EQ(body->linearise().along, 0.0);  // there is no correction yet
        for (int correction = 1; correction <= 3; ++correction) {
            body->solve();
            body->apply();
            if (correction < 3) body->linearise();
        }
        const coarse::Residual behind = body->linearise();
        body->apply_further(-0.4);
        return {behind.along_before, behind.along, body->linearise().along};
    }

    [[nodiscard]] Work with_ranks(int ranks) const {
        std::vector<std::unique_ptr<fine::FineModel>> models;
        std::vector<coupling::FineScale*> each;
        for (int k = 0; k < ranks; ++k) each.push_back(models.emplace_back(new fine::FineModel(input)).get());
        coupling::FineRanks together(each, 1);
        coarse::CondensedFactory factory(&together, input);
        return of_third_correction(factory);
    }

    static void expect_same(const Work& a, const Work& b) {
        EXPECT_NEAR(a.before, b.before, 1e-10 * b.before);
        EXPECT_NEAR(a.behind, b.behind, 1e-10 * b.before);
        EXPECT_NEAR(a.back, b.back, 1e-10 * b.before);
    }

    const Case input = sent_case({mesh_at_tip(0.8), "fine.radius=15.0"});
    const coarse::Scene scene = coarse::refined_scene(input);
    const coarse::Structure structure{scene, coarse::select_zone(scene, {0.0})};
};

TEST_F(LineSearch, GoesByTheSameWorkInEachMode) {
    use_one_thread();
    MonolithicFactory monolithic(input);
    const Work whole = of_third_correction(monolithic);
    EXPECT_GT(std::abs(whole.behind), 1e-3 * whole.before);
    EXPECT_GT(whole.back, whole.behind);
    EXPECT_LT(whole.back, whole.before);
    expect_same(with_ranks(1), whole);
    expect_same(with_ranks(2), whole);
}

}  // namespace
}  // namespace stria::test
