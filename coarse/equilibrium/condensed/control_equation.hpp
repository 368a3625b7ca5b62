// The equation of the load factor: what is controlled goes to its target (docs/method.md, section 6).
#pragma once

#include <algorithm>
#include <cmath>

#include "coarse/load/target.hpp"
#include "coarse/structure/condensed_loads.hpp"

namespace stria::coarse {

/// w . u + k lambda + ... = target: the mean displacement of the loaded boundary, or the load factor itself.
class ControlEquation {
public:
    ControlEquation() = default;
    ControlEquation(const Target& target, const CondensedLoads& loads, Eigen::Index free_places)
        : controlled_(target.control == Control::Load ? LinearReading::load_factor(free_places)
                                                      : loads.displacement_reading()),
          target_(target.value) {}

    [[nodiscard]] const LinearReading& controlled() const { return controlled_; }
    [[nodiscard]] bool is_load_factor() const { return controlled_.is_load_factor(); }

    /// What is left to the target at a state; `u`: on the free places.
    [[nodiscard]] double off_target(const Eigen::VectorXd& u, const LoadFactors& factors) const {
        return target_ - controlled_.at(u, factors);
    }

    /// The load factor that meets it, where displacements have no part in it.
    [[nodiscard]] double load_factor(const Eigen::VectorXd& cases) const {
        const Eigen::VectorXd nothing = Eigen::VectorXd::Zero(controlled_.weights.size());
        return off_target(nothing, LoadFactors(0.0, cases)) / controlled_.per_load_factor;
    }

    /// That which is left, beside what there is: `largest`: displacement, mm.
    [[nodiscard]] double relative(double off_target, double largest, double load_factor) const {
        return std::abs(off_target) /
               std::max({std::abs(target_), largest, std::abs(controlled_.per_load_factor * load_factor), 1e-300});
    }

private:
    LinearReading controlled_;  // on the free places
    double target_ = 0.0;
};

}  // namespace stria::coarse
