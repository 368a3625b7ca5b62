// The bound of the far stresses: never below them, close where it has learnt, and of use where the guard asks for it.
#include "coarse/zone/far_stress_bound.hpp"

#include <gtest/gtest.h>

#include <random>

#include "coarse/zone/refined_scene.hpp"
#include "coarse/zone/structure_stresses.hpp"
#include "common/fem/centre.hpp"
#include "tests/support/load_cases.hpp"
#include "tests/support/pulled_plate.hpp"

namespace stria::coarse {
namespace {

/// The zone is the tip's neighbourhood; near elements reach half across the plate.
class FarStress : public testing::TestWithParam<PlaneState> {
protected:
    static Case input() {
        Case plate = test::pulled_plate(0.5, true, false);
        plate.mesh.width = plate.mesh.height = 40.0;
        plate.cracks[0].points = {{0.0, 20.2}, {7.3, 20.2}};
        plate.model.plane = GetParam();
        return plate;
    }

    static ElementSet zone_of(const Scene& scene) {
        ElementSet zone(scene.mesh->elements.size());
        for (int e = 0; e < zone.size(); ++e)
            if ((centre(*scene.mesh, e) - Vec2(7.3, 20.2)).norm() < 1.5) zone.insert(e);
        return zone;
    }

    struct State {
        Eigen::VectorXd whole, rim;
        double load_factor, largest_far;
    };

    [[nodiscard]] State state(const Eigen::VectorXd& gamma, double load_factor) const {
        State s;
        s.whole = structure.expand(gamma, load_factor);
        s.rim = gather(s.whole, structure.rim());
        s.load_factor = load_factor;
        s.largest_far = largest_far_stress(structure, s.whole, StressPart::Whole);
        return s;
    }

    /// Smooth: a linear field of the size of the elastic strains; rough: any displacement of Gamma.
    [[nodiscard]] Eigen::VectorXd random_gamma(double rough) {
        std::uniform_real_distribution<double> any(-1.0, 1.0);
        const Eigen::Matrix2d gradient = Eigen::Matrix2d::NullaryExpr([&] { return 1e-3 * any(generator); });
        Eigen::VectorXd u = Eigen::VectorXd::Zero(scene.enriched.unknowns);
        for (std::size_t n = 0; n < scene.mesh->nodes.size(); ++n)
            u.segment<2>(scene.enriched.unknown(static_cast<int>(n), 0, 0)) =
                gradient * (scene.mesh->nodes[n] - Vec2(7.3, 20.2));
        Eigen::VectorXd gamma = gather(u, structure.gamma());
        for (double& value : gamma) value += rough * any(generator);
        return gamma;
    }

