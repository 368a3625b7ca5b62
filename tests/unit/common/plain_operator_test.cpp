// The operator of a plain element against the one that every element can have.
#include "common/fem/plain_operator.hpp"

#include <gtest/gtest.h>

#include "common/material/elasticity.hpp"
#include "tests/support/cracked_mesh.hpp"

namespace stria::test {
namespace {

class PlainAgainstGeneral : public ::testing::TestWithParam<bool> {};

TEST_P(PlainAgainstGeneral, SameOperator) {
    const Mesh mesh = distorted(square_mesh(6), 0.02);
    const EnrichedMesh enriched = cracked(mesh, {{0.0, 0.46}, {0.5, 0.48}});
    const MandelMatrix elastic = Elasticity{200e3, 0.3, PlaneState::Strain}.stiffness();
    int plain = 0;
    for (int e = 0; e < static_cast<int>(mesh.elements.size()); ++e) {
        if (!is_plain(enriched, e)) continue;
        ++plain;
        const ElementOperator general =
            make_operator(enriched, e, nullptr,
                          {.mean_dilatation = GetParam() ? MeanDilatation::Everywhere : MeanDilatation::Nowhere});
        const PlainOperator op = plain_operator(enriched, e, GetParam());
        EXPECT_TRUE(std::ranges::equal(op.unknowns, general.unknowns));
        EXPECT_NEAR(op.area, general.area, 1e-15);
        EXPECT_LT((op.stiffness(elastic) - general.stiffness(elastic)).norm(), 1e-14 * elastic.norm());
        const Eigen::VectorXd u = Eigen::VectorXd::LinSpaced(enriched.unknowns, -1.0, 2.0).array().sin();
        const auto local = gather(u, op.unknowns);
        PlainOperator::Values force = PlainOperator::Values::Zero();
        Eigen::VectorXd general_force = Eigen::VectorXd::Zero(8);
        for (std::size_t q = 0; q < 4; ++q) {
            EXPECT_LT((op.strain(local, q) - general.strain(local, q)).norm(), 1e-12);
            EXPECT_LT((op.displacement_gradient(local, q) - general.displacement_gradient(local, q)).norm(), 1e-12);
            op.add_force(elastic * op.strain(local, q), q, force);
            general.add_force(elastic * general.strain(local, q), q, general_force);
        }
        EXPECT_LT((force - general_force).norm(), 1e-13 * general_force.norm());
    }
    EXPECT_GT(plain, 10);
}

INSTANTIATE_TEST_SUITE_P(MeanDilatation, PlainAgainstGeneral, ::testing::Bool());

}  // namespace
}  // namespace stria::test
