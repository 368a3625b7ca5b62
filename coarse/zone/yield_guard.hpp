// Whether all coarse elements stay elastic. The near ones are visited; the far ones only where the bound of their
// stresses leaves it open.
#pragma once

#include <optional>

#include "coarse/equilibrium/equilibrium.hpp"
#include "coarse/zone/far_stress_bound.hpp"

namespace stria::coarse {

class YieldGuard {
public:
    /// Nothing yields where no material has a yield stress.
    explicit YieldGuard(const Materials& materials);

    /// Turns to another structure, which must outlive its checks. Where its far body is another one, the bound begins
    /// anew with `elastic`, the displacement of the whole mesh in an elastic equilibrium at the load factor 1, mm. It
    /// may be empty: then the bound learns more slowly.
    void turn_to(const Structure& structure, const Eigen::VectorXd& elastic);

    /// Coarse elements that the trial state, in equilibrium, takes beyond the yield stress, ascending.
    [[nodiscard]] std::vector<int> elements_beyond(const Equilibrium& equilibrium);

    /// Checks of the far elements one by one, and by their bound.
    [[nodiscard]] const coupling::WorkCounts& work() const { return work_; }

private:
    double limit_;  // the weakest yield stress, MPa
    const Structure* structure_ = nullptr;
    std::optional<FarStressBound> far_;  // where something may yield
    coupling::WorkCounts work_;
    int unpaid_ = 0;  // what was learnt about this far body, less the checks that it saved
};

}  // namespace stria::coarse
