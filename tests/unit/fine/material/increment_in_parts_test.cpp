// Strain increments in parts: the error bound, against a thousand increments, and that stress and tangent stay smooth.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "fine/material/implicit/j2_implicit.hpp"
#include "fine/material/implicit/parts_of_increment.hpp"
#include "tests/support/material_catalogue.hpp"
#include "tests/support/material_point.hpp"

namespace stria::test {
namespace {

fine::J2Parameters parameters_of(const Law& law, int substeps) {
    return {.elasticity = elasticity_of(law.material, law.plane),
            .yield_stress = *law.material.yield_stress,
            .isotropic = law.material,
            .kinematic = law.material.kinematic,
            .substeps = substeps};
}

fine::J2Implicit implicit_law(const Law& law, int substeps) { return fine::J2Implicit(parameters_of(law, substeps)); }

std::vector<Law> laws_that_flow() {
    std::vector<Law> laws = catalogue();
    std::erase_if(laws, [](const Law& law) { return !law.material.yield_stress; });
    return laws;
}

/// Increments from a tenth of the yield strain to ten times as much, each from a state that others have led to.
class EveryLawInParts : public testing::TestWithParam<Law> {
protected:
    template <class Look> void on_a_random_path(int steps, unsigned seed, const Look& look) {
        std::mt19937 random(seed);
        std::normal_distribution<double> normal(0.0, 1.0);
        std::uniform_real_distribution<double> exponent(-4.0, -2.0);
        std::vector<double> committed(at(law_.state_size()), 0.0);
        for (int step = 0; step < steps; ++step) {
            const double size = step == 0 ? 3e-3 : std::pow(10.0, exponent(random));
            const Mandel increment = size * Mandel(normal(random), normal(random), 0.0, normal(random));
            const PointUpdate now = update_point(law_, committed, increment);
            if (now.yields) look(committed, increment, now);
            committed = now.state;
        }
    }

    /// Largest error of a path's increments, over the yield stress; one per number of sub-steps.
    std::vector<double> worst_errors(const std::vector<int>& substeps, double times = 1.0) {
        std::vector<double> worst(substeps.size(), 0.0);
        on_a_random_path(15, 5, [&](const std::vector<double>& committed, const Mandel& one, const PointUpdate&) {
            const Mandel increment = times * one;
            PointUpdate exact{.state = committed, .tangent = law_.elastic(), .yields = false};
            const int parts = times > 1.0 ? 2000 : 1000;
            for (int k = 0; k < parts; ++k) exact = update_point(law_, exact.state, increment / parts);
            for (std::size_t k = 0; k < substeps.size(); ++k) {
                const fine::J2Implicit judged = implicit_law(GetParam(), substeps[k]);
                const Mandel stress = update_point(judged, committed, increment).stress();
                worst[k] = std::max(worst[k], von_mises(stress - exact.stress()) / *GetParam().material.yield_stress);
            }
        });
        return worst;
    }

    int parts_of(const std::vector<double>& committed, const Mandel& increment) const {
        const Law& law = GetParam();
        const fine::J2Parameters parameters = parameters_of(law, 4);
        const fine::DeviatoricElasticity elasticity(parameters.elasticity);
        const fine::ReturnLaw returned(parameters, elasticity.rates);
        const fine::PackPlace<1> here{1, 0};
        fine::PackState<1> state;
        state.put(returned, here, committed.data());
        const Mandel elastic = elasticity.stiffness * increment;
        return fine::PartsOfIncrement<1>(parameters, returned, state,
                                         fine::deviators_of<1>(here.tensors(elastic.data(), 0)),
                                         fine::Mask<1>::Constant(true))
            .count();
    }

