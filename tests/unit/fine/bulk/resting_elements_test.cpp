// Elements at rest: who may, who would yield, and that asking leaves the history alone.
#include "fine/bulk/resting_elements.hpp"

#include <gtest/gtest.h>

#include "tests/support/point_histories.hpp"

namespace stria::test {
namespace {

using fine::PointHistory;
using fine::RestingElements;

class Rest : public testing::Test {
protected:
    Rest() {
        for (const ElementOperator& op : plate.elements.operators())
            bound.add_element(op, plate.elastic.shear_modulus());
    }
    [[nodiscard]] std::vector<int> would_yield(double strain) {
        return resting.would_yield(plate.stretched(strain), plate.elements, history, bound);
    }

    PlatePoints plate;
    PointHistory history = plate.history();
    fine::ElasticBound bound;
    RestingElements resting{plate.elements.operators(), Eigen::VectorXd::Zero(plate.mesh.unknowns)};
};

TEST_F(Rest, IsForThoseThatStayedElasticForAWholeCycle) {
    resting.count_half_cycle(history);
    EXPECT_TRUE(resting.may_rest(history).none());
    history.set_plastic(3, 0, true);
    resting.count_half_cycle(history);
    EXPECT_EQ(resting.may_rest(history).count(), plate.elements.count() - 1);
    EXPECT_FALSE(resting.may_rest(history).contains(3));
    history.set_plastic(3, 0, false);
    resting.count_half_cycle(history);
    EXPECT_FALSE(resting.may_rest(history).contains(3));
    resting.count_half_cycle(history);
    EXPECT_TRUE(resting.may_rest(history).contains(3));
}

TEST_F(Rest, EndsWhereTheStateMeetsTheYieldCriterion) {
    ElementSet some(plate.elements.operators().size());
    some.insert(2);
    some.insert(20);
    resting.rest(some, plate.stretched(0.0), plate.elements.operators());
    // Uniaxial strain: von Mises stress = 2 G strain.
    const double first_yield = 300.0 / (2.0 * plate.elastic.shear_modulus());
    EXPECT_TRUE(would_yield(0.99 * first_yield).empty());
    EXPECT_EQ(would_yield(1.01 * first_yield), (std::vector<int>{2, 20}));
    resting.wake(2);
    EXPECT_EQ(would_yield(-1.01 * first_yield), std::vector<int>{20});
    EXPECT_EQ(history.trial_stress(20, 0), Mandel(Mandel::Zero()));
    EXPECT_FALSE(history.yields(20));
}

TEST_F(Rest, CountsTheWayFromWhereItBegan) {
    resting.rest(ElementSet(plate.elements.operators().size(), true), plate.stretched(1e-4),
                 plate.elements.operators());
    const ElementOperator& op = plate.elements.op(7);
    EXPECT_LT((resting.moved(op, plate.stretched(3e-4)) - gather(plate.stretched(2e-4), op.unknowns)).norm(), 1e-15);
    // The states are those of the beginning, here without stress.
    const double first_yield = 300.0 / (2.0 * plate.elastic.shear_modulus());
    EXPECT_TRUE(would_yield(1e-4 + 0.99 * first_yield).empty());
    EXPECT_EQ(would_yield(1e-4 + 1.01 * first_yield).size(), plate.elements.operators().size());
}

}  // namespace
}  // namespace stria::test
