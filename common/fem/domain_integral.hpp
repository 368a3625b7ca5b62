// J and the interaction integral in domain form: kernels at a point, for a ring where the weight q falls from 1 to 0.
#pragma once

#include "common/fem/element_operator.hpp"
#include "common/fem/williams.hpp"

namespace stria {

/// What one side of a ring adds up, N/mm. K_I = E'/2 * interaction_I, K_II likewise (Williams fields of unit K).
struct DomainIntegral {
    double J = 0.0, interaction_I = 0.0, interaction_II = 0.0;

    DomainIntegral& operator+=(const DomainIntegral& other) {
        J += other.J;
        interaction_I += other.interaction_I;
        interaction_II += other.interaction_II;
        return *this;
    }
};

/// (sigma_ij u_i,1 - W delta_1j) q_,j with axis 1 along the tip: the integrand of J (faces in the ring's inside add
/// theirs).
inline double j_density(const Tip& tip, const Mandel& stress, const Eigen::Matrix2d& gradient, double work,
                        const Vec2& dq) {
    return (in_plane(stress) * dq).dot(gradient * tip.direction) - work * tip.direction.dot(dq);
}

/// The interaction integrand with an auxiliary Williams field.
inline double interaction_density(const Tip& tip, const Mandel& stress, const Eigen::Matrix2d& gradient,
                                  const WilliamsField& auxiliary, const Vec2& dq) {
    const double mutual = in_plane(stress).cwiseProduct(auxiliary.gradient).sum();
    return (in_plane(stress) * dq).dot(auxiliary.gradient * tip.direction) +
           (in_plane(auxiliary.stress) * dq).dot(gradient * tip.direction) - mutual * tip.direction.dot(dq);
}

/// Gradient of q, interpolated by the standard functions from its values at the element's corners.
Vec2 weight_gradient(const std::array<Vec2, 4>& corners, const std::array<double, 4>& q, const Vec2& xi);

/// q at the mesh's nodes: 1 within `inner` of the tip, falling linearly to 0 at `outer`.
Eigen::VectorXd ring_weight(const std::vector<Vec2>& nodes, const Tip& tip, double inner, double outer);

/// Corner values of q; nothing where q is constant over the element.
bool ring_corners(const EnrichedMesh& mesh, int element, const Eigen::VectorXd& q, std::array<double, 4>& corners);

/// Over one element of the ring. `stress` and `work` (stress work density) at point p come from `state(p)`.
template <class State>
DomainIntegral integrate_ring(const ElementOperator& op, const EnrichedMesh& mesh, const Tip& tip,
                              const std::array<double, 4>& q, const Eigen::VectorXd& u, const Elasticity& elastic,
                              bool want_J, bool want_K, State&& state) {
    DomainIntegral sum;
    std::array<Vec2, 4> corners;
    for (std::size_t k = 0; k < 4; ++k) {
        corners[k] = mesh.nodes[static_cast<std::size_t>(mesh.elements[static_cast<std::size_t>(op.element)][k])];
    }
    for (std::size_t p = 0; p < op.points.size(); ++p) {
        const IntegrationPoint& point = op.points[p];
        const auto [stress, work] = state(p);
        const Eigen::Matrix2d gradient = op.displacement_gradient(u, p);
        const Vec2 dq = weight_gradient(corners, q, point.xi);
        if (want_J) sum.J += point.weight * j_density(tip, stress, gradient, work, dq);
        if (!want_K) continue;
        const int side = point.side;
        sum.interaction_I += point.weight * interaction_density(tip, stress, gradient,
                                                                williams_field(1, tip, point.x, side, elastic), dq);
        sum.interaction_II += point.weight * interaction_density(tip, stress, gradient,
                                                                 williams_field(2, tip, point.x, side, elastic), dq);
    }
    return sum;
}

}  // namespace stria
