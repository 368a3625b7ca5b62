#include "common/integration/moment_fit.hpp"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "common/fem/centre.hpp"
#include "common/fem/quadrature.hpp"
#include "common/fem/shape_q4.hpp"
#include "common/geometry/clipping.hpp"
#include "common/index.hpp"

namespace stria {
namespace {

constexpr double exact = 1e-6;  // of the side's area (docs/method.md, section 3)

using Monomials = Eigen::Matrix<double, 6, 1>;

/// Monomials up to degree 2 about a centre, over a length; together as large in any direction of the axes.
struct Frame {
    Vec2 centre;
    double length;

    [[nodiscard]] Monomials at(const Vec2& x) const {
        const Vec2 d = (x - centre) / length;
        return {1.0, d.x(), d.y(), d.x() * d.x(), std::numbers::sqrt2 * d.x() * d.y(), d.y() * d.y()};
    }
};

// A fan of signed triangles: exact for polygons of any shape.
Monomials moments(std::span<const Vec2> polygon, const Frame& frame) {
    Monomials sum = Monomials::Zero();
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
        const Vec2 &a = polygon[0], &b = polygon[k], &c = polygon[k + 1];
        const double area = triangle_area(a, b, c);
        for (const Vec2& x : {Vec2((a + b) / 2.0), Vec2((b + c) / 2.0), Vec2((c + a) / 2.0)})
            sum += area / 3.0 * frame.at(x);
    }
    return sum;
}

/// False where no weights >= 0 are exact to the degree. Of those that are, about the ones nearest to the present, each
/// change beside the root of the weight: all points go on telling of their place, and one that stood for next to
/// nothing, about a former tip where stresses are without bound, does so further. The search begins at the present
/// weights: what lets go of such a point is less than what ends a search that begins without any.
bool fit_side(std::vector<IntegrationPoint*>& points, const Monomials& wanted, const Frame& frame, int count) {
    constexpr double keep = 1e-4;
    const Eigen::Index n = std::ssize(points);
    if (n == 0) return false;
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(count + n, n);
    Eigen::VectorXd b(count + n), root(n);
    b.head(count) = wanted.head(count);
    for (Eigen::Index q = 0; q < n; ++q) root[q] = std::sqrt(points[at(q)]->weight);
    root /= std::sqrt(root.squaredNorm() / static_cast<double>(n));
    if (!root.allFinite()) return false;
    for (Eigen::Index q = 0; q < n; ++q) {
        A.col(q).head(count) = root[q] * frame.at(points[at(q)]->x).head(count);
        A(count + q, q) = keep;
        if (root[q] > 0.0) b[count + q] = keep * points[at(q)]->weight / root[q];
    }
    b.tail(n) = (root.array() > 0.0).select(b.tail(n), 0.0);
    const Eigen::VectorXd w = non_negative_least_squares(A, b, b.tail(n) / keep);
    if ((A * w - b).head(count).norm() > exact * wanted[0]) return false;
    for (Eigen::Index q = 0; q < n; ++q) points[at(q)]->weight = root[q] * w[q];
    return true;
}

Vec2 mean_of(std::span<const Vec2> polygon) {
    return std::accumulate(polygon.begin(), polygon.end(), Vec2(Vec2::Zero())) / static_cast<double>(polygon.size());
}

/// Within its box.
bool lies_about(std::span<const Vec2> polygon, const Vec2& x) {
    Eigen::AlignedBox2d box;
    for (const Vec2& corner : polygon) box.extend(corner);
    return box.contains(x);
}

/// The points keep as large a part of their weights as lets one more inside the side make up for what they miss, in
/// area and first moments. Without points it stands at the centroid; or in the middle of the corners, where rounding
/// has put the centroid of a hair beyond them.
IntegrationPoint add_missing(std::vector<IntegrationPoint*>& points, std::span<const Vec2> polygon,
                             const Monomials& wanted, const Monomials& present, const Frame& frame) {
    constexpr int parts = 10;
    IntegrationPoint added{};
    for (int kept = points.empty() ? 0 : parts; kept >= 0; --kept) {
        const double part = double(kept) / parts;
        const Monomials missing = wanted - part * present;
        if (kept > 0 && missing[0] <= 0.01 * wanted[0]) continue;
        added.x = frame.centre + frame.length * missing.segment<2>(1) / missing[0];
        added.weight = missing[0];
        if (kept > 0 && side_of_polygon(polygon, added.x) <= 0) continue;
        if (!lies_about(polygon, added.x)) added.x = mean_of(polygon);
        for (IntegrationPoint* point : points) point->weight *= part;
        break;
    }
    return added;
}

/// Gauss's four of a quadrilateral; none where that is not convex.
std::vector<PlacedPoint> in_quadrilateral(const std::array<Vec2, 4>& corners) {
    std::vector<PlacedPoint> points;
    for (const SquarePoint& gauss : gauss_square(2)) {
        const double weight = gauss.weight * shape_q4(corners, gauss.xi).jacobian;
        if (weight <= 0.0) return {};
        points.push_back({map_to_physical(corners, gauss.xi), weight});
    }
    return points;
}

/// Three in each triangle about the middle of a polygon's corners; none where these are no fan.
std::vector<PlacedPoint> in_fan(std::span<const Vec2> polygon) {
    std::vector<PlacedPoint> points;
    const Vec2 middle = mean_of(polygon);
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const std::array<Vec2, 3> corners{middle, polygon[k], polygon[(k + 1) % polygon.size()]};
        const double area = triangle_area(corners[0], corners[1], corners[2]);
        if (area < 0.0) return {};
        if (area == 0.0) continue;
        for (const PlacedPoint& point : placed_on_triangle(triangle_degree_2(), corners)) points.push_back(point);
    }
    return points;
}

