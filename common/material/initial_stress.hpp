// The stress before any load, as the case gives it: not yet in equilibrium with the body's outline, its cracks and what
// lies between its points.
#pragma once

#include <optional>
#include <vector>

#include "common/case/case.hpp"
#include "common/geometry/vec2.hpp"
#include "common/mandel.hpp"

namespace stria {

class InitialStress {
public:
    /// None.
    InitialStress() = default;
    explicit InitialStress(const Case& input);

    [[nodiscard]] bool any() const { return any_; }

    /// Whether elements of both materials, of one elasticity, have the same at every place.
    [[nodiscard]] bool is_alike_in(int one, int other) const;

    /// At a place in an element of a material (materials.hpp), MPa. Across the plane of plane strain nu (xx + yy), as
    /// in an elastic body.
    [[nodiscard]] Mandel at(const Vec2& x, int material) const;

    /// Its derivative along a direction, MPa/mm. Between points it is linear or bilinear, so it jumps there.
    [[nodiscard]] Mandel slope(const Vec2& x, int material, const Vec2& direction) const;

private:
    [[nodiscard]] Mandel with_zz(const Eigen::Vector3d& in_plane, int material) const;

    bool any_ = false;
    InitialStressSection given_;
    std::vector<Eigen::Vector3d> misfit_;  // by material: xx, yy, xy, MPa
    std::vector<double> across_;           // by material: zz over xx + yy
};

}  // namespace stria
