#include "common/fem/element_operator.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "common/fem/quadrature.hpp"
#include "common/fem/shape_q4.hpp"
#include "common/geometry/clipping.hpp"

namespace stria {
namespace {

using Segment = std::pair<Vec2, Vec2>;

bool same(const Vec2& a, const Vec2& b, double length) { return (a - b).norm() < 1e-10 * length; }

/// Builds the points of one element, then their gradients.
class Builder {
public:
    Builder(const EnrichedMesh& mesh, int element, const CrackPiece* piece, const IntegrationRule& rule)
        : mesh_(mesh), rule_(rule), basis_(mesh, element, piece != nullptr), corners_(basis_.corners()) {
        size_ = (corners_[2] - corners_[0]).norm();
        if (piece != nullptr) cut_ = cut_element(corners_, *piece);
        if (basis_.singular()) {
            for (const Tip& tip : mesh.tips) {
                if (side_of_polygon(corners_, tip.position) >= 0) tips_.push_back(tip.position);
            }
        }
        result_.element = element;
        result_.unknowns = basis_.unknowns();
    }

    ElementOperator build() {
        for (int j = 0; j < rule_.subcells; ++j) {
            for (int i = 0; i < rule_.subcells; ++i) add_subcell(i, j);
        }
        evaluate_gradients();
        if (basis_.singular() || (cut_ && !is_parallelogram())) correct_gradients();
        if (rule_.mean_dilatation) form_means();
        return std::move(result_);
    }

private:
    void add_subcell(int i, int j) {
        const int s = rule_.subcells;
        const std::array<Vec2, 4> quad{grid_corner(corners_, s, i, j), grid_corner(corners_, s, i + 1, j),
                                       grid_corner(corners_, s, i + 1, j + 1), grid_corner(corners_, s, i, j + 1)};
        std::vector<Segment> inside;
        if (cut_) {
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
        else
            for (const auto& triangle : triangulate(with_ends_as_corners(quad, inside), inside)) add_triangle(triangle);
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
                    const bool on_line = std::abs(edge.x() * d.y() - edge.y() * d.x()) < 1e-10 * size_ * edge.norm();
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
            if ((edge.x() * d.y() - edge.y() * d.x()) / edge.norm() < 1e-10 * size_) return;
        }
        const Vec2 from = merged(*first, quad, inside), to = merged(*last, quad, inside);
        inside.emplace_back(from, to);
    }

    [[nodiscard]] int side_at(const Vec2& x) const { return cut_ ? cut_->side_of(x) : 0; }

    void add_point(const Vec2& x, const Vec2& xi, double weight, int side) {
        result_.points.push_back({x, xi, weight, side, 0});
        result_.area += weight;
    }

    void add_quad(int i, int j, const std::array<Vec2, 4>& quad) {
        const int s = rule_.subcells;
        const int side = side_at((quad[0] + quad[1] + quad[2] + quad[3]) / 4.0);
        for (const SquarePoint& gauss : gauss_square(rule_.gauss)) {
            const Vec2 xi = Vec2(-1.0, -1.0) + (Vec2(2.0 * i + 1.0, 2.0 * j + 1.0) + gauss.xi) / s;
            add_point(map_to_physical(corners_, xi), xi, gauss.weight * shape_q4(corners_, xi).jacobian / (s * s),
                      side);
        }
    }

    void add_triangle(const std::array<Vec2, 3>& triangle) {
        const double area = triangle_area(triangle[0], triangle[1], triangle[2]);
        if (area < 1e-16 * size_ * size_) return;
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
        return placed_on_triangle(basis_.singular() ? triangle_degree_5() : triangle_degree_2(), t);
    }

    void evaluate_gradients() {
        BasisValues values;
        result_.gradients.reserve(result_.points.size());
        for (const IntegrationPoint& point : result_.points) {
            basis_.evaluate(point.xi, point.x, point.side, values);
            result_.gradients.push_back(values.gradient);
        }
    }

    // Shape functions of other quadrilaterals are not polynomials on the triangles of a cut.
    [[nodiscard]] bool is_parallelogram() const {
        return same(corners_[0] + corners_[2], corners_[1] + corners_[3], size_);
    }

    void correct_gradients() {
        struct Side {
            int side;
            std::span<const Vec2> polygon;
        };
        std::vector<Side> sides{{0, corners_}};
        if (cut_) sides = {{1, cut_->left}, {-1, cut_->right}};
        for (const Side& side : sides) {
            Gradients missing = boundary_integral(side.polygon, side.side);
            double area = 0.0;
            for (std::size_t q = 0; q < result_.points.size(); ++q) {
                if (result_.points[q].side != side.side) continue;
                missing -= result_.points[q].weight * result_.gradients[q];
                area += result_.points[q].weight;
            }
            for (std::size_t q = 0; q < result_.points.size(); ++q) {
                if (result_.points[q].side == side.side) result_.gradients[q] += missing / area;
            }
        }
    }

    // Integral of phi n over the boundary of one side.
    [[nodiscard]] Gradients boundary_integral(std::span<const Vec2> polygon, int side) const {
        Gradients sum = Gradients::Zero(basis_.functions(), 2);
        for (std::size_t k = 0; k < polygon.size(); ++k) {
            add_edge(polygon[k], polygon[(k + 1) % polygon.size()], side, sum);
        }
        return sum;
    }

