// Weights on points that stay: exact for quadratics on either side of any cut, never negative.
#include "common/integration/moment_fit.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <cmath>

#include "tests/support/cracked_mesh.hpp"

namespace stria::test {
namespace {

TEST(NonNegativeLeastSquares, FindsWhatTheConditionsAllow) {
    const Eigen::MatrixXd A{{1.0, 2.0, 0.0}, {0.0, 1.0, 1.0}, {1.0, 0.0, 3.0}};
    const Eigen::Vector3d inside(0.5, 1.0, 2.0);
    // Without the bound the second would be negative: the gradient there points outwards.
    const Eigen::VectorXd b = A * Eigen::Vector3d(1.0, -1.0, 1.0);
    for (const Eigen::Vector3d& first : {Eigen::Vector3d(0.0, 0.0, 0.0), {1.0, 2.0, 3.0}, {0.0, 5.0, 0.0}}) {
        EXPECT_LT((non_negative_least_squares(A, A * inside, first) - inside).norm(), 1e-12);
        const Eigen::VectorXd x = non_negative_least_squares(A, b, first), slope = A.transpose() * (b - A * x);
        EXPECT_GE(x.minCoeff(), 0.0);
        for (Eigen::Index k = 0; k < 3; ++k) {
            EXPECT_LE(slope[k], 1e-12);
            EXPECT_NEAR(slope[k] * x[k], 0.0, 1e-12);
        }
    }
}

class CutSquare : public testing::Test {
protected:
    // One element, cut from edge to edge.
    void cut(const Vec2& from, const Vec2& to, const std::vector<IntegrationPoint>& more = {}) {
        const Mesh mesh = square_mesh(1);
        const EnrichedMesh enriched = cracked(mesh, {from, to}, 0);
        corners_ = corners_of_element(enriched, 0);
        sides_ = cut_element(corners_, enriched.pieces.front());
        points_ = place_points(corners_, nullptr, {}, false, {.subcells = 2});
        points_.insert(points_.end(), more.begin(), more.end());
        count_ = points_.size();
        fit_weights(sides_, corners_, points_);
    }

    [[nodiscard]] double integral(int side, const std::function<double(const Vec2&)>& f) const {
        double sum = 0.0;
        for (const IntegrationPoint& point : points_)
            if (point.side == side) sum += point.weight * f(point.x);
        return sum;
    }

