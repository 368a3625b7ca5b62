// What rests answers as its elements would, and carries its loads for as long as it stays so.
#include "common/substructure/front_tree.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "common/error.hpp"
#include "common/index.hpp"
#include "tests/support/front_grid.hpp"

namespace stria {
namespace {

class SubtreesAtRest : public testing::TestWithParam<Symmetry> {
protected:
    SubtreesAtRest() {
        grid.ground();
        grid.keep_outline();
        load = Eigen::VectorXd::LinSpaced(grid.layout.unknowns, -1.0, 2.0);
        move = Eigen::VectorXd::LinSpaced(grid.layout.unknowns, 0.5, -0.3);
    }

    test::FrontGrid grid{9, 7, GetParam()};
    Eigen::VectorXd load, move;
};
INSTANTIATE_TEST_SUITE_P(Symmetries, SubtreesAtRest, testing::Values(Symmetry::Symmetric, Symmetry::General),
                         test::name_of_symmetry);

// A linear problem does not care which of its elements rest.
TEST_P(SubtreesAtRest, SubtreesAtRestRespondAsTheirElementsDo) {
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
    load = asleep * load;
    tree.carry(load);
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
TEST_P(SubtreesAtRest, WhatStaysAtRestHasCarriedItsLoad) {
    FrontTree tree(grid.layout), fresh(grid.layout);
    for (FrontTree* one : {&tree, &fresh}) one->factor(grid.matrices, grid.changed, grid.symmetry);
    ElementSet may_rest(grid.matrices.size(), true);
    may_rest.erase(0);
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

// Of an increment that failed nothing is left but what rested, and some of that may have to wake in the next one before
// there is a factor again.
TEST_P(SubtreesAtRest, SomeMayWakeBehindAFailure) {
    FrontTree tree(grid.layout), fresh(grid.layout);
    for (FrontTree* one : {&tree, &fresh}) one->factor(grid.matrices, grid.changed, grid.symmetry);
    ElementSet may_rest(grid.matrices.size(), true);
    may_rest.erase(0);
    tree.rest(may_rest);
    tree.carry(load);
    grid.changed[0] = 1;
    const Eigen::MatrixXd good = std::exchange(grid.matrices[0], Eigen::MatrixXd::Constant(8, 8, std::nan("")));
    for (int attempt = 0; attempt < 2; ++attempt)
        EXPECT_THROW(tree.factor(grid.matrices, grid.changed, grid.symmetry), NumericalFailure);
    may_rest.erase(30);
    for (FrontTree* one : {&tree, &fresh}) {
        one->rest(may_rest);
        one->carry(load);
    }
    EXPECT_EQ(tree.response(move), fresh.response(move));
    EXPECT_EQ(tree.follow(move), fresh.follow(move));
    grid.matrices[0] = good;
    for (FrontTree* one : {&tree, &fresh}) one->factor(grid.matrices, grid.changed, grid.symmetry);
    EXPECT_EQ(tree.tangent(), fresh.tangent());
}

TEST_P(SubtreesAtRest, LoadsPassAroundWhatRests) {
    FrontTree tree(grid.layout), whole(grid.layout);
    tree.factor(grid.matrices, grid.changed, grid.symmetry);
    whole.factor(grid.matrices, grid.changed, grid.symmetry);
    ElementSet may_rest(grid.matrices.size(), true);
    may_rest.erase(30);
    tree.rest(may_rest);
    for (Eigen::Index i = 0; i < load.size(); ++i)
        if (tree.inside().contains(i)) load[i] = 0.0;
    const ReducedLoad reduced = tree.reduce(load), expected = whole.reduce(load);
    EXPECT_EQ(reduced.boundary, expected.boundary);
    const Eigen::VectorXd boundary = Eigen::VectorXd::LinSpaced(reduced.boundary.size(), 0.1, 0.2);
    const Eigen::VectorXd x = tree.expand(reduced, boundary), y = whole.expand(expected, boundary);
    for (Eigen::Index i = 0; i < load.size(); ++i) EXPECT_EQ(x[i], tree.inside().contains(i) ? 0.0 : y[i]);
}

}  // namespace
}  // namespace stria
