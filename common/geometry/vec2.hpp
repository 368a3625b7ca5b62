// Places and directions in the plane.
#pragma once

#include <Eigen/Core>

namespace stria {

using Vec2 = Eigen::Vector2d;  // x, y

}  // namespace stria
