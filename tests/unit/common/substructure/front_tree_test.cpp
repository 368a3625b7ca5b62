// FrontTree against dense algebra on a small grid, and against itself factored anew.
#include "common/substructure/front_tree.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <string>
#include <utility>

#include "common/error.hpp"
#include "common/index.hpp"

namespace stria {
namespace {

/// nx x ny squares of four nodes with two unknowns each. Without ground the body is free to translate.
struct Grid {
    Grid(int nx_, int ny_, Symmetry symmetry_) : nx(nx_), ny(ny_), symmetry(symmetry_) {
        layout.unknowns = 2 * (nx + 1) * (ny + 1);
        for (int j = 0; j < ny; ++j) {
            for (int i = 0; i < nx; ++i) {
                std::vector<int> unknowns;
                for (const int node : {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}) {
                    unknowns.insert(unknowns.end(), {2 * node, 2 * node + 1});
                }
                layout.element_unknowns.push_back(unknowns);
                layout.centres.emplace_back(i + 0.5, j + 0.5);
                matrices.push_back(element_matrix());
            }
        }
        changed.assign(matrices.size(), 0);
    }

    [[nodiscard]] int at(int i, int j) const { return j * (nx + 1) + i; }

    void keep_outline() {
        for (int j = 0; j <= ny; ++j) {
            for (int i = 0; i <= nx; ++i) {
                if (i > 0 && i < nx && j > 0 && j < ny) continue;
                layout.boundary.insert(layout.boundary.begin(), {2 * at(i, j), 2 * at(i, j) + 1});
            }
        }
    }

    /// Differences between nodes are stiff, coupled between components; the unsymmetric part keeps translations free.
    Eigen::MatrixXd element_matrix() {
        const Eigen::MatrixXd differences = Eigen::MatrixXd::Identity(4, 4) - Eigen::MatrixXd::Constant(4, 4, 0.25);
        const auto uniform = [this] { return std::uniform_real_distribution<double>(-1.0, 1.0)(random); };
        const Eigen::MatrixXd any = Eigen::MatrixXd::NullaryExpr(8, 8, uniform);
        Eigen::MatrixXd project = Eigen::MatrixXd::Zero(8, 8);
        for (int a = 0; a < 4; ++a) {
            for (int b = 0; b < 4; ++b) project.block<2, 2>(2 * a, 2 * b).diagonal().setConstant(differences(a, b));
        }
        const bool symmetric = symmetry == Symmetry::Symmetric;
        const Eigen::MatrixXd core =
            any * any.transpose() + Eigen::MatrixXd::Identity(8, 8) + (symmetric ? 0.0 : 1.0) * (any - any.transpose());
        return project * core * project;
    }

    void ground() { matrices.front() += Eigen::MatrixXd::Identity(8, 8); }

    void change(std::size_t element) {
        matrices[element] *= 1.5;
        changed[element] = 1;
    }

    [[nodiscard]] Eigen::MatrixXd dense() const {
        Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(layout.unknowns, layout.unknowns);
        for (std::size_t e = 0; e < matrices.size(); ++e) {
            sum(layout.element_unknowns[e], layout.element_unknowns[e]) += matrices[e];
        }
        return sum;
    }

    [[nodiscard]] Eigen::MatrixXd dense_schur() const {
        const std::vector<int>& b = layout.boundary;
        std::vector<int> i;
        for (int unknown = 0; unknown < layout.unknowns; ++unknown) {
            if (std::ranges::find(b, unknown) == b.end()) i.push_back(unknown);
        }
        const Eigen::MatrixXd k = dense();
        const Eigen::MatrixXd inner = k(i, i), right = k(i, b);
        return k(b, b) - k(b, i) * inner.partialPivLu().solve(right);
    }

