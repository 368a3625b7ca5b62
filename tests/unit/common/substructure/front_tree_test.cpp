// FrontTree against dense algebra on a small grid, and against itself factored anew.
#include "common/substructure/front_tree.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <limits>
#include <utility>

#include "common/error.hpp"
#include "common/index.hpp"
#include "tests/support/front_grid.hpp"

namespace stria {
namespace {

class FrontTreeOfEither : public testing::TestWithParam<Symmetry> {};
INSTANTIATE_TEST_SUITE_P(Symmetries, FrontTreeOfEither, testing::Values(Symmetry::Symmetric, Symmetry::General),
                         test::name_of_symmetry);

TEST_P(FrontTreeOfEither, TangentIsTheDenseSchurComplementAlsoOfAFloatingBody) {
    test::FrontGrid grid(9, 7, GetParam());
    grid.keep_outline();
    FrontTree tree(grid.layout);
    tree.factor(grid.matrices, grid.changed, grid.symmetry);
    const Eigen::MatrixXd& s = tree.tangent();
    EXPECT_LT((s - grid.dense_schur()).cwiseAbs().maxCoeff(), 1e-12 * s.cwiseAbs().maxCoeff());
    Eigen::VectorXd translation = Eigen::VectorXd::Zero(s.cols());
    for (std::size_t i = 0; i < grid.layout.boundary.size(); ++i) {
        if (grid.layout.boundary[i] % 2 == 0) translation[static_cast<int>(i)] = 1.0;
    }
    EXPECT_LT((s * translation).cwiseAbs().maxCoeff(), 1e-12 * s.cwiseAbs().maxCoeff());
}

TEST_P(FrontTreeOfEither, ReducedProblemGivesTheWholeSolution) {
    test::FrontGrid grid(9, 7, GetParam());
    grid.ground();
    grid.keep_outline();
    FrontTree tree(grid.layout);
    tree.factor(grid.matrices, grid.changed, grid.symmetry);
    const Eigen::VectorXd load = Eigen::VectorXd::LinSpaced(grid.layout.unknowns, -1.0, 2.0);
    const ReducedLoad reduced = tree.reduce(load);
    const Eigen::VectorXd boundary = tree.tangent().partialPivLu().solve(reduced.boundary);
    const Eigen::VectorXd x = tree.expand(reduced, boundary);
    EXPECT_EQ(x(grid.layout.boundary), boundary);
    EXPECT_LT((grid.dense() * x - load).cwiseAbs().maxCoeff(), 1e-11);
}

TEST_P(FrontTreeOfEither, BoundaryMayBeEmpty) {
    test::FrontGrid grid(6, 5, GetParam());
    grid.ground();
    FrontTree tree(grid.layout);
    tree.factor(grid.matrices, grid.changed, grid.symmetry);
    EXPECT_EQ(tree.tangent().size(), 0);
    const Eigen::VectorXd load = Eigen::VectorXd::Ones(grid.layout.unknowns);
    const Eigen::VectorXd x = tree.expand(tree.reduce(load), Eigen::VectorXd(0));
    EXPECT_LT((grid.dense() * x - load).cwiseAbs().maxCoeff(), 1e-11);
}

TEST_P(FrontTreeOfEither, BoundaryMayBeEverything) {
    test::FrontGrid grid(5, 4, GetParam());
    for (int unknown = grid.layout.unknowns; unknown-- > 0;) grid.layout.boundary.push_back(unknown);
    FrontTree tree(grid.layout);
    tree.factor(grid.matrices, grid.changed, grid.symmetry);
    const Eigen::MatrixXd whole = grid.dense()(grid.layout.boundary, grid.layout.boundary);
    EXPECT_LT((tree.tangent() - whole).cwiseAbs().maxCoeff(), 1e-13);
    const Eigen::VectorXd load = Eigen::VectorXd::LinSpaced(grid.layout.unknowns, 0.0, 1.0);
    EXPECT_EQ(tree.reduce(load).boundary, load(grid.layout.boundary));
}

TEST_P(FrontTreeOfEither, DirtyPathsGiveTheBitsOfAWholeRefactoring) {
    test::FrontGrid grid(12, 10, GetParam());
    grid.keep_outline();
    FrontTree tree(grid.layout);
    tree.factor(grid.matrices, grid.changed, grid.symmetry);
    const Eigen::VectorXd load = Eigen::VectorXd::LinSpaced(grid.layout.unknowns, -1.0, 1.0);
    for (const std::size_t element : {0, 119, 60, 1}) {
        std::ranges::fill(grid.changed, 0);
        grid.change(element);
        tree.factor(grid.matrices, grid.changed, grid.symmetry);
        FrontTree fresh(grid.layout);
        fresh.factor(grid.matrices, grid.changed, grid.symmetry);
        EXPECT_EQ(tree.tangent(), fresh.tangent());
        const ReducedLoad ours = tree.reduce(load), theirs = fresh.reduce(load);
        EXPECT_EQ(ours.boundary, theirs.boundary);
        EXPECT_EQ(tree.expand(ours, ours.boundary), fresh.expand(theirs, theirs.boundary));
    }
}

TEST_P(FrontTreeOfEither, OnlyDirtyPathsAreRefactored) {
    test::FrontGrid grid(8, 8, GetParam());
    grid.layout.leaf_elements = 8;  // eight leaves: fifteen fronts, four on a path
    grid.keep_outline();
    FrontTree tree(grid.layout);
    ASSERT_EQ(tree.fronts(), 15);
    tree.factor(grid.matrices, grid.changed, grid.symmetry);
    EXPECT_EQ(tree.refactored(), 15);
    tree.factor(grid.matrices, grid.changed, grid.symmetry);
    EXPECT_EQ(tree.refactored(), 15);
    grid.change(0);
    tree.factor(grid.matrices, grid.changed, grid.symmetry);
    EXPECT_EQ(tree.refactored(), 15 + 4);
    grid.change(63);  // the other corner shares the root only
    tree.factor(grid.matrices, grid.changed, grid.symmetry);
    EXPECT_EQ(tree.refactored(), 15 + 4 + 7);
}

TEST_P(FrontTreeOfEither, FromABusyPlaceTheWayToTheRootDoesNotDependOnHowManyElementsThereAre) {
    const auto refactored_at_busy_corner = [](int nx) {
        test::FrontGrid grid(nx, 8, GetParam());
        grid.layout.busy = {{nx - 0.5, 0.5}};
        grid.keep_outline();
        FrontTree tree(grid.layout);
        tree.factor(grid.matrices, grid.changed, grid.symmetry);
        const long whole = tree.refactored();
        grid.change(grid.matrices.size() - 1);
        tree.factor(grid.matrices, grid.changed, grid.symmetry);
        const Eigen::MatrixXd& s = tree.tangent();
        EXPECT_LT((s - grid.dense_schur()).cwiseAbs().maxCoeff(), 1e-12 * s.cwiseAbs().maxCoeff());
        return tree.refactored() - whole;
    };
    EXPECT_EQ(refactored_at_busy_corner(40), refactored_at_busy_corner(100));
}

TEST_P(FrontTreeOfEither, FailureLeavesAUsableTree) {
    test::FrontGrid grid(8, 8, GetParam());
    grid.keep_outline();
    FrontTree tree(grid.layout);
    tree.factor(grid.matrices, grid.changed, grid.symmetry);
    const Eigen::MatrixXd before = tree.tangent();
    const Eigen::MatrixXd good =
        std::exchange(grid.matrices[27], Eigen::MatrixXd::Constant(8, 8, std::numeric_limits<double>::quiet_NaN()));
    grid.changed[27] = 1;
    EXPECT_THROW(tree.factor(grid.matrices, grid.changed, grid.symmetry), NumericalFailure);
    EXPECT_THROW((void)tree.tangent(), std::logic_error);
    grid.matrices[27] = good;
    std::ranges::fill(grid.changed, 0);  // all is refactored, whatever the caller says
    tree.factor(grid.matrices, grid.changed, grid.symmetry);
    EXPECT_EQ(tree.tangent(), before);
}

TEST_P(FrontTreeOfEither, AFloatingBodyWithoutBoundaryIsSingular) {
    test::FrontGrid grid(20, 20, GetParam());
    FrontTree tree(grid.layout);
    EXPECT_THROW(tree.factor(grid.matrices, grid.changed, grid.symmetry), NumericalFailure);
}

TEST(FrontTree, AMultiplierNeedsThePivotOfItsNeighbour) {
    // Displacement 1 is held by multiplier 0, which has no diagonal entry and is eliminated first.
    FrontTree::Layout layout;
    layout.unknowns = 4;
    layout.element_unknowns = {{1, 0, 2}, {0, 3}};
    layout.centres = {{0.0, 0.0}, {1.0, 0.0}};
    layout.boundary = {3, 2};
    const std::vector<Eigen::MatrixXd> matrices{Eigen::Matrix3d{{2, 1, -2}, {1, 0, 0}, {-2, 0, 2}},
                                                Eigen::Matrix2d{{0, 0}, {3, 0}}};
    FrontTree tree(layout);
    tree.factor(matrices, std::vector<char>(2, 1), Symmetry::General);
    // u1 = 0 and p = 2 u2 - 2 u1, so that row 3 reads 3 p = 6 u2 and row 2 reads 2 u2 - 2 u1 = 2 u2.
    EXPECT_LT((tree.tangent() - Eigen::Matrix2d{{0, 6}, {0, 2}}).cwiseAbs().maxCoeff(), 1e-14);
}

/// Rows of constraints on unknowns of neighbouring nodes, some of them across the groups of elements; every third is
/// idle.
struct Constrained : test::FrontGrid {
    Constrained() : test::FrontGrid(9, 7, Symmetry::Symmetric) {
        keep_outline();
        layout.multipliers = 3 * (nx - 2);
        for (int j = 2; j <= 4; ++j)
            for (int i = 1; i < nx - 1; ++i) add_multiplier(i, j);
    }

