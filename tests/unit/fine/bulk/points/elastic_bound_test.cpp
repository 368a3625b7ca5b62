// The bound that saves the points of elastic elements from being looked at.
#include "fine/bulk/points/elastic_bound.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "common/fem/centre.hpp"
#include "fine/bulk/bulk_report.hpp"
#include "tests/support/material_point.hpp"
#include "tests/support/plate_bulk.hpp"

namespace stria::test {
namespace {

using coupling::ZoneState;
using fine::Bulk;

class ElasticBound : public testing::TestWithParam<PlaneState> {
protected:
    ElasticBound() {
        scene.model.plane = GetParam();
        plate = plate_mesh(5, 5, scene);
    }
    Case scene = plate_case({{0.0, 2.4}, {2.3, 2.6}});  // cut, tip and plain elements
    EnrichedMesh plate;
};

TEST_P(ElasticBound, ProvesNothingOfWhatIsNoNumber) {
    const Bulk bulk = make_bulk(plate, scene);
    const Eigen::VectorXd u = Eigen::VectorXd::Constant(plate.unknowns, std::numeric_limits<double>::quiet_NaN());
    for (const ElementOperator& op : bulk.operators()) {
        fine::ElasticBound bound;
        bound.add_element(op, corners_of_element(plate, op.element),
                          fine::VonMisesForm(elasticity_of(scene.material, scene.model.plane).stiffness()));
        bound.look_at(0, Eigen::VectorXd::Zero(std::ssize(op.unknowns)), 1e3);
        EXPECT_FALSE(bound.proves_at(0, u)) << op.element;
    }
}

// Down to the largest von Mises stress of a point, and no further.
TEST_P(ElasticBound, IsThatOfThePointThatChangesMost) {
    const Bulk bulk = make_bulk(plate, scene);
    const Elasticity elastic = elasticity_of(scene.material, scene.model.plane);
    for (const unsigned seed : {1U, 2U, 3U}) {
        const Eigen::VectorXd u = random_vector(plate.unknowns, 1e-3, seed);
        for (const ElementOperator& op : bulk.operators()) {
            const Eigen::VectorXd element_u = gather(u, op.unknowns);
            double largest = 0.0;
            for (std::size_t q = 0; q < op.points.size(); ++q)
                largest = std::max(largest, von_mises(elastic.stiffness() * op.strain(element_u, q)));
            fine::ElasticBound bound;
            bound.add_element(op, corners_of_element(plate, op.element), fine::VonMisesForm(elastic.stiffness()));
            bound.look_at(0, 0.0 * element_u, 0.999 * largest);
            EXPECT_FALSE(bound.proves_at(0, u)) << op.element;
            bound.look_at(0, 0.0 * element_u, 1.001 * largest);
            EXPECT_TRUE(bound.proves_at(0, u)) << op.element;
            EXPECT_FALSE(bound.proves_at(0, u, 0.5)) << op.element;
            EXPECT_TRUE(bound.proves_at(0, 0.499 * u, 0.5)) << op.element;
            bound.look_at(0, -element_u, 1.001 * largest);
            EXPECT_FALSE(bound.proves_at(0, u)) << op.element;
            EXPECT_TRUE(bound.proves_at(0, -0.5 * u)) << op.element;
        }
    }
}

// Small increments are proven elastic; what is committed is what the points say, and yielding is never overlooked.
TEST_P(ElasticBound, ChangesNoResult) {
    Bulk proving = make_bulk(plate, scene);
    const Eigen::VectorXd u = random_vector(plate.unknowns, 4e-3, 7);
    for (int k = 1; k <= 40; ++k) {
        proving.evaluate(k / 40.0 * u);
        const Eigen::VectorXd trial_force = proving.internal_force();
        const std::vector<std::int32_t> yielding = yielding_points(proving);
        proving.commit(false);
        const ZoneState state = state_of(proving);
        Eigen::VectorXd force = Eigen::VectorXd::Zero(plate.unknowns);
        std::size_t point = 0;
        for (const ElementOperator& op : proving.operators()) {
            Eigen::VectorXd of_element = Eigen::VectorXd::Zero(std::ssize(op.unknowns));
            for (std::size_t q = 0; q < op.points.size(); ++q, ++point) {
                const Mandel stress(state.stress[4 * point], state.stress[4 * point + 1], state.stress[4 * point + 2],
                                    state.stress[4 * point + 3]);
                of_element += op.points[q].weight * op.strain_matrix(q).transpose() * stress;
            }
            force(op.unknowns) += of_element;
        }
        EXPECT_LT((force - trial_force).cwiseAbs().maxCoeff(), 1e-11 * force.cwiseAbs().maxCoeff()) << k;
        EXPECT_EQ(yielding_points(proving), yielding) << k;
    }
    const coupling::WorkCounts counts = proving.counts();
    EXPECT_GT(counts.points_proven_elastic, 0);
    EXPECT_GT(counts.tangents_computed, 0);
    EXPECT_GT(counts.elastic_tangents_reused, 0);
}

INSTANTIATE_TEST_SUITE_P(PlaneStates, ElasticBound, testing::Values(PlaneState::Strain, PlaneState::Stress),
                         [](const auto& test) { return test.param == PlaneState::Strain ? "strain" : "stress"; });

}  // namespace
}  // namespace stria::test
