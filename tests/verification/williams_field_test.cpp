// The exact singular fields on the boundary of a square with a crack to its middle: energy-norm and K errors.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <iostream>

#include "coarse/fracture/fracture_parameters.hpp"
#include "tests/support/comparison.hpp"
#include "tests/support/condition_number.hpp"
#include "tests/support/exact_field.hpp"

namespace stria::test {
namespace {

TEST(WilliamsField, MatchesReferenceValues) {  // docs/references.md 2.6: K = 1, r = 1
    const Tip tip{.crack = 0, .position = {0.0, 0.0}, .direction = {1.0, 0.0}, .s = 0.0, .upper = 1};
    const Vec2 at_60(0.5, std::sqrt(0.75));
    const auto row = rows_of(
        {.scene = "singular fields, K = 1, r = 1", .source = "Williams 1957 (2.6)", .within = 1e-6, .scale = 1.0});
    const Vec2 opening = williams_field(1, tip, at_60, 0, unit).displacement;
    const Vec2 sliding = williams_field(2, tip, at_60, 0, unit).displacement;
    row("u_x, mode I, 60 degrees", 0.583885, opening.x());
    row("u_y, mode I, 60 degrees", 0.337106, opening.y());
    row("u_x, mode II, 60 degrees", 1.115044, sliding.x());
    row("u_y, mode II, 60 degrees", -0.134743, sliding.y());
    row("half the opening, mode I", 1.452150, williams_field(1, tip, {-1.0, 0.0}, 1, unit).displacement.y());
}

TEST(WilliamsField, FacesAreFreeOfTraction) {
    const Tip tip{.crack = 0, .position = {0.2, 0.1}, .direction = {0.6, 0.8}, .s = 0.0, .upper = 1};
    for (const int mode : {1, 2}) {
        for (const int side : {1, -1}) {
            const TipField field = williams_field(mode, tip, tip.position - 0.7 * tip.direction, side, unit);
            EXPECT_LT((in_plane(field.stress) * Vec2(-0.8, 0.6)).norm(), 1e-14);
        }
    }
}

struct Errors {
    double energy, K;
};

Errors errors(int n, const Setting& setting) {
    const coarse::Scene scene = exact_boundary(n, setting);
    const coarse::Structure structure(scene);
    const Eigen::VectorXd u = structure.expand({}, 1.0);
    const coarse::TipResult tip = coarse::fracture_parameters(structure, u, {}).front();
    return {energy_error(structure, u, setting.mode),
            std::hypot(tip.K_I - (setting.mode == 1), tip.K_II - (setting.mode == 2))};
}

struct Rates {
    double energy = 0.0, K = 0.0;
};

/// Errors at each size and the rates of the last refinement, printed.
std::pair<std::vector<Errors>, Rates> convergence(const std::string& name, const std::vector<int>& sizes,
                                                  const Setting& setting) {
    std::vector<Errors> found;
    Rates rates;
    for (std::size_t k = 0; k < sizes.size(); ++k) {
        found.push_back(errors(sizes[k], setting));
        if (k > 0) {
            const double refinement = std::log(double(sizes[k]) / sizes[k - 1]);
            rates = {std::log(found[k - 1].energy / found[k].energy) / refinement,
                     std::log(found[k - 1].K / found[k].K) / refinement};
        }
        std::cout << fmt::format("{} mode {} {} n {:3d}: energy {:.4f} rate {:.2f}, K {:.4f} % rate {:.2f}\n", name,
                                 setting.mode, setting.along_edges ? "along" : "across", sizes[k], found[k].energy,
                                 rates.energy, 100.0 * found[k].K, rates.K);
    }
    return {found, rates};
}

class ExactBoundary : public ::testing::TestWithParam<Setting> {};

TEST_P(ExactBoundary, ConvergesLikeTopologicalEnrichment) {  // h^(1/2) in the energy norm, h in K
    const std::string name = fmt::format("{} functions", GetParam().tips.functions);
    const auto [found, rates] = convergence(name, {11, 21, 41, 81}, GetParam());
    EXPECT_GT(rates.energy, 0.45);
    EXPECT_GT(rates.K, 0.9);
    EXPECT_LT(found.back().K, 0.005);
}

constexpr coarse::TipEnrichment six{6, 0.5}, single{1, 0.5};

INSTANTIATE_TEST_SUITE_P(Settings, ExactBoundary,
                         ::testing::Values(Setting{six, 1, false}, Setting{six, 2, false}, Setting{single, 1, false},
                                           Setting{single, 2, false}, Setting{six, 1, true}, Setting{six, 2, true},
                                           Setting{single, 1, true}, Setting{single, 2, true}),
                         [](const auto& setting) {
                             return fmt::format("{}functions_mode{}_{}", setting.param.tips.functions,
                                                setting.param.mode, setting.param.along_edges ? "along" : "across");
                         });

class FixedRadius : public ::testing::TestWithParam<std::tuple<double, int, bool>> {
protected:
    static std::pair<std::vector<Errors>, Rates> over(const std::vector<int>& sizes) {
        const auto [radius, mode, along] = GetParam();
        const Setting setting{{4, 0.5, coarse::TipSupport::Gathered, radius}, mode, along};
        return convergence(fmt::format("gathered radius {}", radius), sizes, setting);
    }
};

// The disk is made of whole elements: on a coarser mesh it is larger by part of one, and the rates of plain elements, 1
// and 2, are approached from below.
TEST_P(FixedRadius, ConvergesLikePlainElements) {
    const auto [found, rates] = over({41, 81});
    EXPECT_GT(rates.energy, 0.88);
    EXPECT_GT(rates.K, 1.8);
    const auto [radius, mode, along] = GetParam();
    const auto row = [&](const std::string& quantity, double error, double within) {
        verify({.scene = fmt::format("exact field of mode {}, functions within {}, {}", mode, radius,
                                     along ? "along edges" : "through elements"),
                .source = "Williams 1957 (2.6)",
                .quantity = quantity,
                .reference = 0.0,
                .ours = error,
                .within = within,
                .mesh = "81 x 81",
                .scale = 1.0});
    };
    row("error in the energy norm", found.back().energy, 0.015);
    row("distance of (K_I, K_II)", found.back().K, 1e-4);
}

TEST_P(FixedRadius, ReachesTheRatesOfPlainElementsLong) {
    const auto [found, rates] = over({81, 161, 321});
    EXPECT_GT(rates.energy, 0.95);
    EXPECT_GT(rates.K, 1.9);
}

INSTANTIATE_TEST_SUITE_P(Radii, FixedRadius,
                         ::testing::Combine(::testing::Values(0.1, 0.2), ::testing::Values(1, 2), ::testing::Bool()));

TEST(FixedRadius, IsAsWellConditionedAsPlainElements) {
    const auto rate_of = [](coarse::TipSupport support) {
        double last = 0.0, rate = 0.0;
        for (const int n : {11, 21, 41}) {
            const coarse::Scene scene = exact_boundary(n, {{4, 0.5, support, 0.2}, 1, false});
            const double found = condition_number(coarse::Structure(scene));
            rate = last > 0.0 ? std::log(found / last) / std::log(double(n) / (n == 21 ? 11 : 21)) : 0.0;
            std::cout << fmt::format("{} n {:2d}: condition number {:.3e}, rate {:.2f}\n",
                                     support == coarse::TipSupport::Nodal ? "nodal" : "gathered", n, found, rate);
            last = found;
        }
        return rate;
    };
    EXPECT_LT(rate_of(coarse::TipSupport::Gathered), 2.1);
    EXPECT_GT(rate_of(coarse::TipSupport::Nodal), 5.5);
}

}  // namespace
}  // namespace stria::test
