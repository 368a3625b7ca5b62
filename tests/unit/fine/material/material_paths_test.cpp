// Every law of the catalogue through its corners and through random states: none may fail.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <random>
#include <vector>

#include "fine/material/catalogue/material_catalogue.hpp"
#include "fine/material/hardening_curve.hpp"
#include "tests/support/material_catalogue.hpp"
#include "tests/support/material_point.hpp"

namespace stria::test {
namespace {

/// What is wrong with the last update of a point; empty: nothing.
class Judge {
public:
    /// `beyond_limit`: what a back stress may exceed its limit by, relative.
    explicit Judge(const Law& law, double beyond_limit = 1e-9)
        : law_(law), curve_(curve_of(law.material)), beyond_limit_(beyond_limit) {}

    std::string complaint(const PointUpdate& now, const PointUpdate& before) const {
        for (const double value : now.state)
            if (!std::isfinite(value)) return "a state that is no number";
        if (!now.tangent.allFinite() || now.tangent != now.tangent.transpose()) return "a tangent that is none";
        if (!law_.material.yield_stress) return "";
        const double p = now.scalar(fine::state::accumulated), dp = p - before.scalar(fine::state::accumulated);
        const double Y = *law_.material.yield_stress + curve_.value(p);
        const double overstress = von_mises(relative(now)) / Y - 1.0;
        if (overstress > 1e-9 || (now.yields && overstress < -1e-9)) return fmt::format("overstress {}", overstress);
        if (dp < 0.0 || (!now.yields && dp > 0.0)) return fmt::format("dp = {}", dp);
        const double dissipated = now.scalar(fine::state::dissipation) - before.scalar(fine::state::dissipation);
        // A modulus that grows takes of what recall gives.
        const double least = grows_ ? 0.0 : *law_.material.yield_stress * dp;
        if (dissipated < least * (1.0 - 1e-9) - 1e-12 * now.scalar(fine::state::dissipation))
            return fmt::format("dissipated {} of at least {}", dissipated, least);
        return complaint_of_back_stresses(now);
    }

private:
    static fine::HardeningCurve curve_of(const MaterialSection& material) {
        return material.yield_stress ? fine::HardeningCurve(material) : fine::HardeningCurve();
    }

    [[nodiscard]] Mandel back_stress(const PointUpdate& now, std::size_t k) const {
        return now.tensor(fine::state::back_stress + 4 * static_cast<int>(k));
    }

    [[nodiscard]] Mandel relative(const PointUpdate& now) const {
        Mandel stress = now.stress();
        for (std::size_t k = 0; k < law_.material.kinematic.size(); ++k) stress -= back_stress(now, k);
        return stress;
    }

    [[nodiscard]] std::string complaint_of_back_stresses(const PointUpdate& now) const {
        for (std::size_t k = 0; k < law_.material.kinematic.size(); ++k) {
            const KinematicHardening& term = law_.material.kinematic[k];
            if (term.gamma == 0.0) continue;
            const double size = von_mises(back_stress(now, k));
            const double largest = std::max(term.C, term.C_start.value_or(0.0)) / term.gamma;
            if (size > largest * (1.0 + beyond_limit_)) return fmt::format("back stress {} is {}", k, size);
        }
        return "";
    }

    const Law& law_;
    fine::HardeningCurve curve_;
    double beyond_limit_;
    bool grows_ = std::ranges::any_of(law_.material.kinematic,
                                      [](const KinematicHardening& term) { return term.C_start.has_value(); });
};

class EveryPath : public testing::TestWithParam<Law> {
protected:
    void strain_by(const Mandel& increment) {
        const PointUpdate before = point_.last();
        ASSERT_NO_THROW(point_.strain_by(increment)) << increment.transpose();
        ASSERT_EQ(judge_.complaint(point_.last(), before), "") << increment.transpose();
    }

