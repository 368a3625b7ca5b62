// The auxiliary field of the T stress, and ring sums of exact fields: what is left is the error of the quadrature.
#include "common/fracture/domain_integral.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <numeric>

#include "common/geometry/vec2.hpp"
#include "tests/support/elastic_scene.hpp"
#include "tests/support/point_force_field.hpp"

namespace stria::test {
namespace {

using std::numbers::pi;

const Tip inclined{.crack = 0, .position = {0.1, -0.2}, .direction = {0.8, 0.6}, .s = 0.0, .upper = 1};

class PointForce : public testing::TestWithParam<PlaneState> {
protected:
    const Elasticity elastic{1000.0, 0.3, GetParam()};

    /// At polar coordinates of the inclined tip.
    [[nodiscard]] TipField at(double r, double theta) const {
        return point_force_field(inclined, tip_polar(inclined, place(r, theta), theta > 0.0 ? 1 : -1), elastic);
    }
    [[nodiscard]] static Vec2 place(double r, double theta) {
        return inclined.position + r * (tip_axes(inclined) * Vec2(std::cos(theta), std::sin(theta)));
    }
};

TEST_P(PointForce, GradientIsTheDerivativeOfTheDisplacement) {
    for (const double theta : {-2.9, -1.0, 0.4, 1.7, 3.0}) {
        const Vec2 x = place(0.7, theta);
        const int side = theta > 0.0 ? 1 : -1;
        for (const int axis : {0, 1}) {
            const Vec2 step = 1e-5 * Vec2::Unit(axis);
            const Vec2 difference =
                point_force_field(inclined, tip_polar(inclined, x + step, side), elastic).displacement -
                point_force_field(inclined, tip_polar(inclined, x - step, side), elastic).displacement;
            EXPECT_LT((difference / 2e-5 - at(0.7, theta).gradient.col(axis)).norm(), 1e-12);
        }
    }
}

TEST_P(PointForce, StressIsRadialAloneAndBalancesAUnitForce) {
    const int points = 360;
    Vec2 resultant = Vec2::Zero();
    for (int k = 0; k < points; ++k) {
        const double theta = -pi + (k + 0.5) * 2.0 * pi / points, r = 0.3;
        const Vec2 radial = (place(r, theta) - inclined.position) / r;
        const Eigen::Matrix2d exact = -std::cos(theta) / (pi * r) * radial * radial.transpose();
        EXPECT_LT((in_plane(at(r, theta).stress) - exact).norm(), 1e-12);
        resultant += in_plane(at(r, theta).stress) * radial * (r * 2.0 * pi / points);
    }
    EXPECT_LT((resultant + inclined.direction).norm(), 1e-12);
}

TEST_P(PointForce, TheJumpAcrossTheFacesIsConstant) {
    const auto jump = [&](double r) { return Vec2(at(r, pi).displacement - at(r, -pi).displacement); };
    EXPECT_GT(jump(1.0).norm(), 1e-5);
    EXPECT_LT((jump(1.0) - jump(0.01)).norm(), 1e-15);
}

INSTANTIATE_TEST_SUITE_P(Plane, PointForce, testing::Values(PlaneState::Strain, PlaneState::Stress),
                         [](const auto& plane) { return plane.param == PlaneState::Strain ? "strain" : "stress"; });

/// K_I, K_II, T, and a pressure p and a shear tau on the faces: Williams fields, sigma_11 = T, -p in all directions,
/// and sigma_12 = tau.
struct ExactField {
    double K_I, K_II, T, p, tau;
    Elasticity elastic;