    fine::J2Implicit law_ = implicit_law(GetParam(), 4);
};

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryLawInParts, testing::ValuesIn(laws_that_flow()),
                         [](const auto& law) { return law.param.name; });

TEST_P(EveryLawInParts, KeepsItsBound) {
    const std::vector<double> worst = worst_errors({4, 40, 1});
    EXPECT_LT(worst[0], 1e-3);
    EXPECT_LT(worst[1], 1e-4);
    EXPECT_GT(worst[2], 1e-2);  // backward Euler at once
}

// There are fewer parts again, where nothing recalls: the flow has long turned.
TEST_P(EveryLawInParts, KeepsItsBoundAtTensOfYieldStrains) { EXPECT_LT(worst_errors({4}, 30.0)[0], 1e-3); }

TEST_P(EveryLawInParts, AHundredYieldStrainsTakeEightPartsWhereNothingRecalls) {
    const std::vector<KinematicHardening>& terms = GetParam().material.kinematic;
    const bool recalls = std::ranges::any_of(terms, [](const auto& term) { return term.gamma != 0.0; });
    const Mandel before{-1e-3, 2e-3, 0.0, 1e-3}, turned{0.3, 0.1, 0.0, -0.4};
    const PointUpdate start = update_point(law_, std::vector<double>(at(law_.state_size()), 0.0), before);
    EXPECT_EQ(parts_of(start.state, turned), recalls ? 20 : 8);
}

TEST_P(EveryLawInParts, TangentIsTheSymmetricPartOfTheDerivative) {
    const double h = 1e-8;
    on_a_random_path(60, 6, [&](const std::vector<double>& committed, const Mandel& increment, const PointUpdate& now) {
        MandelMatrix derivative;
        for (int j = 0; j < 4; ++j) {
            const PointUpdate plus = update_point(law_, committed, increment + h * Mandel::Unit(j));
            const PointUpdate minus = update_point(law_, committed, increment - h * Mandel::Unit(j));
            derivative.col(j) = (plus.stress() - minus.stress()) / (2.0 * h);
        }
        derivative = (0.5 * (derivative + derivative.transpose())).eval();
        EXPECT_LT((derivative - now.tangent).norm(), 1e-6 * law_.elastic().norm());
    });
}

// As an increment grows one part more is taken, and the stress does not jump.
TEST_P(EveryLawInParts, StressDoesNotJumpWhereAPartBegins) {
    const Mandel before{-1e-3, 2e-3, 0.0, 1e-3}, turned{3e-3, 1e-3, 0.0, -4e-3};
    const PointUpdate start = update_point(law_, std::vector<double>(at(law_.state_size()), 0.0), before);
    const int few = parts_of(start.state, 0.7 * turned), most = parts_of(start.state, turned);
    ASSERT_LT(few, most);
    double below = 0.7, above = 1.0;
    while (above - below > 1e-12) {
        const double middle = 0.5 * (below + above);
        (parts_of(start.state, middle * turned) < most ? below : above) = middle;
    }
    const auto stress = [&](double share) { return update_point(law_, start.state, share * turned).stress(); };
    EXPECT_LT((stress(above) - stress(below)).norm(), 1e-8);
}

// What an increment dissipates beyond the yield stress is what recall takes: the balance closes in third order.
TEST_P(EveryLawInParts, WorkIsStoredOrDissipated) {
    std::vector<double> committed(at(law_.state_size()), 0.0);
    committed = update_point(law_, committed, Mandel(-1e-3, 2e-3, 0.0, 1e-3)).state;
    const auto missing = [&](double size) {
        const Mandel aside = size * Mandel(0.5, 3.0, 0.0, 4.0);
        const PointUpdate end = update_point(law_, committed, aside);
        EXPECT_TRUE(end.yields);
        const auto booked = [&](const std::vector<double>& state) {
            return law_.stored_energy(state.data(), 1) + state[at(fine::state::dissipation)] -
                   state[at(fine::state::work)];
        };
        return std::abs(booked(end.state) - booked(committed));
    };
    EXPECT_LT(missing(1e-6), 1e-2 * missing(1e-5) + 1e-13);
}

}  // namespace
}  // namespace stria::test
