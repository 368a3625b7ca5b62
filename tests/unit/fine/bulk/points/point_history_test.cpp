// What points remember: each its own numbers, trial apart from committed, plastic for a half cycle.
#include "fine/bulk/points/point_history.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "fine/material/catalogue/material_catalogue.hpp"
#include "tests/support/point_histories.hpp"

namespace stria::test {
namespace {

using fine::PointHistory;

class PointHistories : public testing::Test {
protected:
    void update(const Eigen::VectorXd& increment) {
        history.update(plate.elements.operators(), 0, plate.elements.count(), increment);
    }
    [[nodiscard]] int count() const { return plate.elements.count(); }

    PlatePoints plate;
    PointHistory history = plate.history();
};

TEST_F(PointHistories, KeepEachPointsOwnNumbers) {
    const auto strain_of = [](int e, std::size_t q) {
        return Mandel(1e-6 * e, 1e-8 * static_cast<double>(q), 0, 1e-6);
    };
    for (int e = 0; e < count(); ++e)
        for (std::size_t q = 0; q < at(history.points(e)); ++q) history.begin(e, q, strain_of(e, q), Mandel::Zero());
    for (int e = 0; e < count(); ++e) {
        for (std::size_t q = 0; q < at(history.points(e)); ++q) {
            const Mandel stress = plate.elastic.stiffness() * strain_of(e, q);
            EXPECT_EQ(history.stress(e, q), stress);
            EXPECT_EQ(history.trial_stress(e, q), Mandel(Mandel::Zero()));  // until rollback()
            for (int c = 0; c < 4; ++c)
                EXPECT_EQ(history.stresses(e)[c * history.points() + static_cast<int>(q)], stress[c]);
        }
    }
    history.rollback();
    EXPECT_EQ(history.trial_stress(count() - 1, 0), history.stress(count() - 1, 0));
}

TEST_F(PointHistories, CommitOneElementAlone) {
    update(plate.stretched(1e-4));
    history.commit(1, 2);
    EXPECT_EQ(history.stress(1, 0), history.trial_stress(1, 0));
    EXPECT_GT(history.stress(1, 0).norm(), 1.0);
    EXPECT_EQ(history.stress(0, 0), Mandel(Mandel::Zero()));
    history.rollback(0);
    EXPECT_EQ(history.trial_stress(0, 0), Mandel(Mandel::Zero()));
    EXPECT_NE(history.trial_stress(2, 0), Mandel(Mandel::Zero()));
}

// Straight on from where they were committed they would yield in another direction, which a return in parts sees.
TEST_F(PointHistories, GoAnElasticWayBeforeTheirIncrement) {
    history = {fine::make_material_laws(Materials(plate.input), 4), plate.mesh.material, plate.elements.operators()};
    const ElementOperator& op = plate.elements.op(0);
    const Eigen::VectorXd way = gather(plate.stretched(-1e-3), op.unknowns);
    Eigen::VectorXd increment = gather(plate.stretched(4e-3), op.unknowns);
    for (Eigen::Index k = 0; k < increment.size(); k += 2) std::swap(increment[k], increment[k + 1]);
    const Mandel before = history.stress(0, 0);
    history.update(op, 0, way, increment);
    const Mandel behind = history.trial_stress(0, 0);
    EXPECT_TRUE(history.yields(0));
    EXPECT_EQ(history.stress(0, 0), before);
    history.update(op, 0, way + increment);
    EXPECT_GT((history.trial_stress(0, 0) - behind).norm(), 1e-3 * behind.norm());
    history.update(op, 0, way);
    EXPECT_FALSE(history.yields(0));
    history.commit(0, 1);
    history.update(op, 0, increment);
    EXPECT_EQ(history.trial_stress(0, 0), behind);
}

TEST_F(PointHistories, KeepWhatIsCommittedWhereAnIncrementFails) {
    const ElementOperator& op = plate.elements.op(0);
    const Eigen::VectorXd way = gather(plate.stretched(-1e-3), op.unknowns);
    const Mandel before = history.stress(0, 0);
    const Eigen::VectorXd endless = Eigen::VectorXd::Constant(way.size(), std::numeric_limits<double>::quiet_NaN());
    EXPECT_THROW(history.update(op, 0, way, endless), NumericalFailure);
    EXPECT_EQ(history.stress(0, 0), before);
}

TEST_F(PointHistories, CountWhoYieldsPerElement) {
    update(plate.stretched(5e-3));
    for (int e = 0; e < count(); ++e) {
        EXPECT_EQ(history.yielding_points(e), history.points(e)) << e;
        EXPECT_GT(history.largest_plastic_increment(e), 1e-3) << e;
    }
    EXPECT_EQ(history.accumulated(0, 0), 0.0);  // committed
    history.set_elastic(3);
    for (int e = 0; e < count(); ++e) EXPECT_EQ(history.yielding_points(e), e == 3 ? 0 : history.points(e)) << e;
    EXPECT_EQ(history.largest_plastic_increment(3), 0.0);
}

TEST_F(PointHistories, ArePlasticUntilTheHalfCycleAfter) {
    const Eigen::VectorXd nothing = Eigen::VectorXd::Zero(plate.mesh.unknowns);
    update(plate.stretched(5e-3));
    EXPECT_FALSE(history.is_plastic(0));
    history.commit(true, ElementSet(count()));
    EXPECT_TRUE(history.is_plastic(0));
    EXPECT_EQ(history.flow(0, 0), history.accumulated(0, 0));
    EXPECT_TRUE(history.half_cycle_ended());
    update(nothing);
    history.commit(false, ElementSet(count()));
    EXPECT_FALSE(history.is_plastic(0));
    EXPECT_EQ(history.flow(0, 0), 0.0);
    EXPECT_GT(history.accumulated(0, 0), 1e-3);
}

TEST_F(PointHistories, AddSharesOfAnother) {
    PointHistory other = plate.history();
    other.begin(0, 0, {1e-4, 0, 0, 0}, Mandel::Zero());
    other.begin(0, 1, {0, 2e-4, 0, 0}, Mandel::Zero());
    other.set_flow(0, 1, 4e-4);
    history.add_share(5, 2, 0.25, other, 0, 0);
    EXPECT_EQ(history.flow(5, 2), 0.0);
    history.add_share(5, 2, 0.75, other, 0, 1);
    EXPECT_DOUBLE_EQ(history.flow(5, 2), 3e-4);
    const Mandel mean = plate.elastic.stiffness() * Mandel(0.25e-4, 1.5e-4, 0, 0);
    EXPECT_LT((history.stress(5, 2) - mean).norm(), 1e-12 * mean.norm());
    EXPECT_EQ(history.stress(5, 1), Mandel(Mandel::Zero()));
}

TEST_F(PointHistories, HaveNoFrozenGradientUntilOneIsKept) {
    EXPECT_FALSE(history.has_frozen_gradients());
    EXPECT_TRUE(history.frozen_gradient(4, 1).isZero(0.0));
    const Eigen::Matrix2d gradient = (Eigen::Matrix2d() << 1, 2, 3, 4).finished();
    history.freeze_gradient(4, 1, gradient);
    EXPECT_TRUE(history.has_frozen_gradients());
    EXPECT_EQ(history.frozen_gradient(4, 1), gradient);
    EXPECT_TRUE(history.frozen_gradient(4, 0).isZero(0.0));
}

}  // namespace
}  // namespace stria::test
