// The operator of a plain element against the one that every element can have.
#include "common/integration/plain_operator.hpp"

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

TEST_P(PlainAgainstGeneral, NoPointIsFartherFromTheMeanThanItsWarping) {
    const Mesh mesh = distorted(square_mesh(6), 0.03);
    const EnrichedMesh enriched = cracked(mesh, {{0.0, 0.46}, {0.5, 0.48}});
    for (int e = 0; e < static_cast<int>(mesh.elements.size()); ++e) {
        if (!is_plain(enriched, e)) continue;
        const PlainOperator op = plain_operator(enriched, e, GetParam());
        const PlainOperator::Values u = PlainOperator::Values::LinSpaced(-1.0, 2.0 + e).array().sin();
        double farthest = 0.0;
        for (std::size_t q = 0; q < 4; ++q) {
            const Eigen::Matrix2d rest = u.reshaped(2, 4) * (op.gradients[q] - op.mean);
            EXPECT_LE((op.strain(u, q) - op.mean_strain(u)).norm(), op.warping(u) * (1.0 + 1e-12));
            EXPECT_LE(rest.norm(), op.warping(u) * (1.0 + 1e-12));
            farthest = std::max(farthest, rest.norm());
        }
        EXPECT_NEAR(farthest, op.warping(u), 1e-12 * op.warping(u));
    }
}

TEST(Elasticity, NoStrainHasALargerStressThanItsSizeAllows) {
    for (const PlaneState plane : {PlaneState::Strain, PlaneState::Stress}) {
        for (const double poisson : {0.0, 0.3, 0.49}) {
            const Elasticity elastic{200e3, poisson, plane};
            double largest = 0.0;
            for (int k = 0; k < 360; ++k) {
                const double angle = k * std::numbers::pi / 180.0;
                for (const double share : {0.0, 0.3, 1.0}) {
                    Mandel strain{std::cos(angle), std::sin(angle), 0.0, share};
                    strain.normalize();
                    largest = std::max(largest, von_mises(elastic.stiffness() * strain));
                }
            }
            EXPECT_LE(largest, elastic.largest_von_mises() * (1.0 + 1e-12));
            EXPECT_GE(largest, elastic.largest_von_mises() * (1.0 - 1e-3));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(MeanDilatation, PlainAgainstGeneral, ::testing::Bool());

}  // namespace
}  // namespace stria::test
