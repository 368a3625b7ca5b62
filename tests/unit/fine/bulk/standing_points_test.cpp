// Points that stand where they were last looked at, and what follows from there.
#include "fine/bulk/standing_points.hpp"

#include <gtest/gtest.h>

#include "common/error.hpp"
#include "tests/support/plate_bulk.hpp"
#include "tests/support/point_histories.hpp"

namespace stria::test {
namespace {

class Standing : public testing::Test {
protected:
    Standing() {
        for (int e = 0; e < plate.elements.count(); ++e) stand_at(e, 0.0);
    }
    void stand_at(int e, double strain) {
        points.stand_at(e, gather(plate.stretched(strain), plate.elements.op(e).unknowns), plate.elements, history);
    }
    [[nodiscard]] bool would_yield(int e, double strain) {
        return points.would_yield_at(e, plate.stretched(strain), plate.elements, history);
    }

    PlatePoints plate;
    fine::PointHistory history = plate.history();
    fine::StandingPoints points{plate.elements, nullptr};
    // Uniaxial strain: von Mises stress = 2 G strain.
    const double first_yield = 300.0 / (2.0 * plate.elastic.shear_modulus());
};

TEST_F(Standing, YieldWhereTheStateMeetsTheYieldCriterion) {
    for (const int e : {2, 20}) {
        EXPECT_FALSE(would_yield(e, 0.99 * first_yield));
        EXPECT_TRUE(would_yield(e, 1.01 * first_yield));
        EXPECT_TRUE(would_yield(e, -1.01 * first_yield));
        EXPECT_EQ(history.trial_stress(e, 0), Mandel(Mandel::Zero()));
        EXPECT_FALSE(history.yields(e));
    }
    EXPECT_EQ(history.evaluated(), 0);  // no law is asked where it would return to
}

// One corner moves so far that the squares of some stresses are no numbers, and those of points before them are.
TEST_F(Standing, ForgetALookThatFails) {
    constexpr int e = 12;
    int failed = 0;
    for (double way = 1e147; way < 1e151; way *= 1.1) {
        Eigen::VectorXd u = Eigen::VectorXd::Zero(plate.mesh.unknowns);
        u[plate.elements.op(e).unknowns[5]] = way;
        try {
            EXPECT_TRUE(points.would_yield_at(e, u, plate.elements, history));
        } catch (const NumericalFailure&) {
            ++failed;
        }
        EXPECT_FALSE(history.yields(e)) << way;
        for (int q = 0; q < history.points(e); ++q) EXPECT_EQ(history.trial_stress(e, at(q)), Mandel(Mandel::Zero()));
    }
    EXPECT_GT(failed, 0);
}

TEST_F(Standing, CountTheWayFromThere) {
    for (int e = 0; e < plate.elements.count(); ++e) {
        stand_at(e, 1e-4);  // the states are those of the beginning, here without stress
        EXPECT_FALSE(would_yield(e, 1e-4 + 0.99 * first_yield));
        EXPECT_TRUE(would_yield(e, 1e-4 + 1.01 * first_yield));
    }
}

// Brought there the points say what the elastic matrix has said: the force, and the energy as its work.
TEST_F(Standing, FollowByTheElasticMatrix) {
    const Eigen::VectorXd u = random_vector(plate.mesh.unknowns, 1e-5, 3);
    fine::ElementValues before(plate.elements.operators()), force = before, brought = before;
    for (int e = 0; e < plate.elements.count(); ++e) {
        const ElementOperator& op = plate.elements.op(e);
        stand_at(e, 0.0);
        points.bring_to(e, 0.5 * u, plate.elements, history);
        points.find_force(e, u, plate.elements, force);
        points.find_force(e, 0.5 * u, plate.elements, before);
        const Eigen::VectorXd ahead = points.ahead(op, e, u);
        const double stored = points.stored(e, u, plate.elements);
        EXPECT_NEAR(stored, 0.5 * ahead.dot(before.of(e) + force.of(e)), 1e-12 * stored);
        points.bring_to(e, u, plate.elements, history);
        EXPECT_EQ(points.displacement(e), gather(u, op.unknowns));
        points.find_force(e, u, plate.elements, brought);
        EXPECT_LT((brought.of(e) - force.of(e)).norm(), 1e-12 * force.of(e).norm());
        double energy = 0.0, energy_before = 0.0;
        for (std::size_t q = 0; q < op.points.size(); ++q) {
            energy += op.points[q].weight * plate.elastic.energy(history.stress(e, q));
            energy_before += 0.25 * op.points[q].weight * plate.elastic.energy(history.stress(e, q));
        }
        EXPECT_NEAR(energy - energy_before, stored, 1e-11 * energy);
    }
}

}  // namespace
}  // namespace stria::test
