// Which jumps strain little of the body, and that they find their equilibrium where metal flows.
#include "fine/bulk/soft_jumps.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/support/cracked_mesh.hpp"
#include "tests/support/plate_bulk.hpp"

namespace stria::test {
namespace {

using fine::Bulk;
using fine::BulkElements;
using fine::SoftJumps;

constexpr double tolerance = 1e-6;

/// Eight by eight elements, and a crack along the fifth row of them, `t` edges above its lower nodes.
EnrichedMesh above_a_line(double t) {
    const double height = 0.5 + t / 8.0;
    return cracked(square_mesh(8), {{-1.0, height}, {0.9, height}}, 0);
}

/// Heights of the nodes with soft jumps that have elements on both sides and all of them cut.
std::set<double> heights(double t, const std::vector<int>& boundary = {}) {
    const EnrichedMesh mesh = above_a_line(t);
    const BulkElements elements(mesh, Materials(plate_case({})), {.subcells = 2, .tip_points = 4}, nullptr);
    const std::vector<int> soft = SoftJumps(elements, boundary, tolerance).unknowns();
    std::set<double> found;
    for (const auto& own : mesh.own_unknowns()) {
        const Vec2& x = mesh.nodes[at(own.node)];
        const bool within = x.x() > 0.1 && x.x() < 0.7;
        if (within && std::ranges::binary_search(soft, own.unknown)) found.insert(x.y());
    }
    return found;
}

// On the strip of a height t below the crack the functions of the nodes above it, which jump by two, have 8/3 (t +
// t^3), on what is above it those of the nodes below have 8/3 (s + s^3), s = 1 - t: two at 0.5674.
TEST(SoftJumps, AreThoseWhoseFunctionsStrainLittleOfTheBody) {
    EXPECT_EQ(heights(0.01), std::set<double>{0.625});
    EXPECT_EQ(heights(0.432), std::set<double>{0.625});
    EXPECT_EQ(heights(0.433), (std::set<double>{0.5, 0.625}));
    EXPECT_EQ(heights(0.567), (std::set<double>{0.5, 0.625}));
    EXPECT_EQ(heights(0.568), std::set<double>{0.5});
}

TEST(SoftJumps, AreNotAmongTheUnknownsOfOthers) {
    std::vector<int> all(at(above_a_line(0.01).unknowns));
    for (std::size_t k = 0; k < all.size(); ++k) all[k] = static_cast<int>(k);
    EXPECT_TRUE(heights(0.01, all).empty());
}

/// A plate that a random displacement makes flow, `far` beyond it on the soft jumps alone, mm.
struct FlowingPlate {
    explicit FlowingPlate(double size, double far) {
        bulk.evaluate(random_vector(mesh.unknowns, size, 1));
        bulk.commit(false);
        u = bulk.committed_displacement() + random_vector(mesh.unknowns, 0.3 * size, 2);
        for (const int unknown : jumps.unknowns()) u[unknown] += far, u[unknown + 1] -= far;
        bulk.evaluate(u);
    }
    [[nodiscard]] double residual() const {
        double largest = 0.0;
        for (const int i : jumps.unknowns())
            largest = std::max({largest, std::abs(bulk.internal_force()[i]), std::abs(bulk.internal_force()[i + 1])});
        return largest;
    }

    [[nodiscard]] UnknownSet none() const { return UnknownSet(mesh.unknowns); }

    EnrichedMesh mesh = above_a_line(0.02);
    Bulk bulk = make_bulk(mesh, plate_case({}));
    SoftJumps jumps{bulk.elements(), {}, tolerance};
    Eigen::VectorXd u;
};

TEST(SoftJumps, BalanceWhereMetalFlows) {
    for (const double far : {0.0, 0.01, -0.1}) {
        FlowingPlate flowing(2e-3, far);
        const Eigen::VectorXd before = flowing.u;
        const double residual = flowing.residual(), scale = flowing.bulk.force_scale().maxCoeff();
        flowing.jumps.settle(flowing.bulk, flowing.u, Eigen::VectorXd::Zero(flowing.mesh.unknowns), flowing.none());
        EXPECT_GT(residual, 1e-3 * scale);
        EXPECT_LT(flowing.residual(), 0.02 * residual) << far;
        const std::vector<int> soft = flowing.jumps.unknowns();
        for (int i = 0; i < flowing.mesh.unknowns; ++i)
            EXPECT_TRUE(flowing.u[i] == before[i] || std::ranges::binary_search(soft, i) ||
                        std::ranges::binary_search(soft, i - 1));
    }
}

TEST(SoftJumps, LeaveTheBulkEvaluatedWhereTheyEnd) {
    FlowingPlate flowing(2e-3, 0.01);
    flowing.jumps.settle(flowing.bulk, flowing.u, Eigen::VectorXd::Zero(flowing.mesh.unknowns), flowing.none());
    const Eigen::VectorXd force = flowing.bulk.internal_force();
    std::vector<Eigen::MatrixXd> tangents;
    for (int e = 0; e < flowing.bulk.elements().count(); ++e) tangents.push_back(flowing.bulk.tangent(e));
    flowing.bulk.evaluate(flowing.u);
    EXPECT_EQ(flowing.bulk.internal_force(), force);
    for (int e = 0; e < flowing.bulk.elements().count(); ++e) EXPECT_EQ(flowing.bulk.tangent(e), tangents[at(e)]) << e;
}

TEST(SoftJumps, StayWhereTheyAreHeld) {
    FlowingPlate flowing(2e-3, 0.01);
    const Eigen::VectorXd before = flowing.u;
    const int first = flowing.jumps.unknowns().front();
    UnknownSet held = flowing.none();
    held.insert(first + 1);  // one component holds both
    flowing.jumps.settle(flowing.bulk, flowing.u, Eigen::VectorXd::Zero(flowing.mesh.unknowns), held);
    EXPECT_EQ(flowing.u[first], before[first]);
    EXPECT_NE(flowing.u, before);
    for (const int other : flowing.jumps.unknowns()) held.insert(other);
    const Eigen::VectorXd after = flowing.u;
    flowing.jumps.settle(flowing.bulk, flowing.u, Eigen::VectorXd::Zero(flowing.mesh.unknowns), held);
    EXPECT_EQ(flowing.u, after);
}

TEST(SoftJumps, StayWhereNothingFlows) {
    FlowingPlate flowing(1e-7, 0.0);
    const Eigen::VectorXd before = flowing.u;
    flowing.jumps.settle(flowing.bulk, flowing.u, Eigen::VectorXd::Ones(flowing.mesh.unknowns), flowing.none());
    EXPECT_EQ(flowing.u, before);
}

}  // namespace
}  // namespace stria::test