    void add_multiplier(int i, int j) {
        layout.element_unknowns.push_back({2 * at(i, j) + 1, 2 * at(i + 1, j) + 1, 2 * at(i, j), layout.unknowns++});
        layout.centres.emplace_back(i + 0.4, j);
        matrices.push_back(matrix_of(changed.size() % 3 == 0));
        changed.push_back(0);
    }

    static Eigen::MatrixXd matrix_of(bool idle) {
        Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(4, 4);
        if (idle) {
            matrix(3, 3) = -1e-5;
        } else {
            matrix.row(3).head(3) << -1.0, -0.4, 0.2;
            matrix.col(3) = matrix.row(3).transpose().eval();
        }
        return matrix;
    }
};

/// The tangent and a solution through the tree are those of the dense matrix.
void expect_dense_algebra(FrontTree& tree, const Constrained& grid) {
    const Eigen::MatrixXd& s = tree.tangent();
    EXPECT_LT((s - grid.dense_schur()).cwiseAbs().maxCoeff(), 1e-11 * s.cwiseAbs().maxCoeff());
    const Eigen::VectorXd load = Eigen::VectorXd::LinSpaced(grid.layout.unknowns, -1.0, 2.0);
    const ReducedLoad reduced = tree.reduce(load);
    const Eigen::VectorXd boundary = Eigen::VectorXd::LinSpaced(s.cols(), 0.5, -0.5);
    Eigen::VectorXd left = grid.dense() * tree.expand(reduced, boundary) - load;
    EXPECT_LT((left(grid.layout.boundary) - (s * boundary - reduced.boundary)).cwiseAbs().maxCoeff(), 1e-10);
    left(grid.layout.boundary).setZero();
    EXPECT_LT(left.cwiseAbs().maxCoeff(), 1e-10);
}

TEST(FrontTree, MultipliersAreEliminatedWithWhatTheyActOn) {
    const Constrained grid;
    FrontTree tree(grid.layout);
    tree.factor(grid.matrices, grid.changed, grid.symmetry);
    expect_dense_algebra(tree, grid);
}

TEST(FrontTree, AMultiplierThatBecomesIdleDirtiesItsPath) {
    Constrained grid;
    FrontTree tree(grid.layout);
    tree.factor(grid.matrices, grid.changed, grid.symmetry);
    const long before = tree.refactored();
    grid.matrices.back() = Constrained::matrix_of(true);
    grid.changed.back() = 1;
    tree.factor(grid.matrices, grid.changed, grid.symmetry);
    EXPECT_LT(tree.refactored() - before, tree.fronts() / 2);
    FrontTree fresh(grid.layout);
    fresh.factor(grid.matrices, grid.changed, grid.symmetry);
    EXPECT_EQ(tree.tangent(), fresh.tangent());
}

// One element becomes unsymmetric and symmetric again: only the fronts above it are general, and only as long.
TEST(FrontTree, OnlyPathsAboveAnUnsymmetricElementAreGeneral) {
    Constrained grid;
    grid.layout.leaf_elements = 8;
    FrontTree tree(grid.layout);
    Symmetry of_last = Symmetry::Symmetric;
    const auto factor = [&] {
        tree.factor(
            [&](int e) {
                const bool is_last = e + 1 == std::ssize(grid.matrices);
                return FrontTree::ElementMatrix{grid.matrices[at(e)], is_last ? of_last : Symmetry::Symmetric};
            },
            grid.changed);
    };
    factor();
    EXPECT_EQ(tree.refactored_general(), 0);
    EXPECT_EQ(tree.symmetry(), Symmetry::Symmetric);
    const Eigen::MatrixXd before = tree.tangent();

    const Eigen::MatrixXd symmetric = grid.matrices.back();
    grid.matrices.back()(0, 3) += 0.3;
    grid.changed.back() = 1;
    of_last = Symmetry::General;
    const long refactored = tree.refactored();
    factor();
    EXPECT_EQ(tree.symmetry(), Symmetry::General);
    EXPECT_EQ(tree.refactored_general(), tree.refactored() - refactored);
    EXPECT_LT(tree.refactored_general(), tree.fronts() / 2);
    EXPECT_GT((tree.tangent() - tree.tangent().transpose()).cwiseAbs().maxCoeff(), 1e-3);
    expect_dense_algebra(tree, grid);

    grid.matrices.back() = symmetric;
    of_last = Symmetry::Symmetric;
    const long general = tree.refactored_general();
    factor();
    EXPECT_EQ(tree.symmetry(), Symmetry::Symmetric);
    EXPECT_EQ(tree.refactored_general(), general);
    EXPECT_EQ(tree.tangent(), before);
}

TEST(FrontTree, MultipliersThatSayTheSameAreSingular) {
    Constrained grid;
    grid.add_multiplier(4, 3);
    grid.matrices.back() = Constrained::matrix_of(false);
    ++grid.layout.multipliers;
    FrontTree tree(grid.layout);
    EXPECT_THROW(tree.factor(grid.matrices, grid.changed, grid.symmetry), NumericalFailure);
}

TEST(FrontTree, AnUnknownWithoutElementIsAMistake) {
    test::FrontGrid grid(3, 3, Symmetry::Symmetric);
    ++grid.layout.unknowns;
    EXPECT_THROW(FrontTree{grid.layout}, std::logic_error);
}

}  // namespace
}  // namespace stria
