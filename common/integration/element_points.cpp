#include "common/integration/element_points.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "common/fem/centre.hpp"
#include "common/fem/quadrature.hpp"
#include "common/fem/shape_q4.hpp"
#include "common/geometry/clipping.hpp"

namespace stria {
namespace {

using Segment = std::pair<Vec2, Vec2>;
using Quad = std::array<Vec2, 4>;

/// Of a triangle, of the element's diagonal squared: less is what rounding leaves between two lines. It weighs nothing,
/// and what flows there and nowhere else would make a plastic zone.
constexpr double least_area = 1e-13;

bool same(const Vec2& a, const Vec2& b, double length) { return (a - b).norm() < 1e-10 * length; }

class Placer {
public:
    Placer(const std::array<Vec2, 4>& corners, const CutElement* cut, std::span<const Vec2> tips, bool singular,
           const IntegrationRule& rule)
        : corners_(corners), size_(diagonal(corners)), cut_(cut), tips_(tips), singular_(singular), rule_(rule) {}

    std::vector<IntegrationPoint> place() {
        for (int j = 0; j < rule_.subcells; ++j) {
            for (int i = 0; i < rule_.subcells; ++i) add_subcell(i, j);
        }
        return std::move(points_);
    }

private:
    void add_subcell(int i, int j) {
        const int s = rule_.subcells;
        const std::array<Vec2, 4> quad{grid_corner(corners_, s, i, j), grid_corner(corners_, s, i + 1, j),
                                       grid_corner(corners_, s, i + 1, j + 1), grid_corner(corners_, s, i, j + 1)};
        std::vector<Segment> inside;
        if (cut_ != nullptr) {
            for (const auto* segments : {&cut_->segments, &cut_->continuation}) {
                for (const Segment& segment : *segments) append_part_inside(quad, segment, inside);
            }
        }
        for (const Vec2& tip : tips_) {
            if (side_of_polygon(quad, tip) < 0) continue;
            for (const Vec2& corner : quad)
                if (!same(tip, corner, size_)) inside.emplace_back(tip, corner);
        }
        if (inside.empty())
            add_quad(i, j, quad);
        else if (const std::optional<std::array<Quad, 2>> halves = halves_of(quad, inside))
            for (const Quad& half : *halves) add_rectangle(half);
        else
            for (const auto& triangle : triangulate(with_ends_as_corners(quad, inside), inside)) add_triangle(triangle);
    }

    // A rectangle that is cut along an edge, in two. Either diagonal of such a half would do, so rounding would choose
    // one, and a body and its mirror image would differ by what triangles are off by.
    [[nodiscard]] std::optional<std::array<Quad, 2>> halves_of(const Quad& quad,
                                                               const std::vector<Segment>& inside) const {
        if (inside.size() != 1) return {};
        for (const std::size_t first : {0U, 1U}) {
            const Vec2 &a = quad[first], &b = quad[first + 1], &c = quad[first + 2], &d = quad[(first + 3) % 4];
            const Vec2 along = b - a, up = d - a;
            auto [below, above] = inside.front();
            if ((above - below).dot(up) < 0.0) std::swap(below, above);
            const double place = (below - a).dot(along) / along.squaredNorm();
            const bool rectangle = std::abs(along.dot(up)) < 1e-10 * size_ * size_ && same(c, b + up, size_);
            if (rectangle && same(below, a + place * along, size_) && same(above, d + place * along, size_))
                return {{Quad{a, below, above, d}, Quad{below, b, c, above}}};
        }
        return {};
    }

    // Ends that lie on an edge to within rounding become corners: the triangulation has nothing to intersect, so it
    // cannot lose the rest of a segment whose end fell outside by one rounding.
    [[nodiscard]] std::vector<Vec2> with_ends_as_corners(const std::array<Vec2, 4>& quad,
                                                         const std::vector<Segment>& inside) const {
        std::vector<Vec2> polygon;
        for (std::size_t k = 0; k < 4; ++k) {
            const Vec2 &a = quad[k], edge = quad[(k + 1) % 4] - a;
            std::vector<std::pair<double, Vec2>> on_edge{{0.0, a}};
            for (const Segment& segment : inside) {
                for (const Vec2& end : {segment.first, segment.second}) {
                    const Vec2 d = end - a;
                    const double t = d.dot(edge) / edge.squaredNorm();
                    const bool on_line = std::abs(cross(edge, d)) < 1e-10 * size_ * edge.norm();
                    if (on_line && t > 0.0 && t < 1.0 && end != a && end != quad[(k + 1) % 4])
                        on_edge.emplace_back(t, end);
                }
            }
            std::ranges::sort(on_edge, {}, &std::pair<double, Vec2>::first);
            for (const auto& [t, x] : on_edge)
                if (polygon.empty() || polygon.back() != x) polygon.push_back(x);
        }
        return polygon;
    }

