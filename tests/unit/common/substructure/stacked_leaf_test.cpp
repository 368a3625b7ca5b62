// A leaf in two steps against the same in one: a chain of springs, cut in its middle.
#include "common/substructure/stacked_leaf.hpp"

#include <gtest/gtest.h>

#include "common/geometry/vec2.hpp"

namespace stria {
namespace {

/// Springs from a point to the next, numbered from 0; the lower triangle.
SparseMatrix chain(int points, int first_spring, int springs) {
    std::vector<Triplet> entries;
    for (int k = first_spring; k < first_spring + springs; ++k) {
        const double stiffness = 1.0 + 0.3 * k;
        entries.insert(entries.end(), {{k, k, stiffness}, {k + 1, k + 1, stiffness}, {k + 1, k, -stiffness}});
    }
    SparseMatrix lower(points, points);
    lower.setFromTriplets(entries.begin(), entries.end());
    return lower;
}

/// Points 0 to 3 lie below, 4 is the rim, 7 and 8 are kept.
class ChainInTwoSteps : public testing::Test {
protected:
    using Below = std::shared_ptr<const SparseLeaf>;
    static Below below(Answers answers) { return std::make_shared<SparseLeaf>(1, chain(5, 0, 4), answers); }
    static StackedLeaf on(const Below& below) {
        SparseMatrix above(5, 5);
        above = chain(9, 4, 4).bottomRightCorner(5, 5);
        above.coeffRef(0, 0) += below->tangent()(0, 0);
        return {below, {0}, std::make_shared<SparseLeaf>(2, std::move(above))};
    }
    const SparseLeaf whole{2, chain(9, 0, 8)};
    const StackedLeaf parts = on(below(Answers::Anew));
    const Eigen::VectorXd load = Eigen::VectorXd::LinSpaced(9, -1.0, 2.0);
};

TEST_F(ChainInTwoSteps, HasTheSameTangent) {
    EXPECT_LT((parts.tangent() - whole.tangent()).norm(), 1e-13 * whole.tangent().norm());
}

TEST_F(ChainInTwoSteps, CondensesAndExpandsAlike) {
    const ReducedLoad a = parts.reduce(load), b = whole.reduce(load);
    EXPECT_LT((a.boundary - b.boundary).norm(), 1e-12);
    EXPECT_NEAR(a.interior.squaredNorm(), b.interior.squaredNorm(), 1e-12);
    const Vec2 kept(0.3, -0.7);
    const Eigen::VectorXd x = parts.expand(a, kept);
    EXPECT_LT((x - whole.expand(b, kept)).norm(), 1e-12);
    EXPECT_EQ(parts.expand_above(a.interior.tail(3), kept), x.tail(5));
}

// A part that remembers its answers gives them again, to the load inside that they belong to and to no other.
TEST_F(ChainInTwoSteps, CondensesALoadInsideAlike) {
    const Below knowing = below(Answers::Remembered);
    const StackedLeaf remembering = on(knowing);
    (void)knowing->reduce(load.head(5));  // the same inside, but with a load on the rim
    for (const double factor : {1.0, 2.0, 1.0}) {
        const Eigen::VectorXd inside = factor * load.head(7);
        Eigen::VectorXd all = Eigen::VectorXd::Zero(9);
        all.head(7) = inside;
        const ReducedLoad expected = parts.reduce(all);
        for (const StackedLeaf* each : {&parts, &remembering}) {
            Eigen::VectorXd reduced(7);
            EXPECT_EQ(each->reduce_interior(inside, reduced), expected.boundary);
            EXPECT_EQ(reduced, expected.interior);
        }
    }
}

}  // namespace
}  // namespace stria
