// Plates whose mesh lines are turned about a tip, so that a crack crosses them at any place and angle.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "coarse/specimen/specimen.hpp"
#include "tests/support/mesh_files.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria::test {

/// Lines turned by so many degrees about `tip`, and less and less farther away: by 1/e of it at 9 mm. The outline
/// stays.
inline Mesh turned(Mesh mesh, const Vec2& tip, double degrees) {
    constexpr double reach = 9.0;
    const double height = 2.0 * tip.y();
    for (Vec2& node : mesh.nodes) {
        const bool is_outer = node.x() == 0.0 || node.y() == 0.0 || node.y() == height;
        const Vec2 arm = node - tip;
        const double angle = degrees / 180.0 * std::numbers::pi * std::exp(-arm.squaredNorm() / (reach * reach));
        if (!is_outer) node = tip + Eigen::Rotation2Dd(angle) * arm;
    }
    return mesh;
}

/// The plate of a case with an edge crack at mid-height, as a file in `folder` with such a mesh. Its mouth lies
/// outside.
inline Case on_turned_mesh(Case input, double degrees, const TemporaryFolder& folder) {
    input.cracks[0].points.front().x() = -1.0;
    const Mesh straight = coarse::make_mesh(input.mesh, input.cracks);
    input.mesh = {};
    input.mesh.file = folder / "plate.msh";
    write_file(*input.mesh.file, msh_text(turned(straight, input.cracks[0].points.back(), degrees)));
    return input;
}

}  // namespace stria::test
