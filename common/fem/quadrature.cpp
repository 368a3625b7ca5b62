#include "common/fem/quadrature.hpp"

#include <cmath>
#include <numbers>

#include "common/error.hpp"
#include "common/index.hpp"

namespace stria {
namespace {

struct LegendreValue {
    double value;
    double derivative;
};

LegendreValue legendre(int degree, double x) {
    double previous = 1.0, value = x;
    for (int k = 2; k <= degree; ++k) {
        const double next = ((2 * k - 1) * x * value - (k - 1) * previous) / k;
        previous = value;
        value = next;
    }
    return {value, degree * (x * value - previous) / (x * x - 1.0)};
}

std::vector<LinePoint> make_line_rule(int n) {
    constexpr int newton_steps = 10;
    std::vector<LinePoint> rule(at(n));
    for (int i = 0; 2 * i < n; ++i) {
        double x = 2 * i + 1 == n ? 0.0 : std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5));
        for (int step = 0; step < newton_steps; ++step) {
            const LegendreValue p = legendre(n, x);
            x -= p.value / p.derivative;
        }
        const double slope = legendre(n, x).derivative;
        const double weight = 2.0 / ((1.0 - x * x) * slope * slope);
        rule[at(i)] = {-x, weight};  // mirrored: symmetric to the last bit
        rule[at(n - 1 - i)] = {x, weight};
    }
    return rule;
}

std::vector<SquarePoint> make_square_rule(int n) {
    std::vector<SquarePoint> rule;
    rule.reserve(at(n) * at(n));
    for (const LinePoint& eta : gauss_line(n)) {
        for (const LinePoint& xi : gauss_line(n)) rule.push_back({{xi.xi, eta.xi}, xi.weight * eta.weight});
    }
    return rule;
}

/// All rules of one kind, made at first use; the initialisation of a local static is safe between threads.
template <class Rule, Rule (*make)(int)> const Rule& cached(int n) {
    require(1 <= n && n <= max_gauss_points, "Gauss rules have 1 to 32 points");
    static const std::vector<Rule> rules = [] {
        std::vector<Rule> made;
        for (int points = 1; points <= max_gauss_points; ++points) made.push_back(make(points));
        return made;
    }();
    return rules[at(n - 1)];
}

}  // namespace

std::span<const LinePoint> gauss_line(int n) { return cached<std::vector<LinePoint>, make_line_rule>(n); }

std::span<const SquarePoint> gauss_square(int n) { return cached<std::vector<SquarePoint>, make_square_rule>(n); }

std::span<const TrianglePoint> triangle_degree_2() {
    constexpr double far = 2.0 / 3.0, near = 1.0 / 6.0, third = 1.0 / 3.0;
    static const std::array<TrianglePoint, 3> rule{TrianglePoint{{far, near, near}, third},
                                                   TrianglePoint{{near, far, near}, third},
                                                   TrianglePoint{{near, near, far}, third}};
    return rule;
}

std::span<const TrianglePoint> triangle_degree_5() {
    static const std::array<TrianglePoint, 7> rule = [] {
        const double root = std::sqrt(15.0);
        std::array<TrianglePoint, 7> points{};
        points[0] = {Eigen::Vector3d::Constant(1.0 / 3.0), 9.0 / 40.0};
        std::size_t next = 1;
        for (const double sign : {-1.0, 1.0}) {
            const double twin = (6.0 + sign * root) / 21.0;
            const double weight = (155.0 + sign * root) / 1200.0;
            for (int corner = 0; corner < 3; ++corner) {
                Eigen::Vector3d barycentric = Eigen::Vector3d::Constant(twin);
                barycentric[corner] = 1.0 - 2.0 * twin;
                points[next++] = {barycentric, weight};
            }
        }
        return points;
    }();
    return rule;
}

double triangle_area(const Vec2& a, const Vec2& b, const Vec2& c) { return 0.5 * cross(b - a, c - a); }

double polygon_area(std::span<const Vec2> polygon) {
    double area = 0.0;
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k) area += triangle_area(polygon[0], polygon[k], polygon[k + 1]);
    return area;
}

std::vector<PlacedPoint> placed_on_triangle(std::span<const TrianglePoint> rule, const std::array<Vec2, 3>& triangle) {
    const auto& [a, b, c] = triangle;
    const double area = std::abs(triangle_area(a, b, c));
    std::vector<PlacedPoint> points;
    points.reserve(rule.size());
    for (const TrianglePoint& point : rule) {
        const Eigen::Vector3d& l = point.barycentric;
        points.push_back({l[0] * a + l[1] * b + l[2] * c, point.weight * area});
    }
    return points;
}

std::vector<PlacedPoint> collapsed_rule(const std::array<Vec2, 3>& triangle, int radial, int angular) {
    const auto& [a, b, c] = triangle;
    const double twice_area = 2.0 * std::abs(triangle_area(a, b, c));
    std::vector<PlacedPoint> points;
    points.reserve(gauss_line(radial).size() * gauss_line(angular).size());
    for (const LinePoint& ray : gauss_line(angular)) {
        const double t = 0.5 * (1.0 + ray.xi);
        const Vec2 along = (1.0 - t) * (b - a) + t * (c - a);
        for (const LinePoint& shell : gauss_line(radial)) {
            const double v = 0.5 * (1.0 + shell.xi);
            // dA = 2 A u du dt with u = v^2; the quarter turns both weights from [-1, 1] to [0, 1].
            points.push_back({a + v * v * along, 0.25 * ray.weight * shell.weight * twice_area * 2.0 * v * v * v});
        }
    }
    return points;
}

}  // namespace stria
