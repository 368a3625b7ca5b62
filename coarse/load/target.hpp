// What an increment has to reach.
#pragma once

#include <Eigen/Core>
#include <fmt/format.h>
#include <string>

#include "common/case/case.hpp"

namespace stria::coarse {

struct Target {
    Control control = Control::Load;
    double value = 0.0;          // load factor, or mean displacement of the loaded boundary along its direction, mm
    double held = 0.0;           // share of the forces on faces that growth has opened that still holds them (Fig. 3b)
    Eigen::VectorXd cases = {};  // factors of the load cases (load_factors.hpp)
};

/// "load factor 0.5", "displacement 0.02 mm".
inline std::string to_text(const Target& target) {
    return target.control == Control::Load ? fmt::format("load factor {:.6g}", target.value)
                                           : fmt::format("displacement {:.6g} mm", target.value);
}

}  // namespace stria::coarse
