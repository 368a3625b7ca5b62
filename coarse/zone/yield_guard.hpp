// Whether all that is coarse stays elastic: looks at the near elements, and at the far ones where their bound does not
// settle it.
#pragma once

#include <optional>

#include "coarse/equilibrium/equilibrium.hpp"
#include "coarse/structure/far_stress_bound.hpp"

namespace stria::coarse {

class YieldGuard {
public:
    /// Nothing yields where the material has no yield stress.
    explicit YieldGuard(const Case& input);

    /// Turns to another structure, which must outlive its checks. Where its far body is another one, the bound begins
    /// anew with `elastic`: displacement of the whole mesh of some state that is in equilibrium there at the load
    /// factor 1; may be empty.
    void turn_to(const Structure& structure, const Eigen::VectorXd& elastic);

    /// Coarse elements that the trial state, in equilibrium, takes beyond the yield stress, ascending.
    [[nodiscard]] std::vector<int> elements_beyond(const Equilibrium& equilibrium);

    /// Checks of the far elements one by one, and by their bound.
    [[nodiscard]] const coupling::WorkCounts& work() const { return work_; }

private:
    double limit_;
    const Structure* structure_ = nullptr;
    std::optional<FarStressBound> far_;  // where something may yield
    coupling::WorkCounts work_;
    int unpaid_ = 0;  // what was learnt about this far body, less the checks that it saved
};

}  // namespace stria::coarse
