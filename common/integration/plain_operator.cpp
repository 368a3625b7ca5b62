#include "common/integration/plain_operator.hpp"

#include <algorithm>

#include "common/fem/quadrature.hpp"
#include "common/fem/shape_q4.hpp"
#include "common/fem/strain_operator.hpp"
#include "common/index.hpp"

namespace stria {
namespace {

using Nodal = Eigen::Matrix<double, 2, 4>;

// Uniform and linear fields leave nothing of gradients - mean: one nodal mode is left, which any column of it shows.
void find_warp(PlainOperator& op) {
    for (const PlainOperator::Gradient& gradient : op.gradients) {
        const PlainOperator::Gradient rest = gradient - op.mean;
        for (const Eigen::Index axis : {0, 1})
            if (rest.col(axis).norm() > op.warp.norm()) op.warp = rest.col(axis);
    }
    op.warp.normalize();
    for (const PlainOperator::Gradient& gradient : op.gradients)
        op.largest_warp = std::max(op.largest_warp, ((gradient - op.mean).transpose() * op.warp).norm());
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
    static const auto gauss = gauss_square(2);
    QuadNodes corners;
    for (std::size_t k = 0; k < 4; ++k) corners[k] = mesh.nodes[at(mesh.elements[at(element)][k])];
    PlainOperator op;
    op.element = element;
    op.unknowns = plain_unknowns(mesh, element);
    op.mean_dilatation = mean_dilatation;
    for (std::size_t q = 0; q < 4; ++q) {
        const ShapeQ4 shape = shape_q4(corners, gauss[q].xi);
        const double weight = gauss[q].weight * shape.jacobian;
        op.points[q] = {map_to_physical(corners, gauss[q].xi), gauss[q].xi, weight, 0, 0};
        op.gradients[q] = shape.gradient;
        op.mean += weight * shape.gradient;
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