    // Points that rounding alone keeps apart become one.
    [[nodiscard]] Vec2 merged(const Vec2& x, const std::array<Vec2, 4>& quad,
                              const std::vector<Segment>& inside) const {
        for (const Vec2& corner : quad)
            if (same(x, corner, size_)) return corner;
        for (const Vec2& tip : tips_)
            if (same(x, tip, size_)) return tip;
        for (const Segment& segment : inside) {
            if (same(x, segment.first, size_)) return segment.first;
            if (same(x, segment.second, size_)) return segment.second;
        }
        return x;
    }

    // The part of a segment inside the open sub-quadrangle: one that only touches its edges does not cut it.
    void append_part_inside(const std::array<Vec2, 4>& quad, const Segment& segment,
                            std::vector<Segment>& inside) const {
        std::vector<Vec2> ends;
        for (const Vec2& end : {segment.first, segment.second})
            if (side_of_polygon(quad, end) >= 0) ends.push_back(end);
        for (std::size_t k = 0; k < 4; ++k) {
            const auto hit = intersect(segment.first, segment.second, quad[k], quad[(k + 1) % 4]);
            if (!hit) continue;
            ends.push_back(hit->first);
            ends.push_back(hit->second);
        }
        if (ends.size() < 2) return;
        const Vec2 direction = segment.second - segment.first;
        const auto along = [&](const Vec2& x) { return direction.dot(x); };
        const auto [first, last] = std::ranges::minmax_element(ends, {}, along);
        if (same(*first, *last, size_)) return;
        // Strictly inside, by more than rounding: a line along an edge of the sub-quadrangle stays outside.
        const Vec2 middle = (*first + *last) / 2.0;
        for (std::size_t k = 0; k < 4; ++k) {
            const Vec2 edge = quad[(k + 1) % 4] - quad[k], d = middle - quad[k];
            if (cross(edge, d) / edge.norm() < 1e-10 * size_) return;
        }
        const Vec2 from = merged(*first, quad, inside), to = merged(*last, quad, inside);
        inside.emplace_back(from, to);
    }

    [[nodiscard]] int side_at(const Vec2& x) const { return cut_ != nullptr ? cut_->side_of(x) : 0; }

    void add_point(const Vec2& x, const Vec2& xi, double weight, int side) {
        points_.push_back({x, xi, weight, side, 0});
    }

    void add_quad(int i, int j, const std::array<Vec2, 4>& quad) {
        const int s = rule_.subcells;
        const int side = side_at(centre(quad));
        for (const SquarePoint& gauss : gauss_square(singular_ ? rule_.singular_gauss : 2)) {
            const Vec2 xi = Vec2(-1.0, -1.0) + (Vec2(2.0 * i + 1.0, 2.0 * j + 1.0) + gauss.xi) / s;
            add_point(map_to_physical(corners_, xi), xi, gauss.weight * shape_q4(corners_, xi).jacobian / (s * s),
                      side);
        }
    }

    // Exact to the degree of triangles at least, with fewer points than two of them have.
    void add_rectangle(const Quad& rectangle) {
        if (polygon_area(rectangle) < least_area * size_ * size_) return;
        const int side = side_at(centre(rectangle));
        for (const SquarePoint& gauss : gauss_square(singular_ ? 3 : 2)) {
            const Vec2 x = map_to_physical(rectangle, gauss.xi);
            add_point(x, map_to_parent(corners_, x), gauss.weight * shape_q4(rectangle, gauss.xi).jacobian, side);
        }
    }

    void add_triangle(const std::array<Vec2, 3>& triangle) {
        const double area = triangle_area(triangle[0], triangle[1], triangle[2]);
        if (area < least_area * size_ * size_) return;
        const int side = side_at((triangle[0] + triangle[1] + triangle[2]) / 3.0);
        for (const auto& [x, weight] : triangle_points(triangle))
            add_point(x, map_to_parent(corners_, x), weight, side);
    }

    [[nodiscard]] std::vector<PlacedPoint> triangle_points(const std::array<Vec2, 3>& t) const {
        for (std::size_t k = 0; k < 3; ++k) {
            for (const Vec2& tip : tips_) {
                if (same(tip, t[k], size_))
                    return collapsed_rule({t[k], t[(k + 1) % 3], t[(k + 2) % 3]}, rule_.tip_points, rule_.tip_points);
            }
        }
        return placed_on_triangle(singular_ ? triangle_degree_5() : triangle_degree_2(), t);
    }

    const std::array<Vec2, 4>& corners_;
    double size_;
    const CutElement* cut_;
    std::span<const Vec2> tips_;
    bool singular_;
    const IntegrationRule& rule_;
    std::vector<IntegrationPoint> points_;
};

}  // namespace

std::vector<IntegrationPoint> place_points(const std::array<Vec2, 4>& corners, const CutElement* cut,
                                           std::span<const Vec2> tips, bool singular, const IntegrationRule& rule) {
    return Placer(corners, cut, tips, singular, rule).place();
}

}  // namespace stria