    std::mt19937 generator{7};
    const Scene scene = refined_scene(input());
    const Structure structure{scene, zone_of(scene)};
};

TEST_P(FarStress, NearUnknownsAreThoseOfTheWhole) {
    EXPECT_GT(structure.near_unknowns().size(), 100U);
    EXPECT_LT(std::ssize(structure.near_unknowns()), structure.unknowns() / 2);
    for (const double load_factor : {0.0, 40.0}) {
        const Eigen::VectorXd gamma = random_gamma(1e-4);
        const Eigen::VectorXd whole = structure.expand(gamma, load_factor);
        Eigen::VectorXd near = Eigen::VectorXd::Zero(whole.size());
        structure.expand_near(gamma, load_factor, 0.0, near);
        structure.elements().for_each(structure.elements().near(), [&](const auto& op) {
            const Eigen::VectorXd error = gather(near, op.unknowns) - gather(whole, op.unknowns);
            EXPECT_LE(error.lpNorm<Eigen::Infinity>(), 1e-12 * whole.lpNorm<Eigen::Infinity>());
        });
    }
}

TEST_P(FarStress, FarForceIsThatOfTheFarElements) {
    const State s = state(random_gamma(1e-4), 0.0);
    double energy = 0.0;
    const MandelMatrix elastic = scene.materials.elastic(0).stiffness();
    structure.elements().for_each([&](const auto& op) {
        if (!structure.is_far(op.element)) return;
        const auto local = gather(s.whole, op.unknowns);
        energy += 0.5 * local.dot((op.stiffness(elastic) * local).eval());
    });
    EXPECT_NEAR(0.5 * s.rim.dot(structure.far_force(s.rim)), energy, 1e-9 * energy);
}

TEST_P(FarStress, BoundIsNeverBelowTheStress) {
    FarStressBound bound(structure);
    EXPECT_EQ(bound.at(state(random_gamma(0.0), 10.0).rim, 10.0), std::numeric_limits<double>::infinity());
    std::uniform_real_distribution<double> any(-50.0, 50.0);
    for (int k = 0; k < 40; ++k) {
        const State s = state(random_gamma(k % 3 == 0 ? 1e-3 : 1e-5), k % 5 == 0 ? 0.0 : any(generator));
        EXPECT_GE(bound.at(s.rim, s.load_factor), s.largest_far * (1.0 - 1e-9)) << k;
        if (k % 4 != 1) continue;
        bound.learn(s.rim, s.load_factor, s.largest_far);
        EXPECT_LE(bound.at(s.rim, s.load_factor), 1.03 * s.largest_far) << k;  // but for what is not worth a mode
    }
}

// Energy density >= sigma^2 / (6 G), and a point's share of the energy is no more than all of it.
TEST_P(FarStress, WhatNothingIsKnownOfIsBoundByItsEnergy) {
    const State s = state(random_gamma(1e-4), 0.0);
    double smallest = std::numeric_limits<double>::infinity();  // mm2
    structure.elements().for_each([&](const auto& op) {
        if (!structure.is_far(op.element)) return;
        for (const IntegrationPoint& point : op.points) smallest = std::min(smallest, point.weight);
    });
    const double energy = 0.5 * s.rim.dot(structure.far_force(s.rim)),
                 shear = scene.materials.elastic(0).shear_modulus();
    const double bound = std::sqrt(6.0 * shear * energy / smallest);
    EXPECT_NEAR(FarStressBound(structure).at(s.rim, 0.0), bound, 1e-9 * bound);
}

// Most elements are passed over by the bound of their warping, and none that is beyond the limit.
TEST_P(FarStress, NoNearElementBeyondALimitIsPassedOver) {
    std::uniform_real_distribution<double> any(-1e-3, 1e-3);
    const Eigen::VectorXd u =
        Eigen::VectorXd::NullaryExpr(scene.enriched.unknowns, [&] { return any(generator); });  // mm
    std::size_t fewest = structure.elements().near().size(), most = 0;
    for (double limit = 20.0; limit < 2000.0; limit *= 1.1) {
        std::vector<int> near = elements_beyond(limit, structure, u);
        std::erase_if(near, [&](int element) { return structure.is_far(element); });
        EXPECT_EQ(near_elements_beyond(limit, structure, u), near) << limit;
        fewest = std::min(fewest, near.size());
        most = std::max(most, near.size());
    }
    EXPECT_EQ(fewest, 0U);
    EXPECT_EQ(most, structure.elements().near().size());
}

TEST_P(FarStress, BoundIsTheStressOfAStateThatItKnowsAtAnyLoad) {
    FarStressBound bound(structure);
    for (const double load_factor : {40.0, -30.0, 20.0}) {
        const State s = state(random_gamma(1e-5), load_factor);
        bound.learn(s.rim, load_factor, s.largest_far);
        for (const double scale : {1.0, 0.3, -0.7})
            EXPECT_NEAR(bound.at(scale * s.rim, scale * load_factor), std::abs(scale) * s.largest_far,
                        1e-6 * s.largest_far);
    }
}

/// With a load case on two sides and a wheel on the third, each with a factor of its own.
TEST_P(FarStress, BoundHoldsWithLoadCases) {
    Case loaded = input();
    loaded.load.steps = 4;
    loaded.load_cases = {test::lagging_load("shear", 1.0, 90.0)};
    const TravellingPressure wheel{.p0 = 1.0, .half_width = 2.0, .from = 5.0, .to = 15.0};
    loaded.boundaries.insert(loaded.boundaries.end(), {test::pulled_in_case("shear", "top", {1.0, 0.5}),
                                                       test::pulled_in_case("shear", "right", {1.0, 0.0}),
                                                       test::held("left"), test::under_wheel("right", wheel)});
    const Scene body = refined_scene(loaded);
    const Structure parts(body, zone_of(body));
    FarStressBound bound(parts);
    bound.learn_pivot(gather(parts.expand(Eigen::VectorXd::Zero(std::ssize(parts.gamma())), 1.0), parts.rim()),
                      largest_far_stress(parts, parts.expand(Eigen::VectorXd::Zero(std::ssize(parts.gamma())), 1.0),
                                         StressPart::OfDisplacement));
    std::uniform_real_distribution<double> any(-50.0, 50.0);
    for (int k = 0; k < 40; ++k) {
        const LoadFactors factors(k % 5 == 0 ? 0.0 : any(generator),
                                  Eigen::VectorXd::NullaryExpr(6, [&] { return any(generator); }));
        const Eigen::VectorXd gamma =
            1e-5 * Eigen::VectorXd::NullaryExpr(std::ssize(parts.gamma()), [&] { return any(generator); });
        const Eigen::VectorXd whole = parts.expand(gamma, factors), rim = gather(whole, parts.rim());
        const double largest = largest_far_stress(parts, whole, StressPart::Whole);
        EXPECT_GE(bound.at(rim, factors), largest * (1.0 - 1e-9)) << k;
        if (k % 4 != 1) continue;
        bound.learn(rim, factors, largest);
        EXPECT_LE(bound.at(rim, factors), 1.03 * largest) << k;
    }
}

/// Of two materials, of which one is twice as strong and one never yields; with a stress before any load.
TEST_P(FarStress, BoundHoldsWithSeveralMaterialsAndInitialStress) {
    Case several = input();
    several.regions.resize(2);
    several.regions[0] = {.outline = {{20.0, -1.0}, {30.0, 41.0}}, .material = several.material, .initial_stress = {}};
    several.regions[0].material.yield_stress = 600.0;
    several.regions[0].initial_stress = MisfitStress{.xx = 20.0, .yy = -40.0, .xy = 5.0};
    several.regions[1] = {.outline = {{30.0, -1.0}, {41.0, 41.0}}, .material = several.material, .initial_stress = {}};
    several.regions[1].material.yield_stress.reset();
    several.regions[1].material.young = 600e3;
    const Scene stressed = refined_scene(several);
    const Structure body(stressed, zone_of(stressed));
    FarStressBound bound(body);
    const auto looked_at = [&](const Eigen::VectorXd& gamma, double load_factor, double initial, StressPart part) {
        State s{body.expand(gamma, load_factor, initial), {}, load_factor, 0.0};
        s.rim = gather(s.whole, body.rim());
        s.largest_far = largest_far_stress(body, s.whole, part);
        return s;
    };
    const State pivot = looked_at(random_gamma(0.0), 1.0, 0.0, StressPart::OfDisplacement);
    bound.learn_pivot(pivot.rim, pivot.largest_far);
    EXPECT_EQ(bound.at(pivot.rim, 1.0), std::numeric_limits<double>::infinity());
    std::uniform_real_distribution<double> any(-50.0, 50.0);
    for (int k = 0; k < 40; ++k) {
        const State s = looked_at(random_gamma(k % 3 == 0 ? 1e-3 : 1e-5), k % 5 == 0 ? 0.0 : any(generator), 1.0,
                                  StressPart::Whole);
        EXPECT_GE(bound.at(s.rim, s.load_factor), s.largest_far * (1.0 - 1e-9)) << k;
        if (k % 4 != 1) continue;
        bound.learn(s.rim, s.load_factor, s.largest_far);
        EXPECT_LE(bound.at(s.rim, s.load_factor), 1.03 * s.largest_far) << k;
    }
}

INSTANTIATE_TEST_SUITE_P(Planes, FarStress, testing::Values(PlaneState::Strain, PlaneState::Stress),
                         [](const auto& test) { return test.param == PlaneState::Strain ? "strain" : "stress"; });

}  // namespace
}  // namespace stria::coarse