    MaterialPoint point_{GetParam().material, GetParam().plane};
    Judge judge_{GetParam()};
};

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryPath, testing::ValuesIn(catalogue()),
                         [](const auto& law) { return law.param.name; });

/// How much of an increment brings a value that grows with it to its target; bisection.
template <class Value> double share_that_reaches(double target, const Value& value) {
    double below = 0.0, above = 1.0;
    for (int k = 0; k < 200; ++k) {
        const double middle = 0.5 * (below + above);
        (value(middle) < target ? below : above) = middle;
    }
    return above;
}

// Onto the yield surface, onto each corner of the table, onto each threshold, and each a little less and more; turning
// back, sideways along the surface, to the middle of the surface, and far through it.
TEST_P(EveryPath, GoesThroughEveryCorner) {
    const MaterialSection& material = GetParam().material;
    const Mandel pull{-6e-3, 0.012, 0.0, 0.0}, shear{0.0, 0.0, 0.0, 0.01};
    const auto reach = [&](const Mandel& direction, double target, const auto& value_of) {
        const std::vector<double> from = point_.last().state;
        const double share = share_that_reaches(target, [&](double share_so_far) {
            return value_of(update_point(point_.law(), from, share_so_far * direction));
        });
        strain_by(share * direction);
        for (const double step : {-1e-15, 1e-15, -1e-12, 1e-12, -1e-9, 1e-9, 1e-6}) strain_by(step * direction);
    };
    const auto accumulated = [](const PointUpdate& now) { return now.scalar(fine::state::accumulated); };
    const auto mises = [](const PointUpdate& now) { return von_mises(now.stress()); };
    reach(pull, material.yield_stress.value_or(350.0), mises);
    for (const double p : material.isotropic.plastic_strain)
        if (p > 0.0) reach(10.0 * pull, p, accumulated);
    for (const Mandel& direction : {pull, Mandel(-pull), Mandel(shear)}) {
        for (std::size_t k = 0; k < material.kinematic.size(); ++k) {
            const KinematicHardening& term = material.kinematic[k];
            if (!term.threshold) continue;
            const int first = fine::state::back_stress + 4 * static_cast<int>(k);
            reach(direction, term.C / term.gamma,
                  [first](const PointUpdate& now) { return von_mises(now.tensor(first)); });
        }
        for (const Mandel& sideways : {Mandel(1e-6 * shear), Mandel(1e-3 * pull), shear, Mandel(30.0 * pull)}) {
            strain_by(direction);
            strain_by(sideways);
            strain_by(Mandel::Zero());
        }
        strain_by(-direction);
        strain_by(-2.0 * direction);
        strain_by(100.0 * direction);
    }
}

// Increments of any size, from a hundred-thousandth of the yield strain to hundreds of times as much at once; the metal
// is new again after each thousand.
void go_anywhere(const Law& law, int substeps, int steps, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> exponent(-8.0, 0.0), sign(-1.0, 1.0);
    const Judge judge(law, substeps > 1 ? 4e-3 / substeps : 1e-9);
    const auto made = fine::make_material_law(law.material, law.plane, substeps);
    const PointUpdate virgin{
        .state = std::vector<double>(at(made->state_size()), 0.0), .tangent = made->elastic(), .yields = false};
    PointUpdate now = virgin;
    for (int step = 0; step < steps; ++step) {
        if (step % 1000 == 0) now = virgin;
        const double size = std::pow(10.0, exponent(random));
        const Mandel increment = size * Mandel(sign(random), sign(random), 0.0, sign(random));
        const PointUpdate before = now;
        ASSERT_NO_THROW(now = update_point(*made, before.state, increment)) << "seed " << seed << ", step " << step;
        ASSERT_EQ(judge.complaint(now, before), "") << "seed " << seed << ", step " << step;
    }
}

TEST_P(EveryPath, FindsItsWayFromAnyState) { go_anywhere(GetParam(), 1, 3000, 3); }

TEST_P(EveryPath, FindsItsWayFromAnyStateInParts) { go_anywhere(GetParam(), 4, 3000, 11); }

TEST_P(EveryPath, FindsItsWayFromAMillionStatesLong) { go_anywhere(GetParam(), 1, 1'000'000, 11); }

// Hundreds of parts for the largest: fewer.
TEST_P(EveryPath, FindsItsWayFromAnyStateInPartsLong) { go_anywhere(GetParam(), 4, 30'000, 11); }

TEST_P(EveryPath, BeginsWithNothing) {
    const PointUpdate& virgin = point_.last();
    EXPECT_EQ(point_.law().stored_energy(virgin.state.data(), 1), 0.0);
    EXPECT_EQ(point_.law().work(virgin.state.data(), 1), 0.0);
    const double margin = point_.law().elastic_margin(1, 1, virgin.state.data());
    EXPECT_DOUBLE_EQ(margin, (1.0 + fine::overstress_tolerance) * GetParam().material.yield_stress.value_or(INFINITY));
    strain_by(Mandel::Zero());
    for (const double value : point_.last().state) EXPECT_EQ(value, 0.0);
}

}  // namespace
}  // namespace stria::test
