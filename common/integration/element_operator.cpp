#include "common/integration/element_operator.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "common/fem/centre.hpp"
#include "common/fem/quadrature.hpp"
#include "common/fem/shape_q4.hpp"
#include "common/fem/strain_operator.hpp"
#include "common/geometry/clipping.hpp"
#include "common/index.hpp"

namespace stria {
namespace {

/// Builds the points of one element, then their gradients.
class Builder {
public:
    Builder(const EnrichedMesh& mesh, int element, const CrackPiece* piece, const IntegrationRule& rule)
        : mesh_(mesh), rule_(rule), basis_(mesh, element, piece != nullptr), corners_(basis_.corners()) {
        size_ = diagonal(corners_);
        if (piece != nullptr) cut_ = cut_element(corners_, *piece);
        if (basis_.singular()) {
            singular_points_ = mesh.tips;
            singular_points_.insert(singular_points_.end(), mesh.left_tips.begin(), mesh.left_tips.end());
            for (const Tip& tip : mesh.tips) {
                if (side_of_polygon(corners_, tip.position) >= 0) tips_.push_back(tip.position);
            }
        }
        result_.element = element;
        result_.unknowns = basis_.unknowns();
    }

    ElementOperator build() {
        return build(place_points(corners_, cut_ ? &*cut_ : nullptr, tips_, basis_.singular(), rule_));
    }

    ElementOperator build(std::vector<IntegrationPoint> points) {
        result_.points = std::move(points);
        for (const IntegrationPoint& point : result_.points) result_.area += point.weight;
        evaluate_gradients();
        if (basis_.singular() || (cut_ && !is_parallelogram())) correct_gradients();
        if (rule_.mean_dilatation == MeanDilatation::Everywhere ||
            (rule_.mean_dilatation == MeanDilatation::WithoutTipFunctions && !basis_.singular()))
            form_means();
        return std::move(result_);
    }

private:
    void evaluate_gradients() {
        BasisValues values;
        result_.gradients.assign(result_.points.size(), basis_.functions());
        for (std::size_t q = 0; q < result_.points.size(); ++q) {
            const IntegrationPoint& point = result_.points[q];
            basis_.evaluate(point.xi, point.x, point.side, values);
            result_.gradients[q] = values.gradient;
        }
    }

    // Shape functions of other quadrilaterals are not polynomials on the triangles of a cut.
    [[nodiscard]] bool is_parallelogram() const {
        return (corners_[0] + corners_[2] - corners_[1] - corners_[3]).norm() < 1e-10 * size_;
    }

    struct Side {
        int side;
        std::span<const Vec2> polygon;
    };

    // While a tip moves on in an element its points stay, and need not carry the areas of the sides. What is missing
    // of a side that a few of them stand for would be large there: then one constant serves both sides.
    void correct_gradients() {
        if (!cut_) return correct_gradients({{0, corners_}});
        const Side left{1, cut_->left}, right{-1, cut_->right};
        if (!cut_->tips.empty() && !(carry_area(left) && carry_area(right))) return correct_gradients({left, right});
        correct_gradients({left});
        correct_gradients({right});
    }

    [[nodiscard]] bool carry_area(const Side& side) const {
        constexpr double rounding = 1e-6;  // of the element
        double area = 0.0;
        for (const IntegrationPoint& point : result_.points)
            if (point.side == side.side) area += point.weight;
        return std::abs(area - polygon_area(side.polygon)) <= rounding * result_.area;
    }