    std::array<Vec2, 4> corners_;
    CutElement sides_;
    std::vector<IntegrationPoint> points_;
    std::size_t count_ = 0;
};

TEST_F(CutSquare, AreasAndFirstMomentsAreExactWhereverItIsCut) {
    for (int k = 0; k < 200; ++k) {
        const Vec2 through(0.5 + 0.45 * std::sin(5.0 * k), 0.5 + 0.45 * std::cos(9.0 * k));
        const Vec2 along(std::cos(0.7 * k), std::sin(0.7 * k));
        cut(through - 3.0 * along, through + 3.0 * along);
        for (const int side : {1, -1}) {
            const std::vector<Vec2>& polygon = side > 0 ? sides_.left : sides_.right;
            const double area = polygon_area(polygon);
            Vec2 moment = Vec2::Zero();
            for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
                moment += triangle_area(polygon[0], polygon[i], polygon[i + 1]) *
                          (polygon[0] + polygon[i] + polygon[i + 1]) / 3.0;
            }
            EXPECT_NEAR(integral(side, [](const Vec2&) { return 1.0; }), area, 2e-6 * area) << k;
            EXPECT_NEAR(integral(side, [](const Vec2& x) { return x.x(); }), moment.x(), 2e-6 * area) << k;
            EXPECT_NEAR(integral(side, [](const Vec2& x) { return x.y(); }), moment.y(), 2e-6 * area) << k;
        }
        for (const IntegrationPoint& point : points_) EXPECT_GE(point.weight, 0.0);
    }
}

// Two rows of points cannot carry three moments across them, except where they are Gauss's.
TEST_F(CutSquare, QuadraticsAreExactWhereThePointsAllowIt) {
    cut({0.0, 0.5}, {1.0, 0.5});
    EXPECT_EQ(points_.size(), count_);
    const auto yy = [](const Vec2& x) { return x.y() * x.y(); };
    EXPECT_NEAR(integral(-1, yy), std::pow(0.5, 3) / 3.0, 1e-12);
    EXPECT_NEAR(integral(1, yy), (1.0 - std::pow(0.5, 3)) / 3.0, 1e-12);
    cut({0.0, 0.45}, {1.0, 0.55});
    EXPECT_NEAR(integral(-1, yy), (std::pow(0.55, 4) - std::pow(0.45, 4)) / 1.2, 5e-4);
}

TEST_F(CutSquare, ASliverWithoutPointsGetsSomeOfItsOwn) {
    cut({0.0, 0.02}, {1.0, 0.03});
    EXPECT_EQ(points_.size(), count_ + 4);
    EXPECT_EQ(points_.back().side, -1);
    EXPECT_NEAR(integral(-1, [](const Vec2&) { return 1.0; }), 0.025, 1e-12);
    EXPECT_NEAR(integral(-1, [](const Vec2& x) { return x.y() * x.y(); }), (81e-8 - 16e-8) / 0.12, 1e-15);
    for (const IntegrationPoint& point : points_) EXPECT_GE(point.weight, 0.0);
}

// Whatever corner a side begins at: a crack from its other end leaves the same points and weights, and so do a mirror
// and a quarter turn.
TEST_F(CutSquare, SidesOfAMirrorImageHaveItsPoints) {
    const auto turned = [](const Vec2& x) { return Vec2(1.0 - x.y(), x.x()); };
    const auto mirrored = [](const Vec2& x) { return Vec2(x.x(), 1.0 - x.y()); };
    for (const auto& [from, to] : {std::pair(Vec2(0.0, 0.02), Vec2(1.0, 0.03)),  // a quadrilateral without points
                                   {Vec2(0.0, 0.035), Vec2(0.05, 0.0)},          // a triangle, and a pentagon
                                   {Vec2(0.0, 0.31), Vec2(1.0, 0.44)}}) {
        cut(from, to);
        const std::vector<IntegrationPoint> own = points_;
        const auto expect_own = [&](const auto& image) {
            ASSERT_EQ(points_.size(), own.size());
            for (const IntegrationPoint& point : own) {
                const Vec2 x = image(point.x);
                const auto same = std::ranges::find_if(points_, [&](const IntegrationPoint& other) {
                    return (other.x - x).norm() < 1e-12 && std::abs(other.weight - point.weight) < 1e-12;
                });
                EXPECT_NE(same, points_.end()) << x.transpose() << " with " << point.weight;
            }
        };
        cut(to, from);
        expect_own([](const Vec2& x) { return x; });
        cut(mirrored(from), mirrored(to));
        expect_own(mirrored);
        cut(turned(from), turned(to));
        expect_own(turned);
    }
}

// The functions of the three far corners live there: six unknowns, one of them a rotation about the near corner. One
// point holds three.
TEST_F(CutSquare, ACornerThatIsCutOffResistsItsFarCorners) {
    cut({0.0, 0.35}, {0.02, 0.0});
    std::vector<IntegrationPoint> corner;
    for (const IntegrationPoint& point : points_)
        if (sides_.side_of({0.001, 0.001}) == point.side) corner.push_back(point);
    Eigen::MatrixXd strains = Eigen::MatrixXd::Zero(3 * std::ssize(corner), 6);
    for (Eigen::Index q = 0; q < std::ssize(corner); ++q) {
        const Vec2& x = corner[static_cast<std::size_t>(q)].x;
        const std::array<Vec2, 3> slopes{Vec2(1.0 - x.y(), -x.x()), {x.y(), x.x()}, {-x.y(), 1.0 - x.x()}};
        for (Eigen::Index n = 0; n < 3; ++n) {
            const Vec2& slope = slopes[static_cast<std::size_t>(n)];
            strains.block<3, 2>(3 * q, 2 * n) << slope.x(), 0.0, 0.0, slope.y(), slope.y(), slope.x();
        }
    }
    EXPECT_EQ(Eigen::ColPivHouseholderQR<Eigen::MatrixXd>(strains).rank(), 5);
}

// Rounding folds a side that is no wider than a hair: its area is next to nothing, and its moments over that lie
// anywhere. Outside a distorted element there were no parent coordinates.
TEST_F(CutSquare, AHairThatFoldsHasItsPointWhereItIs) {
    corners_ = {Vec2(0.0, 0.0), {1.0, 0.0}, {1.3, 1.1}, {-0.1, 0.9}};
    points_ = place_points(corners_, nullptr, {}, false, {.subcells = 2});
    const Vec2 from(0.0, 0.4), to(0.9, 0.5), across = Vec2(0.1, -0.9);
    sides_ = {.left = {corners_.begin(), corners_.end()},
              .right = {from, 0.5 * (from + to) + 1e-12 * across, to, 0.3 * from + 0.7 * to + 0.999e-12 * across},
              .segments = {},
              .continuation = {},
              .tips = {}};
    ASSERT_GT(polygon_area(sides_.right), 0.0);
    fit_weights(sides_, corners_, points_);
    const Vec2& x = points_.back().x;
    EXPECT_EQ(points_.back().side, -1);
    EXPECT_LT((x - 0.5 * (from + to)).norm(), 0.5);
}

TEST_F(CutSquare, ARowOfPointsKeepsWhatItCanCarry) {
    cut({0.0, 0.37}, {1.0, 0.37});
    EXPECT_EQ(points_.size(), count_ + 1);
    EXPECT_LT(points_.back().weight, 0.5 * 0.37);
    EXPECT_LT(points_.back().x.y(), 0.37);
}

// Such points stand close about a former tip, where what is stored has no bound.
TEST_F(CutSquare, PointsThatStoodForNextToNothingDoSoFurther) {
    std::vector<IntegrationPoint> about_a_tip(20);
    for (std::size_t k = 0; k < about_a_tip.size(); ++k) {
        const double r = 1e-4 * static_cast<double>(k + 1);
        about_a_tip[k].x = {0.2 + r, 0.6 - r};
        about_a_tip[k].weight = r * r;
    }
    cut({0.0, 0.48}, {1.0, 0.53}, about_a_tip);
    for (std::size_t k = 0; k < about_a_tip.size(); ++k) {
        const IntegrationPoint& point = points_[count_ - about_a_tip.size() + k];
        EXPECT_LT(point.weight, 3.0 * about_a_tip[k].weight);
    }
}

// As those of an element that holds a tip, whose crack turns by 0.2 degrees and cuts it: all points change their
// weights by less than its sides change their areas, also those next to the tip. They hold a large part of what is
// stored.
TEST_F(CutSquare, PointsOfATipKeepTheirWeightsWhereTheCrackHardlyTurns) {
    const Mesh mesh = square_mesh(1);
    const Vec2 mouth(0.0, 0.61), tip(0.789, 0.646);
    const EnrichedMesh before = cracked(mesh, {mouth, tip}, 0);
    corners_ = corners_of_element(before, 0);
    const CutElement held = cut_element(corners_, before.pieces.front());
    points_ = place_points(corners_, &held, std::vector{tip}, true, {.subcells = 2, .tip_points = 4});
    const std::vector<IntegrationPoint> first = points_;
    const Eigen::Rotation2Dd turn(0.0032);
    const EnrichedMesh now = cracked(mesh, {mouth, tip, tip + turn * Vec2(tip - mouth)}, 0);
    sides_ = cut_element(corners_, now.pieces.front());
    fit_weights(sides_, corners_, points_);
    ASSERT_EQ(points_.size(), first.size());
    for (std::size_t q = 0; q < first.size(); ++q)
        EXPECT_NEAR(points_[q].weight, first[q].weight, 0.01 * first[q].weight) << q << ", " << first[q].weight;
}

TEST(SharesOfPoints, MakeALinearFieldAmongThemAndNeverLeaveThem) {
    const std::vector<IntegrationPoint> points = place_points(
        std::array<Vec2, 4>{Vec2(0.0, 0.0), {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}, nullptr, {}, false, {.subcells = 2});
    std::vector<Vec2> places;
    for (const IntegrationPoint& point : points) places.push_back(point.x);
    for (int k = 0; k < 50; ++k) {
        const Vec2 x(0.5 + 0.38 * std::sin(5.0 * k), 0.5 + 0.38 * std::cos(9.0 * k));
        const Eigen::VectorXd shares = shares_at(x, places);
        Vec2 mean = Vec2::Zero();
        for (std::size_t q = 0; q < places.size(); ++q) mean += shares[static_cast<Eigen::Index>(q)] * places[q];
        EXPECT_LT((mean - x).norm(), 1e-4);
        EXPECT_GE(shares.minCoeff(), 0.0);
        EXPECT_NEAR(shares.sum(), 1.0, 1e-14);
    }
    EXPECT_NEAR(shares_at({0.1, 0.0}, places)[0], 1.0, 1e-3);  // of the point nearest to it
}

}  // namespace
}  // namespace stria::test