/// Inside a polygon, exact to degree 2; none where it has no such. From the other end of its crack, or in a mirror, a
/// side has the same ones.
std::vector<IntegrationPoint> points_inside(std::span<const Vec2> polygon, const std::array<Vec2, 4>& element,
                                            int side) {
    std::vector<PlacedPoint> places;
    if (polygon.size() == 3)
        places = placed_on_triangle(triangle_degree_2(), {polygon[0], polygon[1], polygon[2]});
    else if (polygon.size() == 4)
        places = in_quadrilateral({polygon[0], polygon[1], polygon[2], polygon[3]});
    if (places.empty()) places = in_fan(polygon);
    std::vector<IntegrationPoint> points;
    for (const auto& [x, weight] : places) points.push_back({x, map_to_parent(element, x), weight, side, 0});
    return points;
}

}  // namespace

Eigen::VectorXd non_negative_least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b, Eigen::VectorXd x) {
    const Eigen::Index n = A.cols();
    const double tiny = 1e-12 * (A.transpose() * b).cwiseAbs().maxCoeff();
    std::vector<int> passive;  // the columns that may be positive
    for (int j = 0; j < n; ++j)
        if (x[j] > 0.0) passive.push_back(j);
    const auto solve = [&] {
        if (passive.empty()) return Eigen::VectorXd();
        return Eigen::VectorXd(A(Eigen::all, passive).completeOrthogonalDecomposition().solve(b));
    };
    const auto settle = [&] {
        Eigen::VectorXd z = solve();
        while (z.size() > 0 && z.minCoeff() <= 0.0) {
            double stop = 1.0;
            for (Eigen::Index k = 0; k < z.size(); ++k) {
                const double here = x[passive[at(k)]];
                if (z[k] <= 0.0) stop = std::min(stop, here / (here - z[k]));
            }
            std::vector<int> kept;
            for (Eigen::Index k = 0; k < z.size(); ++k) {
                double& here = x[passive[at(k)]];
                here += stop * (z[k] - here);
                if (here > tiny)
                    kept.push_back(passive[at(k)]);
                else
                    here = 0.0;
            }
            if (kept.size() == passive.size()) break;
            passive = std::move(kept);
            z = solve();
        }
        for (Eigen::Index k = 0; k < z.size(); ++k) x[passive[at(k)]] = z[k];
    };
    settle();
    for (int step = 0; step < 3 * n; ++step) {
        Eigen::VectorXd slope = A.transpose() * (b - A * x);
        for (const int j : passive) slope[j] = 0.0;
        Eigen::Index steepest = 0;
        if (n == 0 || slope.maxCoeff(&steepest) <= tiny) break;
        passive.push_back(static_cast<int>(steepest));
        settle();
    }
    return x.cwiseMax(0.0);
}

