// What acts on an edge of a body, and where it has to be looked at to be integrated.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "common/geometry/vec2.hpp"

namespace stria::coarse {

/// A boundary edge's ends in the order of the element, and its normal into the body.
struct EdgeGeometry {
    Vec2 from, to;

    [[nodiscard]] double length() const { return (to - from).norm(); }
    [[nodiscard]] Vec2 at(double fraction) const { return (1.0 - fraction) * from + fraction * to; }
    [[nodiscard]] Vec2 inward_normal() const { return Vec2(from.y() - to.y(), to.x() - from.x()) / length(); }
};

/// Hertz' pressure with its middle at one place, and friction times it along the edge. Places are counted along the
/// edge, towards growing x, or y where it stands upright, from the origin of the traction on.
struct HertzPressure {
    double p0 = 0.0;                        // MPa
    double half_width = 0.0, middle = 0.0;  // mm
    double friction = 0.0;

    [[nodiscard]] double at(double place) const;
};

/// How a pin presses: with the cosine to a direction, radially from its centre, or along the edge's inward normal.
struct CosinePressure {
    Vec2 direction = Vec2::Zero();  // unit
    std::optional<Vec2> centre;     // mm

    /// Of the pressure 1.
    [[nodiscard]] Vec2 at(const Vec2& x, const Vec2& inward_normal) const;
};

/// Traction on an edge: t(x) = constant + gradient (x - origin) + pressure * inward normal, or a pressure that is
/// distributed.
struct Traction {
    Vec2 constant = Vec2::Zero();                        // MPa
    Eigen::Matrix2d gradient = Eigen::Matrix2d::Zero();  // MPa/mm
    Vec2 origin = Vec2::Zero();                          // mm
    double pressure = 0.0;                               // MPa
    std::optional<CosinePressure> cosine = {};           // distributes the pressure
    std::optional<HertzPressure> hertz = {};

    [[nodiscard]] Vec2 at(const Vec2& x, const Vec2& inward_normal) const;
    [[nodiscard]] bool is_zero() const {
        return constant.isZero(0.0) && gradient.isZero(0.0) && pressure == 0.0 && !hertz;
    }
};

/// A point of an edge, and the length that it stands for.
struct EdgePoint {
    double fraction;  // of the edge, from its first end
    double length;    // mm
};

/// Points that integrate a traction times a smooth function on a part of an edge: `order` Gauss points where the
/// traction is linear; else more, and none across the ends of what presses. There Hertz' pressure is a square root: of
/// the angle whose sine is the place it is smooth.
[[nodiscard]] std::vector<EdgePoint> edge_points(const Traction& traction, const EdgeGeometry& edge, double from,
                                                 double to, int order);

}  // namespace stria::coarse
