// The auxiliary fields from half angles against those from the angle itself, and their mutual energy momentum.
#include "common/fracture/auxiliary_fields.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "common/fracture/domain_integral.hpp"
#include "tests/support/point_force_field.hpp"

namespace stria::test {
namespace {

std::vector<Tip> inclined_tips() {
    std::vector<Tip> tips;
    for (const Vec2& direction : {Vec2(1.0, 0.0), Vec2(-1.0, 0.0), Vec2(0.8, 0.6), Vec2(-0.6, -0.8)})
        for (const int upper : {1, -1})
            tips.push_back({.crack = 0, .position = {0.1, -0.2}, .direction = direction, .s = 0.0, .upper = upper});
    return tips;
}

std::array<TipField, 3> from_angle(const Tip& tip, const Vec2& x, int side, const Elasticity& elastic) {
    return {williams_field(1, tip, x, side, elastic), williams_field(2, tip, x, side, elastic),
            point_force_field(tip, tip_polar(tip, x, side), elastic)};
}

/// Places about a tip, with both sides and none.
template <class Visit> void for_each_place(const Tip& tip, Visit&& visit) {
    using std::numbers::pi;
    for (const double theta : {-pi, -3.1, -2.2, -pi / 2.0, -1.0, 0.0, 0.4, pi / 2.0, 1.7, 3.0, pi})
        for (const double r : {1e-3, 0.7, 40.0})
            for (const int side : {-1, 0, 1})
                visit(Vec2(tip.position + r * (tip_axes(tip) * Vec2(std::cos(theta), std::sin(theta)))), side);
}

class Auxiliary : public testing::TestWithParam<PlaneState> {
protected:
    const Elasticity elastic{1.0, 0.3, GetParam()};
};

TEST_P(Auxiliary, FieldsAreThoseOfTheAngle) {
    for (const Tip& tip : inclined_tips()) {
        const AuxiliaryFields fields(tip, elastic);
        for_each_place(tip, [&](const Vec2& x, int side) {
            const std::array<TipField, 3> exact = from_angle(tip, x, side, elastic);
            const std::array<AuxiliaryField, 3> found = fields.at(x, side);
            for (std::size_t k = 0; k < 3; ++k) {
                const double rounding = 1e-13 * elastic.young * exact[k].gradient.norm();
                const Eigen::Matrix2d stress = in_plane(exact[k].stress), &gradient = exact[k].gradient;
                EXPECT_NEAR(found[k].stress_xx, stress(0, 0), rounding);
                EXPECT_NEAR(found[k].stress_yy, stress(1, 1), rounding);
                EXPECT_NEAR(found[k].stress_xy, stress(0, 1), rounding);
                EXPECT_NEAR(found[k].strain_xx, gradient(0, 0), rounding);
                EXPECT_NEAR(found[k].strain_yy, gradient(1, 1), rounding);
                EXPECT_NEAR(found[k].shear, gradient(0, 1) + gradient(1, 0), rounding);
                EXPECT_LT((found[k].slope - gradient * tip.direction).norm(), rounding);
            }
        });
    }
}

// Against differences between two places along the tip.
TEST_P(Auxiliary, StressSlopesAreTheDerivativesOfTheStresses) {
    for (const Tip& tip : inclined_tips()) {
        const AuxiliaryFields fields(tip, elastic);
        for_each_place(tip, [&](const Vec2& x, int side) {
            const double r = (x - tip.position).norm(), step = 1e-5 * r;
            const double along = (x - tip.position).dot(tip.direction);
            if (side == 0 && along < -0.9999999 * r) return;        // on which face?
            if (side != 0 && std::abs(along) < 2.0 * step) return;  // a face ends there
            const auto stresses = [&](double ahead) {
                std::array<Mandel, 3> found;
                std::ranges::transform(
                    fields.at(x + ahead * tip.direction, side), found.begin(),
                    [](const AuxiliaryField& field) -> Mandel {
                        return {field.stress_xx, field.stress_yy, 0.0, std::numbers::sqrt2 * field.stress_xy};
                    });
                return found;
            };
            const std::array<Mandel, 3> before = stresses(-step), after = stresses(step);
            const std::array<Mandel, 3> slopes = fields.stress_slopes(x, side);
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_LT((slopes[k] - (after[k] - before[k]) / (2.0 * step)).norm(),
                          1e-9 * std::pow(r, k < 2 ? -1.5 : -2.0));
        });
    }
}

TEST_P(Auxiliary, WeightsOfTheMutualPartAreThoseOfItsDefinition) {
    const Eigen::Matrix2d gradient{{0.3, -0.2}, {0.5, 0.1}}, stress{{2.0, -1.5}, {-1.5, 0.7}};
    const Vec2 dq(0.4, -0.9);
    for (const Tip& tip : inclined_tips()) {
        const Vec2 x = tip.position + Vec2(0.3, 0.2), along = tip.direction;
        const std::array<TipField, 3> exact = from_angle(tip, x, 0, elastic);
        const std::array<AuxiliaryField, 3> fields = AuxiliaryFields(tip, elastic).at(x, 0);
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec2 mutual = stress * (exact[k].gradient * along) + in_plane(exact[k].stress) * (gradient * along) -
                                stress.cwiseProduct(exact[k].gradient).sum() * along;
            const MutualWeights weights(fields[k], along, dq);
            EXPECT_NEAR(weights.xx * stress(0, 0) + weights.yy * stress(1, 1) + weights.xy * stress(0, 1) +
                            weights.slope.dot(gradient * along),
                        mutual.dot(dq), 1e-13);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Plane, Auxiliary, testing::Values(PlaneState::Strain, PlaneState::Stress),
                         [](const auto& plane) { return plane.param == PlaneState::Strain ? "strain" : "stress"; });

}  // namespace
}  // namespace stria::test
