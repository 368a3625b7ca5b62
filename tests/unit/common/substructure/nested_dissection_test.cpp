// Elimination orders from a bisection, and the assembly that goes with them.
#include "common/substructure/nested_dissection.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <numeric>

#include "common/geometry/vec2.hpp"
#include "common/index.hpp"
#include "common/linear/symmetric_assembly.hpp"
#include "common/substructure/sparse_leaf.hpp"

namespace stria {
namespace {

/// Elements of four points on an nx x ny grid of elements.
struct PointGrid {
    IndexLists elements;
    std::vector<Vec2> centres;
    int points;

    PointGrid(int nx, int ny) : points((nx + 1) * (ny + 1)) {
        for (int j = 0; j < ny; ++j) {
            for (int i = 0; i < nx; ++i) {
                const int p = j * (nx + 1) + i;
                elements.append(std::array{p, p + 1, p + nx + 2, p + nx + 1});
                centres.emplace_back(i + 0.5, j + 0.5);
            }
        }
    }
};

Eigen::Matrix4d element_matrix(std::size_t element) {
    const Eigen::Matrix4d free = 4.0 * Eigen::Matrix4d::Identity() - Eigen::Matrix4d::Ones();
    return (1.0 + 0.1 * static_cast<double>(element % 7)) * free + 0.01 * Eigen::Matrix4d::Identity();
}

TEST(NestedDissection, PlacesEveryUnknownOnceAndTheKeptOnesLast) {
    const PointGrid grid(13, 8);
    const std::vector<int> kept{40, 3, 77};
    std::vector<int> order = nested_dissection(grid.elements, grid.centres, grid.points, kept);
    EXPECT_TRUE(std::equal(kept.rbegin(), kept.rend(), order.rbegin()));
    std::ranges::sort(order);
    std::vector<int> all(at(grid.points));
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(order, all);
}

TEST(NestedDissection, SeparatesTheHalvesBeforeWhatTheyShare) {
    const PointGrid grid(16, 4);  // the first cut: points 8, 25, ... of each row
    const std::vector<int> order = nested_dissection(grid.elements, grid.centres, grid.points, {});
    for (std::size_t k = order.size() - 5; k < order.size(); ++k) EXPECT_EQ(order[k] % 17, 8);
    for (std::size_t k = 0; k < 40; ++k) EXPECT_LT(order[k] % 17, 8);
}

// Along a crack in a large body small elements lie in a long band: its longer direction, in mm, has the more of them.
TEST(NestedDissection, CutsWhereFewUnknownsAreShared) {
    PointGrid band(64, 8);
    for (Vec2& centre : band.centres) centre.x() *= 0.05;
    const std::vector<int> order = nested_dissection(band.elements, band.centres, band.points, {});
    const int column = order.back() % 65;
    EXPECT_GE(column, 16);
    EXPECT_LE(column, 48);
    for (std::size_t k = order.size() - 9; k < order.size(); ++k) EXPECT_EQ(order[k] % 65, column);

    const PointGrid left(
        17, 12);  // joined with as large a grid by three elements, where halves of as many would share more
    IndexLists elements = left.elements;
    std::vector<Vec2> centres = left.centres;
    const auto point = [](int i, int j) { return i <= 17 ? j * 18 + i : 18 * 13 + j * 30 + i - 18; };
    const auto add = [&](int i, int j) {
        elements.append(std::array{point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)});
        centres.emplace_back(i + 0.5, j + 0.5);
    };
    for (int j = 0; j < 12; ++j)
        for (int i = 20; i < 44; ++i) add(i, j);
    for (int i = 17; i < 20; ++i) add(i, 5);
    const std::vector<int> joined = nested_dissection(elements, centres, 18 * 13 + 30 * 13, {});
    const std::vector<int> neck(joined.end() - 2, joined.end());
    EXPECT_TRUE(std::ranges::any_of(std::array{17, 18, 19, 20},
                                    [&](int i) {
                                        return neck == std::vector{point(i, 5), point(i, 6)};
                                    }))
        << neck[0] << " " << neck[1];
}

TEST(NestedDissection, LeavesOutWhatNoElementHolds) {
    IndexLists elements;
    elements.append(std::array{4, -1, 0});
    elements.append(std::array{2, 4, -1});
    EXPECT_EQ(nested_dissection(elements, {{0.0, 0.0}, {1.0, 0.0}}, 6, {}), (std::vector<int>{0, 2, 4}));
}

// What near elements see comes after all that they do not.
TEST(NestedDissection, LateElementsComeAfterTheOthers) {
    const PointGrid grid(12, 9);
    std::vector<char> late(grid.elements.size(), 0), seen(at(grid.points), 0);
    for (std::size_t e = 0; e < late.size(); ++e) {
        late[e] = static_cast<char>((grid.centres[e] - Vec2(3.0, 4.0)).norm() < 3.0);
        if (late[e] != 0)
            for (const int point : grid.elements[e]) seen[at(point)] = 1;
    }
    const std::vector<int> order = nested_dissection(grid.elements, grid.centres, grid.points, {5}, late);
    EXPECT_EQ(order.size(), at(grid.points));
    const auto first_late = std::ranges::find_if(order, [&](int i) { return seen[at(i)] != 0; });
    EXPECT_GT(first_late - order.begin(), 10);
    EXPECT_TRUE(std::all_of(first_late, order.end() - 1, [&](int i) { return seen[at(i)] != 0; }));
    EXPECT_EQ(order.back(), 5);
}

TEST(SymmetricAssembly, GivesTheLowerTriangle) {
    const PointGrid grid(5, 4);
    SparseMatrix lower = lower_pattern(grid.elements, grid.points);
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(grid.points, grid.points);
    for (std::size_t e = 0; e < grid.elements.size(); ++e) {
        const std::vector<int> points(grid.elements[e].begin(), grid.elements[e].end());
        add_to_lower(lower, points, element_matrix(e));
        dense(points, points) += element_matrix(e);
    }
    const Eigen::MatrixXd expected = dense.triangularView<Eigen::Lower>();
    EXPECT_LT((Eigen::MatrixXd(lower) - expected).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_EQ(lower.nonZeros(), (dense.array() != 0.0).count() / 2 + grid.points / 2);
}

TEST(SymmetricAssembly, SkipsUnknownsThatAreNone) {
    IndexLists elements;
    elements.append(std::array{1, -1, 0, 2});
    SparseMatrix lower = lower_pattern(elements, 3);
    add_to_lower(lower, elements[0], element_matrix(0));
    EXPECT_EQ(lower.nonZeros(), 6);
    EXPECT_EQ(lower.coeff(1, 0), element_matrix(0)(0, 2));
}

// Both constructors condense to the same.
TEST(SparseLeaf, NumberedInOrderOfEliminationGivesTheSameTangent) {
    PointGrid grid(12, 9);
    const std::vector<int> kept{0, 12, 64, 65};
    SparseMatrix any = lower_pattern(grid.elements, grid.points);
    for (std::size_t e = 0; e < grid.elements.size(); ++e) add_to_lower(any, grid.elements[e], element_matrix(e));
    const SparseLeaf expected(any, kept);

    const std::vector<int> order = nested_dissection(grid.elements, grid.centres, grid.points, kept);
    std::vector<int> rank(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) rank[at(order[k])] = static_cast<int>(k);
    grid.elements.map([&](int point) { return rank[at(point)]; });
    SparseMatrix ordered = lower_pattern(grid.elements, grid.points);
    for (std::size_t e = 0; e < grid.elements.size(); ++e) add_to_lower(ordered, grid.elements[e], element_matrix(e));
    const SparseLeaf leaf(static_cast<int>(kept.size()), std::move(ordered));
    EXPECT_LT((leaf.tangent() - expected.tangent()).cwiseAbs().maxCoeff(), 1e-13);
    const Eigen::VectorXd load = Eigen::VectorXd::LinSpaced(grid.points, -1.0, 2.0);
    const ReducedLoad reduced = leaf.reduce(load(order));
    const Eigen::VectorXd x = leaf.expand(reduced, Eigen::VectorXd::Ones(4));
    for (const Eigen::Index wanted : {Eigen::Index{0}, Eigen::Index{7}, Eigen::Index{40}, reduced.interior.size()}) {
        const Eigen::VectorXd last = leaf.expand_last(reduced.interior.tail(wanted), Eigen::VectorXd::Ones(4));
        EXPECT_LT((last - x.tail(wanted + 4)).cwiseAbs().maxCoeff(), 1e-13);
    }
    const Eigen::VectorXd y = expected.expand(expected.reduce(load), Eigen::VectorXd::Ones(4));
    EXPECT_LT((x - y(order)).cwiseAbs().maxCoeff(), 1e-12);
}

}  // namespace
}  // namespace stria
