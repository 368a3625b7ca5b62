// What an increment has to reach, and what of the body that is: load control and displacement control are one equation.
#pragma once

#include <Eigen/Core>
#include <fmt/format.h>
#include <string>

#include "common/io/case.hpp"

namespace stria::coarse {

struct Target {
    Control control = Control::Load;
    double value = 0.0;  // load factor, or mean displacement of the loaded boundary along its direction, mm
};

/// "load factor 0.5", "displacement 0.02 mm".
inline std::string to_text(const Target& target) {
    return target.control == Control::Load ? fmt::format("load factor {:.6g}", target.value)
                                           : fmt::format("displacement {:.6g} mm", target.value);
}

/// What a target is a value of: weights . u + per_load_factor lambda. Of load control it is lambda itself.
struct Controlled {
    Eigen::VectorXd weights;
    double per_load_factor = 0.0;

    static Controlled load_factor(Eigen::Index unknowns) { return {Eigen::VectorXd::Zero(unknowns), 1.0}; }

    [[nodiscard]] double at(const Eigen::VectorXd& u, double load_factor) const {
        return weights.dot(u) + per_load_factor * load_factor;
    }
    /// The target alone says what the load factor is.
    [[nodiscard]] bool is_load_factor() const { return weights.isZero(0.0); }
};

}  // namespace stria::coarse
