#include "common/fem/domain_integral.hpp"

#include <algorithm>

#include "common/fem/shape_q4.hpp"

namespace stria {

Vec2 weight_gradient(const std::array<Vec2, 4>& corners, const std::array<double, 4>& q, const Vec2& xi) {
    const ShapeQ4 shape = shape_q4(corners, xi);
    return shape.gradient.transpose() * Eigen::Map<const Eigen::Vector4d>(q.data());
}

Eigen::VectorXd ring_weight(const std::vector<Vec2>& nodes, const Tip& tip, double inner, double outer) {
    Eigen::VectorXd q(static_cast<Eigen::Index>(nodes.size()));
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        const double r = (nodes[n] - tip.position).norm();
        q[static_cast<Eigen::Index>(n)] = std::clamp((outer - r) / (outer - inner), 0.0, 1.0);
    }
    return q;
}

bool ring_corners(const EnrichedMesh& mesh, int element, const Eigen::VectorXd& q, std::array<double, 4>& corners) {
    for (std::size_t k = 0; k < 4; ++k) corners[k] = q[mesh.elements[static_cast<std::size_t>(element)][k]];
    return std::ranges::any_of(corners, [&](double value) { return value != corners[0]; });
}

}  // namespace stria
