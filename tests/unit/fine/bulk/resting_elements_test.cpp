// Elements at rest: who may, who would yield, and that asking leaves the history alone.
#include "fine/bulk/resting_elements.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/point_histories.hpp"

namespace stria::test {
namespace {

using fine::PointHistory;
using fine::RestingElements;

class Rest : public testing::Test {
protected:
    Rest() {
        for (const ElementOperator& op : plate.elements.operators())
            bound.add_element(op, fine::VonMisesForm(plate.elastic.stiffness()));
    }
    [[nodiscard]] std::vector<int> would_yield(double strain) {
        return resting.would_yield(plate.stretched(strain), plate.elements, history, bound);
    }

    PlatePoints plate;
    PointHistory history = plate.history();
    fine::ElasticBound bound;
    RestingElements resting{plate.elements, Eigen::VectorXd::Zero(plate.mesh.unknowns)};
};

// Nothing is known before a half cycle of each direction has passed. Then what has flowed rests in the other direction.
TEST_F(Rest, IsForThoseThatStayedElasticTheLastTimeInThisDirectionAndWhatIsAroundThem) {
    ElementSet yielded(plate.elements.operators().size());
    const auto may_rest = [&] { return resting.may_rest(plate.elements, history, yielded); };
    const auto touches = [&](int e, int other) {
        const auto& nodes = plate.mesh.elements[at(other)];
        return std::ranges::any_of(plate.mesh.elements[at(e)],
                                   [&](int node) { return std::ranges::find(nodes, node) != nodes.end(); });
    };
    resting.note_half_cycle(history);
    EXPECT_TRUE(may_rest().none());
    history.set_plastic(3, 0, true);
    resting.note_half_cycle(history);
    EXPECT_EQ(may_rest().count(), plate.elements.count());
    history.set_plastic(3, 0, false);
    resting.note_half_cycle(history);
    for (int e = 0; e < plate.elements.count(); ++e) EXPECT_EQ(may_rest().contains(e), !touches(e, 3)) << e;
    EXPECT_GT(may_rest().count(), 0);
    resting.note_half_cycle(history);
    EXPECT_EQ(may_rest().count(), plate.elements.count());
    yielded.insert(5);
    EXPECT_FALSE(may_rest().contains(5));
}

TEST_F(Rest, EndsWhereTheStateMeetsTheYieldCriterion) {
    ElementSet some(plate.elements.operators().size());
    some.insert(2);
    some.insert(20);
    resting.rest(some, plate.stretched(0.0), bound);
    // Uniaxial strain: von Mises stress = 2 G strain.
    const double first_yield = 300.0 / (2.0 * plate.elastic.shear_modulus());
    EXPECT_TRUE(would_yield(0.99 * first_yield).empty());
    EXPECT_EQ(would_yield(1.01 * first_yield), (std::vector<int>{2, 20}));
    ElementSet one(some.size());
    one.insert(2);
    resting.wake(one);
    EXPECT_EQ(std::ssize(resting.awake()), some.size() - 1);
    EXPECT_EQ(would_yield(-1.01 * first_yield), std::vector<int>{20});
    EXPECT_EQ(history.trial_stress(20, 0), Mandel(Mandel::Zero()));
    EXPECT_FALSE(history.yields(20));
}

TEST_F(Rest, CountsTheWayFromWhereItBegan) {
    resting.rest(ElementSet(plate.elements.operators().size(), true), plate.stretched(1e-4), bound);
    // The states are those of the beginning, here without stress.
    const double first_yield = 300.0 / (2.0 * plate.elastic.shear_modulus());
    EXPECT_TRUE(would_yield(1e-4 + 0.99 * first_yield).empty());
    EXPECT_EQ(would_yield(1e-4 + 1.01 * first_yield).size(), plate.elements.operators().size());
}

}  // namespace
}  // namespace stria::test