    void correct_gradients(const std::vector<Side>& sides) {
        Gradients missing = Gradients::Zero(basis_.functions(), 2);
        std::vector<std::size_t> points;
        double area = 0.0;
        for (const auto& [side, polygon] : sides) {
            missing += boundary_integral(polygon, side);
            for (std::size_t q = 0; q < result_.points.size(); ++q) {
                if (result_.points[q].side != side) continue;
                missing -= result_.points[q].weight * result_.gradients[q];
                area += result_.points[q].weight;
                points.push_back(q);
            }
        }
        for (const std::size_t q : points) result_.gradients[q] += missing / area;
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
    // splits it. Far from tips fewer points do: both elements of the edge take the same.
    void add_edge(const Vec2& a, const Vec2& b, int side, Gradients& sum) const {
        const Vec2 d = b - a;
        const double distance = basis_.singular() ? distance_to_tip(a, d) : 1e300;  // in lengths of the edge
        // Below some units in the last place of a coordinate an edge has no middle.
        const double shortest = std::max(1e-10 * size_, 1e-15 * a.lpNorm<Eigen::Infinity>());
        if (distance < 0.5 && d.norm() > shortest) {
            const Vec2 middle = a + 0.5 * d;
            add_edge(a, middle, side, sum);
            add_edge(middle, b, side, sum);
            return;
        }
        const Eigen::RowVector2d normal(d.y(), -d.x());
        BasisValues values;
        for (const LinePoint& gauss : gauss_line(distance < 4.0 ? 16 : 6)) {
            const Vec2 x = a + 0.5 * (1.0 + gauss.xi) * d;
            basis_.evaluate(map_to_parent(corners_, x), x, side, values);
            sum += 0.5 * gauss.weight * values.value * normal;
        }
    }

    [[nodiscard]] double distance_to_tip(const Vec2& a, const Vec2& d) const {
        double nearest = 1e300;
        for (const Tip& tip : singular_points_) {
            const double t = std::clamp((tip.position - a).dot(d) / d.squaredNorm(), 0.0, 1.0);
            nearest = std::min(nearest, (tip.position - a - t * d).norm());
        }
        return nearest / d.norm();
    }

    void form_means() {
        const bool by_side = cut_ && cut_->tips.empty();
        const int regions = by_side ? 2 : 1;
        result_.mean.assign(at(regions), basis_.functions());
        std::vector<double> area(at(regions), 0.0);
        for (std::size_t q = 0; q < result_.points.size(); ++q) {
            IntegrationPoint& point = result_.points[q];
            point.region = by_side && point.side < 0 ? 1 : 0;
            const auto r = at(point.region);
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
    std::vector<Tip> singular_points_;
    std::vector<Vec2> tips_;  // on or in the element, where it has tip functions
    ElementOperator result_;
};

}  // namespace

MeanDilatation mean_dilatation(const MaterialSection& material, const Elasticity& elastic) {
    if (elastic.plane == PlaneState::Stress) return MeanDilatation::Nowhere;
    const bool may_lock = material.yield_stress || elastic.poisson > 0.45;
    return may_lock ? MeanDilatation::Everywhere : MeanDilatation::WithoutTipFunctions;
}

IntegrationRule elastic_rule(const EnrichedMesh& mesh, int element, bool cut) {
    const ElementBasis basis(mesh, element, cut);
    if (!basis.singular()) return {};
    const auto& c = basis.corners();
    double distance = 1e300;  // to the nearest tip, in diagonals
    for (const Tip& tip : mesh.tips) distance = std::min(distance, (tip.position - centre(c)).norm() / diagonal(c));
    if (distance > 3.0) return {.singular_gauss = 3};
    if (!cut && distance > 1.0) return {.singular_gauss = distance > 1.75 ? 4 : 5};
    return {.subcells = 2, .singular_gauss = 6, .tip_points = 10};
}

ElementOperator make_operator(const EnrichedMesh& mesh, int element, const CrackPiece* piece,
                              const IntegrationRule& rule) {
    return Builder(mesh, element, piece, rule).build();
}

ElementOperator make_operator(const EnrichedMesh& mesh, int element, const CrackPiece* piece,
                              const IntegrationRule& rule, std::vector<IntegrationPoint> points) {
    return Builder(mesh, element, piece, rule).build(std::move(points));
}

Eigen::Matrix2d ElementOperator::displacement_gradient(const Eigen::VectorXd& u, std::size_t q) const {
    const auto g = gradients[q];
    return Eigen::Map<const Eigen::Matrix<double, 2, Eigen::Dynamic>>(u.data(), 2, g.rows()) * g;
}

namespace {

/// Calls visit(gradients, their mean or null) of point q.
template <class Visit> decltype(auto) with_mean(const ElementOperator& op, std::size_t q, Visit&& visit) {
    const auto g = op.gradients[q];
    if (op.mean.empty()) return visit(g, static_cast<decltype(&g)>(nullptr));
    const auto mean = op.mean[at(op.points[q].region)];
    return visit(g, &mean);
}

}  // namespace

Mandel ElementOperator::strain(const Eigen::VectorXd& u, std::size_t q) const {
    return with_mean(*this, q, [&](const auto& g, const auto* m) {
        const Eigen::Map<const Eigen::Matrix<double, 2, Eigen::Dynamic>> nodal(u.data(), 2, g.rows());
        return strain_at(nodal, g, m);
    });
}

Eigen::Matrix<double, 4, Eigen::Dynamic> ElementOperator::strain_matrix(std::size_t q) const {
    Eigen::Matrix<double, 4, Eigen::Dynamic> B(4, 2 * gradients[q].rows());
    with_mean(*this, q, [&](const auto& g, const auto* m) { fill_strain_matrix(g, m, B); });
    return B;
}

void ElementOperator::add_force(const Mandel& stress, std::size_t q, Eigen::VectorXd& force) const {
    Eigen::Map<Eigen::Matrix<double, 2, Eigen::Dynamic>> nodal(force.data(), 2, gradients[q].rows());
    with_mean(*this, q, [&](const auto& g, const auto* m) { add_force_at(stress, points[q].weight, g, m, nodal); });
}

// One product for all points: of an element with tip functions they are hundreds.
Eigen::MatrixXd ElementOperator::stiffness(const MandelMatrix& elastic) const {
    const Eigen::Index n = std::ssize(unknowns), rows = 4 * std::ssize(points);
    Eigen::MatrixXd strains(rows, n), stresses(rows, n);
    for (std::size_t q = 0; q < points.size(); ++q) {
        const Eigen::Index row = 4 * static_cast<Eigen::Index>(q);
        strains.middleRows<4>(row) = strain_matrix(q);
        stresses.middleRows<4>(row).noalias() = (points[q].weight * elastic) * strains.middleRows<4>(row);
    }
    Eigen::MatrixXd K(n, n);
    K.triangularView<Eigen::Lower>() = strains.transpose() * stresses;
    return K.selfadjointView<Eigen::Lower>();
}

Eigen::VectorXd gather(const Eigen::VectorXd& values, std::span<const int> unknowns) {
    Eigen::VectorXd local(static_cast<Eigen::Index>(unknowns.size()));
    for (std::size_t k = 0; k < unknowns.size(); ++k) local[static_cast<Eigen::Index>(k)] = values[unknowns[k]];
    return local;
}

}  // namespace stria
