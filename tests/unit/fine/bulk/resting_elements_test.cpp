// Elements at rest: who may.
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
    PlatePoints plate;
    PointHistory history = plate.history();
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
    history.set_flow(3, 0, 1e-9);
    resting.note_half_cycle(history);
    EXPECT_EQ(may_rest().count(), plate.elements.count());
    history.set_flow(3, 0, 0.0);
    resting.note_half_cycle(history);
    for (int e = 0; e < plate.elements.count(); ++e) EXPECT_EQ(may_rest().contains(e), !touches(e, 3)) << e;
    EXPECT_GT(may_rest().count(), 0);
    resting.note_half_cycle(history);
    EXPECT_EQ(may_rest().count(), plate.elements.count());
    yielded.insert(5);
    EXPECT_FALSE(may_rest().contains(5));
}

}  // namespace
}  // namespace stria::test
