// The committed displacement is that of the last commit whoever asks for it, and far elements are asked as seldom as
// may be.
#include "coarse/analysis/committed_displacement.hpp"

#include <gtest/gtest.h>

#include "coarse/equilibrium/condensed/condensed_equilibrium.hpp"
#include "coarse/equilibrium/newton.hpp"
#include "coarse/zone/refined_scene.hpp"
#include "tests/support/pulled_plate.hpp"

namespace stria::coarse {
namespace {

/// Of an elastic plate with far elements.
class CommittedDisplacementOf : public testing::Test {
protected:
    static Scene pulled() {
        Case input = test::pulled_plate(0.5, false, false);
        input.mesh.width = input.mesh.height = 40.0;
        input.cracks[0].points = {{0.0, 20.2}, {7.3, 20.2}};
        return refined_scene(input);
    }

    void commit(double load_factor) {
        const Target target{.value = load_factor};
        ASSERT_TRUE(find_equilibrium(equilibrium, target, Predictor(), {scene.input.solver}).converged);
        static_cast<void>(equilibrium.commit({}));
        committed.fall_behind();
    }
    [[nodiscard]] Eigen::VectorXd whole(double load_factor) const { return structure.expand({}, load_factor, 1.0); }
    [[nodiscard]] bool is(const Eigen::VectorXd& u, double load_factor) const {
        const Eigen::VectorXd wanted = whole(load_factor);
        return (u - wanted).norm() <= 1e-12 * wanted.norm();
    }

    const Scene scene = pulled();
    const EnrichedMesh& mesh = scene.enriched;
    const Structure structure{scene};
    const Eigen::VectorXd unloaded = Eigen::VectorXd::Zero(mesh.unknowns);
    CondensedEquilibrium equilibrium{structure, nullptr, scene.input, unloaded, 0.0};
    std::int64_t solves = 0;
    CommittedDisplacement committed{unloaded, solves};
};

TEST_F(CommittedDisplacementOf, TheLastCommitIsFoundWhenItIsAskedFor) {
    commit(20.0);
    commit(30.0);
    EXPECT_TRUE(is(committed.write_beside_far(equilibrium), 30.0));
    EXPECT_TRUE(committed.beside_far().isZero(0.0));
    committed.catch_up(equilibrium, mesh);
    EXPECT_TRUE(is(committed.beside_far(), 30.0));
    EXPECT_FALSE(committed.lacks_far_other_than(nullptr));
    EXPECT_EQ(solves, 0);
}

TEST_F(CommittedDisplacementOf, WhatIsFarMayWait) {
    ASSERT_NE(structure.factors().far, nullptr);
    commit(30.0);
    committed.catch_up_beside_far(equilibrium, mesh);
    EXPECT_FALSE(is(committed.beside_far(), 30.0));
    EXPECT_TRUE(committed.lacks_far_other_than(nullptr));
    EXPECT_FALSE(committed.lacks_far_other_than(structure.factors().far.get()));
    Eigen::VectorXd written = committed.write_beside_far(equilibrium);
    committed.write_far(mesh, written);
    EXPECT_TRUE(is(written, 30.0));
    committed.catch_up_beside_far(equilibrium, mesh);  // somebody asks again: it is found, once
    EXPECT_TRUE(is(committed.beside_far(), 30.0));
    committed.find_far(mesh);
    EXPECT_EQ(solves, 1);
}

TEST_F(CommittedDisplacementOf, WhatIsFarIsFoundWhereSomeOfItsElementsAreWanted) {
    commit(30.0);
    committed.catch_up_beside_far(equilibrium, mesh);
    ElementSet near(scene.mesh->elements.size()), all = near;
    for (int e = 0; e < near.size(); ++e) {
        all.insert(e);
        if (!structure.is_far(e)) near.insert(e);
    }
    committed.find_far(mesh, near);
    EXPECT_EQ(solves, 0);
    committed.find_far(mesh, all);
    EXPECT_EQ(solves, 1);
    EXPECT_TRUE(is(committed.beside_far(), 30.0));
}

// A checkpoint may be written when the run has gone on from there.
TEST_F(CommittedDisplacementOf, WhatWasFarIsKept) {
    commit(20.0);
    committed.catch_up_beside_far(equilibrium, mesh);
    committed.keep_far();
    Eigen::VectorXd kept = committed.write_beside_far(equilibrium);
    commit(30.0);
    committed.catch_up_beside_far(equilibrium, mesh);
    Eigen::VectorXd forgotten = kept;
    committed.write_kept_far(kept);
    EXPECT_TRUE(is(kept, 20.0));
    committed.forget_kept_far();
    committed.write_kept_far(forgotten);
    EXPECT_FALSE(is(forgotten, 20.0));
}

// One that has fallen behind again is of its equilibrium: what was far of it before is not.
TEST_F(CommittedDisplacementOf, WhatHasFallenBehindHasNothingFarLeft) {
    commit(20.0);
    committed.catch_up_beside_far(equilibrium, mesh);
    commit(30.0);
    Eigen::VectorXd written = committed.write_beside_far(equilibrium);
    committed.write_far(mesh, written);
    EXPECT_TRUE(is(written, 30.0));
    committed.catch_up(equilibrium, mesh);
    committed.find_far(mesh);
    EXPECT_TRUE(is(committed.beside_far(), 30.0));
    EXPECT_EQ(solves, 0);
}

}  // namespace
}  // namespace stria::coarse