    // Adds the integral of phi n over a -> b, where n is the outward normal of a counter-clockwise edge. Halved towards
    // tips until none is nearer than half the length: exact to rounding, so elements agree on an edge however each
    // splits it.
    void add_edge(const Vec2& a, const Vec2& b, int side, Gradients& sum) const {
        const Vec2 d = b - a;
        const bool near_tip = basis_.singular() && std::ranges::any_of(mesh_.tips, [&](const Tip& tip) {
                                  const double t = std::clamp((tip.position - a).dot(d) / d.squaredNorm(), 0.0, 1.0);
                                  return (tip.position - a - t * d).norm() < 0.5 * d.norm();
                              });
        if (near_tip && d.norm() > 1e-10 * size_) {
            const Vec2 middle = a + 0.5 * d;
            add_edge(a, middle, side, sum);
            add_edge(middle, b, side, sum);
            return;
        }
        const Eigen::RowVector2d normal(d.y(), -d.x());
        BasisValues values;
        for (const LinePoint& gauss : gauss_line(16)) {
            const Vec2 x = a + 0.5 * (1.0 + gauss.xi) * d;
            basis_.evaluate(map_to_parent(corners_, x), x, side, values);
            sum += 0.5 * gauss.weight * values.value * normal;
        }
    }

    void form_means() {
        const bool by_side = cut_ && cut_->tips.empty();
        const int regions = by_side ? 2 : 1;
        result_.mean.assign(static_cast<std::size_t>(regions), Gradients::Zero(basis_.functions(), 2));
        std::vector<double> area(static_cast<std::size_t>(regions), 0.0);
        for (std::size_t q = 0; q < result_.points.size(); ++q) {
            IntegrationPoint& point = result_.points[q];
            point.region = by_side && point.side < 0 ? 1 : 0;
            const auto r = static_cast<std::size_t>(point.region);
            result_.mean[r] += point.weight * result_.gradients[q];
            area[r] += point.weight;
        }
        for (std::size_t r = 0; r < area.size(); ++r)
            if (area[r] > 0.0) result_.mean[r] /= area[r];
    }

    const EnrichedMesh& mesh_;
    IntegrationRule rule_;
    ElementBasis basis_;
    std::array<Vec2, 4> corners_;
    double size_ = 0.0;
    std::optional<CutElement> cut_;
    std::vector<Vec2> tips_;  // on or in the element, where it has tip functions
    ElementOperator result_;
};

}  // namespace

ElementOperator make_operator(const EnrichedMesh& mesh, int element, const CrackPiece* piece,
                              const IntegrationRule& rule) {
    return Builder(mesh, element, piece, rule).build();
}

Eigen::Matrix2d ElementOperator::displacement_gradient(const Eigen::VectorXd& u, std::size_t q) const {
    const Gradients& g = gradients[q];
    return Eigen::Map<const Eigen::Matrix<double, 2, Eigen::Dynamic>>(u.data(), 2, g.rows()) * g;
}

Mandel ElementOperator::strain(const Eigen::VectorXd& u, std::size_t q) const {
    const Eigen::Map<const Eigen::Matrix<double, 2, Eigen::Dynamic>> nodal(u.data(), 2, gradients[q].rows());
    const Eigen::Matrix2d local = nodal * gradients[q];
    if (mean.empty()) return strain_of(local);
    const double mean_dilatation =
        nodal.cwiseProduct(mean[static_cast<std::size_t>(points[q].region)].transpose()).sum();
    return strain_of(local) + (mean_dilatation - local.trace()) / 3.0 * mandel_identity;
}

Eigen::Matrix<double, 4, Eigen::Dynamic> ElementOperator::strain_matrix(std::size_t q) const {
    const Gradients& g = gradients[q];
    const Gradients& m = mean.empty() ? g : mean[static_cast<std::size_t>(points[q].region)];
    Eigen::Matrix<double, 4, Eigen::Dynamic> B(4, 2 * g.rows());
    for (Eigen::Index f = 0; f < g.rows(); ++f) {
        const double dx = (m(f, 0) - g(f, 0)) / 3.0, dy = (m(f, 1) - g(f, 1)) / 3.0;
        B.col(2 * f) << g(f, 0) + dx, dx, dx, g(f, 1) / std::numbers::sqrt2;
        B.col(2 * f + 1) << dy, g(f, 1) + dy, dy, g(f, 0) / std::numbers::sqrt2;
    }
    return B;
}

void ElementOperator::add_force(const Mandel& stress, std::size_t q, Eigen::VectorXd& force) const {
    const Gradients& g = gradients[q];
    const double pressure = mean.empty() ? 0.0 : trace(stress) / 3.0;
    const Eigen::Matrix2d weighted = points[q].weight * (in_plane(stress) - pressure * Eigen::Matrix2d::Identity());
    Eigen::Map<Eigen::Matrix<double, 2, Eigen::Dynamic>> nodal(force.data(), 2, g.rows());
    nodal += weighted * g.transpose();
    if (mean.empty()) return;
    nodal += points[q].weight * pressure * mean[static_cast<std::size_t>(points[q].region)].transpose();
}

Eigen::MatrixXd ElementOperator::stiffness(const MandelMatrix& elastic) const {
    const auto n = static_cast<Eigen::Index>(unknowns.size());
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n, n);
    for (std::size_t q = 0; q < points.size(); ++q) {
        const auto B = strain_matrix(q);
        K.noalias() += points[q].weight * B.transpose() * (elastic * B);
    }
    return K;
}

Eigen::VectorXd gather(const Eigen::VectorXd& values, const std::vector<int>& unknowns) {
    Eigen::VectorXd local(static_cast<Eigen::Index>(unknowns.size()));
    for (std::size_t k = 0; k < unknowns.size(); ++k) local[static_cast<Eigen::Index>(k)] = values[unknowns[k]];
    return local;
}

}  // namespace stria
