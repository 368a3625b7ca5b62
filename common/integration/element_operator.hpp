// What integrates an element: its points, weights and function gradients, with the mean dilatation of each crack side.
#pragma once

#include <span>
#include <vector>

#include "common/enrichment/element_basis.hpp"
#include "common/integration/element_points.hpp"
#include "common/mandel.hpp"
#include "common/material/elasticity.hpp"

namespace stria {

using Gradients = Eigen::Matrix<double, Eigen::Dynamic, 2>;

/// Several gradients of the same functions, one behind another: elements are many, and seldom in a cache.
class GradientList {
public:
    [[nodiscard]] bool empty() const { return values_.empty(); }
    [[nodiscard]] std::size_t size() const { return functions_ > 0 ? values_.size() / at(2 * functions_) : 0; }
    [[nodiscard]] Eigen::Map<Gradients> operator[](std::size_t k) { return {first(k), functions_, 2}; }
    [[nodiscard]] Eigen::Map<const Gradients> operator[](std::size_t k) const { return {first(k), functions_, 2}; }

    /// All zero.
    void assign(std::size_t count, int functions) {
        functions_ = functions;
        values_.assign(count * at(2 * functions), 0.0);
    }

private:
    [[nodiscard]] double* first(std::size_t k) { return values_.data() + k * at(2 * functions_); }
    [[nodiscard]] const double* first(std::size_t k) const { return values_.data() + k * at(2 * functions_); }

    int functions_ = 0;
    std::vector<double> values_;
};

/// docs/method.md, section 3: grad phi is replaced in the volumetric part of B by its mean over the point's crack side
/// (over the whole element where it holds a tip), for every function; and a constant per side is added to grad phi
/// where the points are not exact (tip functions, cut elements that are no parallelograms) so that its integral equals
/// the boundary integral of phi n, which makes the patch test exact. One constant serves both sides about a tip whose
/// element keeps its points from before: these need not carry the area of a side.
struct ElementOperator {
    using Values = Eigen::VectorXd;  // 2 a function

    int element = 0;
    std::vector<int> unknowns;  // 2 a function
    std::vector<IntegrationPoint> points;
    GradientList gradients;  // per point, one row per function
    GradientList mean;       // per region; empty: without mean dilatation
    double area = 0.0;

    /// Strain of element values `u` (2 a function) at point q; zz is the assumed part of a mean dilatation.
    [[nodiscard]] Mandel strain(const Eigen::VectorXd& u, std::size_t q) const;

    /// 4 x 2f strain matrix of point q.
    [[nodiscard]] Eigen::Matrix<double, 4, Eigen::Dynamic> strain_matrix(std::size_t q) const;

    /// Displacement gradient at point q (row: component).
    [[nodiscard]] Eigen::Matrix2d displacement_gradient(const Eigen::VectorXd& u, std::size_t q) const;

    /// Adds weight * B^T stress at point q.
    void add_force(const Mandel& stress, std::size_t q, Eigen::VectorXd& force) const;

    /// Sum over points of weight * B^T C B with one elastic stiffness.
    [[nodiscard]] Eigen::MatrixXd stiffness(const MandelMatrix& elastic) const;
};

/// Bilinear elements lock where plastic flow keeps the volume in plane strain, or nu is near 1/2.
MeanDilatation mean_dilatation(const MaterialSection& material, const Elasticity& elastic);

/// Elastic elements: exact with the fewest points where functions are polynomials, dense around tips; the error of a
/// stiffness is 1e-7 of it beside a tip, and less than 1e-5 everywhere.
IntegrationRule elastic_rule(const EnrichedMesh& mesh, int element, bool cut);

/// `piece`: the crack inside the element, or null.
ElementOperator make_operator(const EnrichedMesh& mesh, int element, const CrackPiece* piece,
                              const IntegrationRule& rule);

/// On points that the element has already.
ElementOperator make_operator(const EnrichedMesh& mesh, int element, const CrackPiece* piece,
                              const IntegrationRule& rule, std::vector<IntegrationPoint> points);

/// Element values of a displacement vector.
Eigen::VectorXd gather(const Eigen::VectorXd& values, std::span<const int> unknowns);

}  // namespace stria
