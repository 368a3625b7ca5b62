// Initial stresses of small bodies, and what is known of them.
#pragma once

#include <cmath>
#include <numbers>

#include "common/fem/centre.hpp"
#include "tests/support/layered_plates.hpp"
#include "tests/support/specimens.hpp"

namespace stria::test {

inline RegionSection misfit(std::vector<Vec2> outline, double E, double yy) {
    RegionSection region = region_of(std::move(outline), E, 0.0);
    region.initial_stress = MisfitStress{.yy = yy};
    return region;
}

/// A function as a profile of straight lines.
template <class Function> StressProfile profile_of(double low, double high, int pieces, const Function& stress) {
    StressProfile profile;
    for (int k = 0; k <= pieces; ++k) {
        profile.at.push_back(low + (high - low) * k / pieces);
        profile.stress.push_back(stress(profile.at.back()));
    }
    return profile;
}

/// Equilibrium of a body without a zone under its initial stress alone; the whole stress at element centres.
struct Settled {
    explicit Settled(const Case& input)
        : scene(coarse::refined_scene(input)), structure(scene), u(structure.expand({}, 0.0, 1.0)) {}
    Settled(const Settled&) = delete;
    Settled& operator=(const Settled&) = delete;

    [[nodiscard]] Mandel stress_at(const Vec2& place) const {
        Mandel stress = Mandel::Zero();
        double nearest = 1e300;
        structure.elements().for_each([&](const auto& op) {
            const double distance = (centre(*scene.mesh, op.element) - place).norm();
            if (distance >= nearest) return;
            nearest = distance;
            const auto local = gather(u, op.unknowns);
            stress.setZero();
            for (std::size_t q = 0; q < op.points.size(); ++q)
                stress += op.points[q].weight / op.area *
                          (scene.initial_stress(op.element, op.points[q].x) +
                           scene.stiffness(op.element) * op.strain(local, q));
        });
        return stress;
    }

    coarse::Scene scene;
    coarse::Structure structure;
    Eigen::VectorXd u;
};

struct EdgeCrackInAProfile {
    static constexpr double W = 1.0;

    /// Without resultant and moment.
    static double stress(double x) { return 100.0 * (1.0 - 6.0 * x + 6.0 * x * x); }

    static Case input(double a) {
        Case input = graded_to_tips(edge_crack(a, 4.0, End::Pulled), 0.005);
        input.initial_stress =
            InitialStressSection{.sigma_x = {}, .sigma_y = profile_of(0.0, W, 40, stress), .file = {}, .grid = {}};
        return input;
    }

    /// Bueckner (1970): the weight function of an edge crack in a strip, to 1 % up to a/W = 0.5.
    static double weight_function_K(double a) {
        const double x = a / W, x2 = x * x, x6 = x2 * x2 * x2;
        const double m1 = 0.6147 + 17.1844 * x2 + 8.7822 * x6, m2 = 0.2502 + 3.2889 * x2 + 70.0444 * x6;
        double K = 0.0;
        constexpr int steps = 2000;
        for (int i = 0; i < steps; ++i) {  // s = a t^2 from the tip
            const double t = (i + 0.5) / steps, s = a * t * t;
            K += std::sqrt(2.0 / std::numbers::pi) * (1.0 + m1 * s / a + m2 * s * s / (a * a)) * stress(a - s) * 2.0 *
                 std::sqrt(a) / steps;
        }
        return K;
    }
};

}  // namespace stria::test