void fit_weights(const CutElement& cut, const std::array<Vec2, 4>& corners, std::vector<IntegrationPoint>& points) {
    for (IntegrationPoint& point : points) point.side = cut.side_of(point.x);
    const double length = diagonal(corners);
    for (const int side : {1, -1}) {
        const std::vector<Vec2>& polygon = side > 0 ? cut.left : cut.right;
        const Frame frame{mean_of(polygon), length};
        const Monomials wanted = moments(polygon, frame);
        if (wanted[0] <= 0.0) continue;
        std::vector<IntegrationPoint*> own;
        Monomials present = Monomials::Zero();
        for (IntegrationPoint& point : points) {
            if (point.side != side) continue;
            own.push_back(&point);
            present += point.weight * frame.at(point.x);
        }
        if ((present - wanted).norm() <= exact * wanted[0]) continue;
        if (fit_side(own, wanted, frame, 6) || fit_side(own, wanted, frame, 3)) continue;
        // One alone cannot resist all that the functions of a small side's three far corners may do.
        std::vector<IntegrationPoint> added;
        if (own.empty()) added = points_inside(polygon, corners, side);
        if (added.empty()) {
            added.push_back(add_missing(own, polygon, wanted, present, frame));
            added[0].xi = map_to_parent(corners, added[0].x);
            added[0].side = side;
        }
        points.insert(points.end(), added.begin(), added.end());
    }
}

std::vector<PointShare> history_of(std::span<const IntegrationPoint> now, std::size_t q,
                                   std::span<const IntegrationPoint> before) {
    if (q < before.size()) return {{q, 1.0}};
    const auto beside = [&](const IntegrationPoint& from) { return from.side != -now[q].side; };
    const bool all = std::ranges::none_of(before, beside);
    std::vector<PointShare> history;
    std::vector<Vec2> places;
    for (std::size_t from = 0; from < before.size(); ++from) {
        if (!all && !beside(before[from])) continue;
        history.push_back({from, 0.0});
        places.push_back(before[from].x);
    }
    const Eigen::VectorXd shares = shares_at(now[q].x, places);
    for (std::size_t k = 0; k < places.size(); ++k) history[k].share = shares[static_cast<Eigen::Index>(k)];
    std::erase_if(history, [](const PointShare& source) { return source.share == 0.0; });
    return history;
}

Eigen::VectorXd shares_at(const Vec2& x, std::span<const Vec2> points) {
    constexpr double near = 1e-3;
    const Eigen::Index n = std::ssize(points);
    double length = 0.0;
    for (const Vec2& point : points) length = std::max(length, (point - x).norm());
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(3 + n, n);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(3 + n);
    b[0] = 1.0;
    for (Eigen::Index q = 0; q < n; ++q) {
        const Vec2 d = (points[at(q)] - x) / length;
        A.col(q).head(3) << 1.0, d.x(), d.y();
        A(3 + q, q) = near * d.norm();
    }
    const Eigen::VectorXd shares = non_negative_least_squares(A, b, Eigen::VectorXd::Zero(n));
    return shares / shares.sum();
}

}  // namespace stria
