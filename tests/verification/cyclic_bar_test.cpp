// Uniaxial cycles of every law that hardens against the solution of its differential equations, which is in closed form
// on each branch.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/index.hpp"
#include "fine/material/hardening_curve.hpp"
#include "tests/support/cyclic_turns.hpp"
#include "tests/support/material_catalogue.hpp"

namespace stria::test {
namespace {

/// A bar without error: on a branch of direction s dX = (s C(p) - gamma X) dp, an exponential in dp, and a back stress
/// with a threshold grows by s C dp up to its limit.
class ExactBar {
public:
    explicit ExactBar(const MaterialSection& material)
        : material_(material), curve_(material), back_(material.kinematic.size(), 0.0) {}

    void strain_to(double strain) {
        const double s = strain > strain_ ? 1.0 : -1.0;
        const double dp = flow([&](double by) { return s * (material_.young * (strain - plastic_ - s * by)); }, s);
        go(s, dp);
        strain_ = strain;
    }

    void load_to(double stress) {
        const double s = stress > this->stress() ? 1.0 : -1.0;
        go(s, flow([&](double) { return s * stress; }, s));
        strain_ = plastic_ + stress / material_.young;
    }

    [[nodiscard]] double stress() const { return material_.young * (strain_ - plastic_); }
    [[nodiscard]] double plastic_strain() const { return plastic_; }

private:
    [[nodiscard]] double back_stress(std::size_t k, double s, double dp) const {
        const KinematicHardening& term = material_.kinematic[k];
        const double linear = back_[k] + s * term.C * dp;
        if (term.gamma == 0.0) return linear;
        const double limit = term.C / term.gamma, left = std::exp(-term.gamma * dp);
        if (term.threshold) return std::clamp(linear, -limit, limit);
        const double missing = (term.C_start.value_or(term.C) - term.C) * std::exp(-term.C_rate * p_);
        const double growing = missing * (std::exp(-term.C_rate * dp) - left) / (term.gamma - term.C_rate);
        return s * (limit * (1.0 - left) + growing) + back_[k] * left;
    }

    /// s times the stress on the yield surface.
    [[nodiscard]] double resistance(double s, double dp) const {
        double sum = *material_.yield_stress + curve_.value(p_ + dp);
        for (std::size_t k = 0; k < back_.size(); ++k) sum += s * back_stress(k, s, dp);
        return sum;
    }

    /// The dp at which s times the stress that is asked for is borne.
    template <class Asked> [[nodiscard]] double flow(const Asked& asked, double s) const {
        if (asked(0.0) <= resistance(s, 0.0)) return 0.0;
        double below = 0.0, above = 1.0;
        for (int k = 0; k < 200; ++k) {
            const double middle = 0.5 * (below + above);
            (asked(middle) > resistance(s, middle) ? below : above) = middle;
        }
        return 0.5 * (below + above);
    }

    void go(double s, double dp) {
        for (std::size_t k = 0; k < back_.size(); ++k) back_[k] = back_stress(k, s, dp);
        p_ += dp;
        plastic_ += s * dp;
    }

    const MaterialSection& material_;
    fine::HardeningCurve curve_;
    std::vector<double> back_;
    double p_ = 0.0, plastic_ = 0.0, strain_ = 0.0;
};

class CyclicBar : public testing::TestWithParam<Law> {};

INSTANTIATE_TEST_SUITE_P(Catalogue, CyclicBar, testing::ValuesIn(catalogue().begin() + 1, catalogue().end()),
                         [](const auto& law) { return law.param.name; });

// Between strains of -0.2 and 1 %: what recalls loses its mean stress.
TEST_P(CyclicBar, RelaxesItsMeanStress) {
    const Law& law = GetParam();
    if (!law.material.yield_stress) return;
    const LoadBlock block{.cycles = 12, .max = 0.01, .min = -0.002};
    const std::vector<Turns> found =
        extrapolated_turns(tested(law.material, law.plane, TestControl::Strain, block, 400));
    ExactBar exact(law.material);
    exact.strain_to(block.max);
    const double scale = exact.stress();
    for (const Turns& turns : found) {
        exact.strain_to(block.min);
        const double at_min = exact.stress();
        EXPECT_NEAR(turns.stress_at_min, at_min, 1e-4 * scale);
        exact.strain_to(block.max);
        EXPECT_NEAR(turns.stress_at_max, exact.stress(), 1e-4 * scale);
        EXPECT_NEAR(turns.stress_at_max + turns.stress_at_min, exact.stress() + at_min, 1e-4 * scale);
    }
}

// Between stresses that the metal bears and that make it flow.
TEST_P(CyclicBar, RatchetsFromCycleToCycle) {
    const Law& law = GetParam();
    if (law.material.kinematic.empty()) return;
    const LoadBlock block{.cycles = 8, .max = 430.0, .min = -380.0};
    const std::vector<Turns> found =
        extrapolated_turns(tested(law.material, law.plane, TestControl::Stress, block, 600));
    ExactBar exact(law.material);
    exact.load_to(block.max);
    const double scale = exact.plastic_strain();
    for (const Turns& turns : found) {
        exact.load_to(block.min);
        EXPECT_NEAR(turns.plastic_at_min, exact.plastic_strain(), 1e-4 * scale);
        exact.load_to(block.max);
        EXPECT_NEAR(turns.plastic_at_max, exact.plastic_strain(), 1e-4 * scale);
    }
}

}  // namespace
}  // namespace stria::test