    [[nodiscard]] TipField at(const Tip& tip, const Vec2& x, int side) const {
        const TipField I = williams_field(1, tip, x, side, elastic), II = williams_field(2, tip, x, side, elastic);
        const Eigen::Matrix2d axes = tip_axes(tip);
        const Eigen::Matrix2d stress = axes * Eigen::Matrix2d{{T - p, tau}, {tau, -p}} * axes.transpose();
        TipField sum;
        sum.gradient = K_I * I.gradient + K_II * II.gradient + gradient_of(stress, elastic);
        sum.stress = elastic.stiffness() * strain_of(sum.gradient);
        return sum;
    }
    [[nodiscard]] double work(const TipField& field) const { return 0.5 * field.stress.dot(strain_of(field.gradient)); }
};

std::vector<DomainIntegral> ring_sums(const EnrichedMesh& mesh, const ExactField& field,
                                      const std::vector<Annulus>& rings) {
    const Tip& tip = mesh.tips.front();
    std::vector<int> all(mesh.elements.size());
    std::iota(all.begin(), all.end(), 0);
    RingSums sums(mesh, tip, field.elastic, rings, all);
    for (const double load : {2.0, 1.0}) {  // the second time in places that are known
        sums.clear();
        for (const int e : sums.elements()) {
            sums.enter(e);
            const IntegrationRule rule{.subcells = 2, .singular_gauss = 4, .tip_points = 6};
            for (const IntegrationPoint& point : make_operator(mesh, e, piece_in(mesh, e), rule).points) {
                const TipField at = field.at(tip, point.x, point.side);
                sums.add(point, load * at.stress, load * at.gradient, load * load * field.work(at));
            }
        }
    }
    for (const FaceStation& station : face_stations_about(mesh, tip, 2, 4)) {
        const Eigen::Matrix2d jump = field.at(tip, station.x, 1).gradient - field.at(tip, station.x, -1).gradient;
        const Vec2 slope = jump * station.tangent;
        sums.add_faces(station, {field.p, field.tau, station.normal.dot(slope), station.tangent.dot(slope)});
    }
    return {sums.values().begin(), sums.values().end()};
}

TEST(RingSums, TellWhatThePressureOfAWakeAdds) {
    const EnrichedMesh mesh = cracked(square_mesh(9), {{0.0, 0.52}, {0.52, 0.52}});
    const Tip& tip = mesh.tips.front();
    const auto pressed = [&](bool in_wake) {
        RingSums sums(mesh, tip, Elasticity{1000.0, 0.3}, {{0.2, 0.4}}, {});
        for (const FaceStation& station : face_stations_about(mesh, tip, 2, 4))
            sums.add_faces(
                station, {.pressure = 2.0, .shear = 0.3, .opening_slope = 0.0, .slip_slope = 0.0, .in_wake = in_wake});
        return sums.values().front();
    };
    const DomainIntegral in_wake = pressed(true), elsewhere = pressed(false);
    EXPECT_GT(in_wake.wake_I, 0.0);  // it is a wedge
    EXPECT_NEAR(in_wake.wake_I, in_wake.interaction_I, 1e-12 * in_wake.wake_I);
    EXPECT_NEAR(in_wake.wake_II, 0.0,
                1e-12 * in_wake.wake_I);  // shear is borne by what it brakes, and not by the metal
    EXPECT_LT(in_wake.interaction_II, 0.0);
    EXPECT_EQ(in_wake.interaction_I, elsewhere.interaction_I);
    EXPECT_EQ(elsewhere.wake_I, 0.0);
    EXPECT_EQ(elsewhere.wake_II, 0.0);
}

TEST(RingSums, WithoutItsMeanRotationAFieldLosesNothing) {
    const EnrichedMesh mesh = cracked(distorted(square_mesh(9), 0.01), {{0.0, 0.41}, {0.52, 0.53}});
    const Tip& tip = mesh.tips.front();
    const Elasticity elastic{1000.0, 0.3};
    std::vector<int> all(mesh.elements.size());
    std::iota(all.begin(), all.end(), 0);
    const auto sum_with = [&](double angle) {
        RingSums sums(mesh, tip, elastic, {{0.2, 0.4}}, all);
        for (const int e : sums.elements()) {
            sums.enter(e);
            for (const IntegrationPoint& point : make_operator(mesh, e, piece_in(mesh, e), {}).points) {
                TipField field = williams_field(1, tip, point.x, point.side, elastic);
                field.gradient += Eigen::Matrix2d{{0.0, -angle}, {angle, 0.0}};
                sums.add(point, field.stress, field.gradient, 0.5 * field.stress.dot(strain_of(field.gradient)));
            }
        }
        return sums.values().front();
    };
    const DomainIntegral itself = sum_with(0.0), turned = sum_with(10.0);
    EXPECT_GT(std::abs(turned.interaction_I - itself.interaction_I), 1e-3 * itself.interaction_I);
    const DomainIntegral left = itself.without_rotation(), of_turned = turned.without_rotation();
    EXPECT_NEAR(of_turned.interaction_I, left.interaction_I, 1e-9 * left.interaction_I);
    EXPECT_NEAR(of_turned.interaction_II, left.interaction_II, 1e-9 * left.interaction_I);
    EXPECT_NEAR(of_turned.interaction_T, left.interaction_T, 1e-9 * left.interaction_I);
}

TEST(RingSums, GiveBackTheParametersOfExactFields) {
    const Mesh mesh = distorted(square_mesh(21), 0.004);
    for (const auto& crack :
         {std::vector<Vec2>{{0.0, 0.41}, {0.52, 0.53}}, std::vector<Vec2>{{0.52, 0.53}, {0.0, 0.41}}}) {
        for (const PlaneState plane : {PlaneState::Strain, PlaneState::Stress}) {
            for (const double p : {0.0, 0.8}) {
                const ExactField field{1.0, -0.4, 0.7, p, -0.75 * p, {1000.0, 0.3, plane}};
                const double E = field.elastic.plane_modulus();
                for (const DomainIntegral& of_ring :
                     ring_sums(cracked(mesh, crack), field, {{0.2, 0.4}, {0.3, 0.4}, {0.14, 0.28}})) {
                    const DomainIntegral sum = of_ring.without_rotation();
                    EXPECT_NEAR(E * sum.J, 1.0 + 0.16, 2e-4);
                    EXPECT_NEAR(E / 2.0 * sum.interaction_I, 1.0, 1e-4);
                    EXPECT_NEAR(E / 2.0 * sum.interaction_II, -0.4, 1e-4);
                    EXPECT_NEAR(E * sum.interaction_T, 0.7, 1e-3);
                }
            }
        }
    }
}

}  // namespace
}  // namespace stria::test
