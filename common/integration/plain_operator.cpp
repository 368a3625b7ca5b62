#include "common/integration/plain_operator.hpp"

#include <algorithm>
#include <cmath>

#include "common/fem/centre.hpp"
#include "common/fem/quadrature.hpp"
#include "common/fem/shape_q4.hpp"
#include "common/fem/strain_operator.hpp"
#include "common/index.hpp"

namespace stria {
namespace {

using Nodal = Eigen::Matrix<double, 2, 4>;

/// A point of the parent square, and what its place alone says.
struct ParentPoint {
    Vec2 xi;
    double weight;
    Eigen::Vector4d shape;
    PlainOperator::Gradient gradient;
};

std::array<ParentPoint, 4> parent_points() {
    std::array<ParentPoint, 4> points;
    std::ranges::transform(gauss_square(2), points.begin(), [](const SquarePoint& gauss) {
        return ParentPoint{gauss.xi, gauss.weight, shape_values(gauss.xi), parent_gradients(gauss.xi)};
    });
    return points;
}

// Uniform and linear fields leave nothing of gradients - mean: one nodal mode is left, which any column of it shows.
void find_warp(PlainOperator& op) {
    double longest = 0.0;  // squared
    for (const PlainOperator::Gradient& gradient : op.gradients) {
        const PlainOperator::Gradient rest = gradient - op.mean;
        for (const Eigen::Index axis : {0, 1}) {
            const double length = rest.col(axis).squaredNorm();
            if (length > longest) longest = length, op.warp = rest.col(axis);
        }
    }
    op.warp.normalize();
    double largest = 0.0;  // squared
    for (const PlainOperator::Gradient& gradient : op.gradients)
        largest = std::max(largest, ((gradient - op.mean).transpose() * op.warp).squaredNorm());
    op.largest_warp = std::sqrt(largest);
}

}  // namespace

bool is_plain(const EnrichedMesh& mesh, int element) {
    return std::ranges::all_of(mesh.elements[at(element)], [&](int node) {
        return mesh.terms[at(node)].empty() && (mesh.tied.empty() || mesh.tie(node) == nullptr);
    });
}

std::array<int, 8> plain_unknowns(const EnrichedMesh& mesh, int element) {
    std::array<int, 8> unknowns{};
    for (std::size_t k = 0; k < 8; ++k)
        unknowns[k] = mesh.unknown(mesh.elements[at(element)][k / 2], 0, static_cast<int>(k % 2));
    return unknowns;
}

PlainOperator plain_operator(const EnrichedMesh& mesh, int element, bool mean_dilatation) {
    static const std::array<ParentPoint, 4> parent = parent_points();
    const QuadNodes corners = corners_of_element(mesh, element);
    PlainOperator op;
    op.element = element;
    op.unknowns = plain_unknowns(mesh, element);
    op.mean_dilatation = mean_dilatation;
    for (std::size_t q = 0; q < 4; ++q) {
        const auto& [xi, gauss_weight, shape, gradient] = parent[q];
        const Eigen::Matrix2d jacobian = jacobian_matrix(corners, gradient);
        const double weight = gauss_weight * jacobian.determinant();
        const Vec2 x = shape[0] * corners[0] + shape[1] * corners[1] + shape[2] * corners[2] + shape[3] * corners[3];
        op.points[q] = {x, xi, weight, 0, 0};
        op.gradients[q] = gradient * jacobian.inverse();
        op.mean += weight * op.gradients[q];
        op.area += weight;
    }
    op.mean /= op.area;
    find_warp(op);
    return op;
}

Mandel PlainOperator::strain(const Values& u, std::size_t q) const {
    const Nodal nodal = u.reshaped(2, 4);
    return strain_at(nodal, gradients[q], mean_dilatation ? &mean : nullptr);
}

Mandel PlainOperator::mean_strain(const Values& u) const { return strain_of(u.reshaped(2, 4) * mean); }

double PlainOperator::warping(const Values& u) const { return largest_warp * (u.reshaped(2, 4) * warp).norm(); }

Eigen::Matrix2d PlainOperator::displacement_gradient(const Values& u, std::size_t q) const {
    return u.reshaped(2, 4) * gradients[q];
}

void PlainOperator::add_force(const Mandel& stress, std::size_t q, Values& force) const {
    Eigen::Map<Nodal> nodal(force.data());
    add_force_at(stress, points[q].weight, gradients[q], mean_dilatation ? &mean : nullptr, nodal);
}

Eigen::Matrix<double, 8, 8> PlainOperator::stiffness(const MandelMatrix& elastic) const {
    Eigen::Matrix<double, 8, 8> K = Eigen::Matrix<double, 8, 8>::Zero();
    Eigen::Matrix<double, 4, 8> B;
    for (std::size_t q = 0; q < 4; ++q) {
        fill_strain_matrix(gradients[q], mean_dilatation ? &mean : nullptr, B);
        const Eigen::Matrix<double, 4, 8> stress = points[q].weight * elastic * B;
        K.noalias() += B.transpose().lazyProduct(stress);
    }
    return K;
}

PlainOperator::Values gather(const Eigen::VectorXd& values, const std::array<int, 8>& unknowns) {
    PlainOperator::Values local;
    for (std::size_t k = 0; k < 8; ++k) local[static_cast<Eigen::Index>(k)] = values[unknowns[k]];
    return local;
}

}  // namespace stria