    int nx, ny;
    Symmetry symmetry;
    std::mt19937 random{7};
    FrontTree::Layout layout;
    std::vector<Eigen::MatrixXd> matrices;
    std::vector<char> changed;
};

class FrontTreeOfEither : public testing::TestWithParam<Symmetry> {};
std::string name_of(const testing::TestParamInfo<Symmetry>& either) {
    return either.param == Symmetry::Symmetric ? "Symmetric" : "General";
}
INSTANTIATE_TEST_SUITE_P(Symmetries, FrontTreeOfEither, testing::Values(Symmetry::Symmetric, Symmetry::General),
                         name_of);

TEST_P(FrontTreeOfEither, TangentIsTheDenseSchurComplementAlsoOfAFloatingBody) {
    Grid grid(9, 7, GetParam());
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
    Grid grid(9, 7, GetParam());
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
    Grid grid(6, 5, GetParam());
    grid.ground();
    FrontTree tree(grid.layout);
    tree.factor(grid.matrices, grid.changed, grid.symmetry);
    EXPECT_EQ(tree.tangent().size(), 0);
    const Eigen::VectorXd load = Eigen::VectorXd::Ones(grid.layout.unknowns);
    const Eigen::VectorXd x = tree.expand(tree.reduce(load), Eigen::VectorXd(0));
    EXPECT_LT((grid.dense() * x - load).cwiseAbs().maxCoeff(), 1e-11);
}

TEST_P(FrontTreeOfEither, BoundaryMayBeEverything) {
    Grid grid(5, 4, GetParam());
    for (int unknown = grid.layout.unknowns; unknown-- > 0;) grid.layout.boundary.push_back(unknown);
    FrontTree tree(grid.layout);
    tree.factor(grid.matrices, grid.changed, grid.symmetry);
    const Eigen::MatrixXd whole = grid.dense()(grid.layout.boundary, grid.layout.boundary);
    EXPECT_LT((tree.tangent() - whole).cwiseAbs().maxCoeff(), 1e-13);
    const Eigen::VectorXd load = Eigen::VectorXd::LinSpaced(grid.layout.unknowns, 0.0, 1.0);
    EXPECT_EQ(tree.reduce(load).boundary, load(grid.layout.boundary));
}

TEST_P(FrontTreeOfEither, DirtyPathsGiveTheBitsOfAWholeRefactoring) {
    Grid grid(12, 10, GetParam());
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
    Grid grid(8, 8, GetParam());
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
        Grid grid(nx, 8, GetParam());
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

/// A tree over a part of a grid's elements, with all their unknowns numbered anew.
struct PartOfGrid {
    PartOfGrid(const Grid& grid, std::vector<int> elements_) : elements(std::move(elements_)) {
        std::map<int, int> number;
        for (const int e : elements) {
            std::vector<int> unknowns;
            for (const int unknown : grid.layout.element_unknowns[at(e)])
                unknowns.push_back(number.try_emplace(unknown, static_cast<int>(number.size())).first->second);
            layout.element_unknowns.push_back(unknowns);
            layout.centres.push_back(grid.layout.centres[at(e)]);
            matrices.push_back(grid.matrices[at(e)]);
        }
        layout.unknowns = static_cast<int>(number.size());
        for (const int unknown : grid.layout.boundary)
            if (number.contains(unknown)) layout.boundary.push_back(number[unknown]);
    }
    /// Of each element: where it is in another part, if its matrix is the same; else -1.
    [[nodiscard]] std::vector<int> places_in(const PartOfGrid& other) const {
        std::vector<int> places;
        for (std::size_t k = 0; k < elements.size(); ++k) {
            const auto found = std::ranges::find(other.elements, elements[k]);
            const auto place = found - other.elements.begin();
            const bool same = found != other.elements.end() && other.matrices[at(place)] == matrices[k];
            places.push_back(same ? static_cast<int>(place) : -1);
        }
        return places;
    }

    std::vector<int> elements;
    FrontTree::Layout layout;
    std::vector<Eigen::MatrixXd> matrices;
};

std::vector<int> all_elements_but(const Grid& grid, const std::vector<int>& left_out) {
    std::vector<int> elements;
    for (int e = 0; e < std::ssize(grid.matrices); ++e)
        if (std::ranges::find(left_out, e) == left_out.end()) elements.push_back(e);
    return elements;
}

// The bits are those of a tree that begins, in much less work: elements have come, one has another matrix.
TEST_P(FrontTreeOfEither, ALaterTreeTakesOverTheFrontsThatAreTheSame) {
    Grid grid(100, 4, GetParam());
    grid.ground();
    const PartOfGrid before(grid, all_elements_but(grid, {99, 199, 299, 399}));
    grid.matrices[3] *= 1.5;
    PartOfGrid after(grid, all_elements_but(grid, {}));
    FrontTree old(before.layout), fresh(after.layout);
    old.factor(before.matrices, std::vector<char>(before.matrices.size(), 1), grid.symmetry);
    FrontTree tree(after.layout, old, after.places_in(before));
    tree.factor(after.matrices, std::vector<char>(after.matrices.size(), 0), grid.symmetry);
    fresh.factor(after.matrices, std::vector<char>(after.matrices.size(), 1), grid.symmetry);
    EXPECT_EQ(tree.tangent(), fresh.tangent());
    const Eigen::VectorXd load = Eigen::VectorXd::LinSpaced(after.layout.unknowns, -1.0, 1.0);
    const ReducedLoad ours = tree.reduce(load), theirs = fresh.reduce(load);
    EXPECT_EQ(tree.expand(ours, ours.boundary), fresh.expand(theirs, theirs.boundary));
    EXPECT_LT(tree.refactored(), fresh.refactored() / 2);
    EXPECT_GT(tree.refactored(), 0);
}

TEST_P(FrontTreeOfEither, ATreeTakesNothingFromOneThatWasNotFactored) {
    Grid grid(9, 7, GetParam());
    grid.keep_outline();
    FrontTree old(grid.layout), fresh(grid.layout);
    std::vector<int> all(grid.matrices.size());
    std::iota(all.begin(), all.end(), 0);
    FrontTree tree(grid.layout, old, all);
    tree.factor(grid.matrices, grid.changed, grid.symmetry);
    fresh.factor(grid.matrices, grid.changed, grid.symmetry);
    EXPECT_EQ(tree.tangent(), fresh.tangent());
    EXPECT_EQ(tree.refactored(), fresh.refactored());
    FrontTree again(grid.layout, tree, all);
    again.factor(grid.matrices, grid.changed, grid.symmetry);
    EXPECT_EQ(again.tangent(), fresh.tangent());
    EXPECT_EQ(again.refactored(), 0);
}

TEST_P(FrontTreeOfEither, FailureLeavesAUsableTree) {
    Grid grid(8, 8, GetParam());
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
    Grid grid(20, 20, GetParam());
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
struct Constrained : Grid {
    Constrained() : Grid(9, 7, Symmetry::Symmetric) {
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

// A linear problem does not care which of its elements rest.
TEST_P(FrontTreeOfEither, SubtreesAtRestRespondAsTheirElementsDo) {
    Grid grid(9, 7, GetParam());
    grid.ground();
    grid.keep_outline();
    FrontTree tree(grid.layout);
    tree.factor(grid.matrices, grid.changed, grid.symmetry);
    ElementSet may_rest(grid.matrices.size());
    for (int e = 0; e < may_rest.size(); ++e)
        if (grid.layout.centres[at(e)].x() > 2.0) may_rest.insert(e);
    tree.rest(may_rest);
    EXPECT_GT(tree.resting().count(), 20);
    EXPECT_LE(tree.resting().count(), may_rest.count());
    Eigen::MatrixXd awake = grid.dense(), asleep = Eigen::MatrixXd::Zero(awake.rows(), awake.cols());
    for (const int e : tree.resting().members()) {
        const std::vector<int>& unknowns = grid.layout.element_unknowns[at(e)];
        asleep(unknowns, unknowns) += grid.matrices[at(e)];
    }
    awake -= asleep;
    // Loads on the elements at rest, and the unknowns awake moved: those inside follow until nothing is due on them.
    const Eigen::VectorXd load = asleep * Eigen::VectorXd::LinSpaced(awake.rows(), -1.0, 2.0);
    tree.carry(load);
    Eigen::VectorXd move = Eigen::VectorXd::LinSpaced(awake.rows(), 0.5, -0.3);
    const Eigen::VectorXd response = tree.response(move), followed = tree.follow(move);
    const Eigen::VectorXd due = load - asleep * followed;
    for (Eigen::Index i = 0; i < due.size(); ++i) {
        const bool inside = tree.inside().contains(i);
        EXPECT_NEAR(due[i], response[i], 1e-10);
        EXPECT_NEAR(response[i], inside ? 0.0 : response[i], 0.0);
        EXPECT_TRUE(inside || followed[i] == move[i]);
    }
}

// Where some wake, the others carry their loads on as they did: same bits as a tree whose rest begins so, less work.
TEST_P(FrontTreeOfEither, WhatStaysAtRestHasCarriedItsLoad) {
    Grid grid(9, 7, GetParam());
    grid.ground();
    grid.keep_outline();
    FrontTree tree(grid.layout), fresh(grid.layout);
    for (FrontTree* one : {&tree, &fresh}) one->factor(grid.matrices, grid.changed, grid.symmetry);
    ElementSet may_rest(grid.matrices.size(), true);
    may_rest.erase(0);
    Eigen::VectorXd load = Eigen::VectorXd::LinSpaced(grid.layout.unknowns, -1.0, 2.0);
    const Eigen::VectorXd move = Eigen::VectorXd::LinSpaced(grid.layout.unknowns, 0.5, -0.3);
    tree.rest(may_rest);
    tree.carry(load);
    const long all = tree.carried();
    const auto expect_as_fresh = [&] {
        tree.rest(may_rest);
        tree.carry(load);
        const long before = fresh.carried();
        fresh.rest(ElementSet(grid.matrices.size()));
        fresh.rest(may_rest);
        fresh.carry(load);
        EXPECT_EQ(tree.response(move), fresh.response(move));
        EXPECT_EQ(tree.follow(move), fresh.follow(move));
        return fresh.carried() - before;
    };
    may_rest.erase(30);
    expect_as_fresh();
    EXPECT_LT(tree.carried() - all, all / 2);
    const long woken = tree.carried();
    expect_as_fresh();
    EXPECT_EQ(tree.carried(), woken);
    load *= 1.5;
    const long by_fresh = expect_as_fresh();
    EXPECT_EQ(tree.carried() - woken, by_fresh);
    // Another matrix, of an element that rests again.
    const long changed = tree.carried();
    grid.matrices[50] *= 1.1;
    std::vector<char> flags(grid.matrices.size(), 0);
    flags[50] = 1;
    for (FrontTree* one : {&tree, &fresh}) one->factor(grid.matrices, flags, grid.symmetry);
    expect_as_fresh();
    EXPECT_GT(tree.carried(), changed);
}

TEST_P(FrontTreeOfEither, LoadsPassAroundWhatRests) {
    Grid grid(9, 7, GetParam());
    grid.ground();
    grid.keep_outline();
    FrontTree tree(grid.layout), whole(grid.layout);
    tree.factor(grid.matrices, grid.changed, grid.symmetry);
    whole.factor(grid.matrices, grid.changed, grid.symmetry);
    ElementSet may_rest(grid.matrices.size(), true);
    may_rest.erase(30);
    tree.rest(may_rest);
    Eigen::VectorXd load = Eigen::VectorXd::LinSpaced(grid.layout.unknowns, -1.0, 2.0);
    for (Eigen::Index i = 0; i < load.size(); ++i)
        if (tree.inside().contains(i)) load[i] = 0.0;
    const ReducedLoad reduced = tree.reduce(load), expected = whole.reduce(load);
    EXPECT_EQ(reduced.boundary, expected.boundary);
    const Eigen::VectorXd boundary = Eigen::VectorXd::LinSpaced(reduced.boundary.size(), 0.1, 0.2);
    const Eigen::VectorXd x = tree.expand(reduced, boundary), y = whole.expand(expected, boundary);
    for (Eigen::Index i = 0; i < load.size(); ++i) EXPECT_EQ(x[i], tree.inside().contains(i) ? 0.0 : y[i]);
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
    Grid grid(3, 3, Symmetry::Symmetric);
    ++grid.layout.unknowns;
    EXPECT_THROW(FrontTree{grid.layout}, std::logic_error);
}

}  // namespace
}  // namespace stria
