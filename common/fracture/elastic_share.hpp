// What a plain element adds to a ring while it is elastic, in closed form: its stresses are linear in its displacement,
// so J is of second degree in it, and all else of first.
#pragma once

#include <array>
#include <span>

#include "common/fracture/auxiliary_fields.hpp"
#include "common/fracture/domain_sums.hpp"
#include "common/mandel.hpp"

namespace stria {

/// How far the second, third and fourth node of an element of four functions have moved, less what the first one has,
/// mm: component fastest. That all of them move alike adds nothing anywhere.
using NodeMotion = Eigen::Matrix<double, 6, 1>;

/// `moved`: of all its nodes, 2 x 4.
inline NodeMotion motion_of(const Eigen::Matrix<double, 2, 4>& moved) {
    return (moved.rightCols<3>().colwise() - moved.col(0)).reshaped();
}

/// A point of such an element: what is there without motion, and what motions strain it.
struct ElasticPoint {
    Mandel stress;                              // MPa
    double work;                                // W, N/mm2: strains add (stress + C strain / 2) strain to it
    Eigen::Matrix2d gradient;                   // of the displacement (row: component)
    Eigen::Matrix<double, 3, 2> functions;      // gradients of the three functions, 1/mm
    Eigen::Matrix<double, 4, 6> strain;         // per motion, 1/mm
    Eigen::Matrix<double, 4, 6> stress_change;  // C times that
};

/// What all rings about a tip that turns its point `along` share of such a point.
class ElasticResponse {
public:
    ElasticResponse(const ElasticPoint& point, double area, const Vec2& along);

private:
    friend class ElasticShare;
    static constexpr std::size_t pairs = 21;  // of motions i and j <= i, row by row

    Vec2 along_, slope_;  // slope: u_,1 without motion
    Mandel stress_;
    double work_;
    Eigen::Vector3d functions_;         // their derivatives along the tip
    NodeMotion xx_, yy_, xy_;           // stresses per motion
    NodeMotion strained_;               // their strain, on the stress without motion
    std::array<double, pairs> energy_;  // of two motions: half of each by itself
    double turn_;                       // rotation times area
    NodeMotion turns_;
};

class ElasticShare {
public:
    /// Adds that of a point. `dq`: gradient of the ring's weight, times the area of the point. `fields`: the auxiliary
    /// ones there.
    void add(const ElasticResponse& point, const Vec2& dq, std::span<const AuxiliaryField, 3> fields);

    /// At a motion; without what does not depend on the solution.
    [[nodiscard]] DomainIntegral at(const NodeMotion& motion) const;

private:
    /// Of an integral that is linear in the motion.
    struct Linear {
        double standing = 0.0;
        NodeMotion slope = NodeMotion::Zero();

        [[nodiscard]] double at(const NodeMotion& motion) const { return standing + slope.dot(motion); }
    };
    void add_momentum(const ElasticResponse& point, const Vec2& dq);

    Linear J_;                                                // its terms of first degree
    std::array<double, ElasticResponse::pairs> curvature_{};  // those of second degree
    std::array<Linear, 3> interactions_;                      // I, II, T
    Linear rotation_;
};

}  // namespace stria
