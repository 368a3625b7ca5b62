// The exact return of linear hardening in plane strain: the limit of many radial returns; the whole of an increment is
// its halves one after the other; the tangent is the symmetric part of its derivative.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "tests/support/material_point.hpp"

#include "common/index.hpp"
#include "fine/material/catalogue/material_catalogue.hpp"

namespace stria::test {
namespace {

MaterialSection hardening(double isotropic) {
    MaterialSection material;
    material.young = 200e3;
    material.poisson = 0.3;
    material.yield_stress = 350.0;
    material.isotropic.modulus = isotropic;
    material.kinematic = {{3000.0, 0.0}, {20000.0, 0.0}};
    return material;
}

struct Laws {
    explicit Laws(double isotropic)
        : radial(fine::make_material_law(hardening(isotropic), PlaneState::Strain)),
          exact(fine::make_material_law(hardening(isotropic), PlaneState::Strain, 2)) {}
    std::unique_ptr<fine::MaterialLaw> radial, exact;
};

const Laws steel(1000.0);
const Mandel turning{2e-3, 1e-3, 0.0, -3e-3};

std::vector<double> virgin() { return std::vector<double>(at(steel.radial->state_size()), 0.0); }

std::vector<double> strained(const Laws& laws = steel) {
    return update_point(*laws.radial, virgin(), {1e-3, -3e-3, 0.0, 1e-3}).state;
}

/// The largest difference of two states but for the work, over what the state holds.
double difference(const std::vector<double>& a, const std::vector<double>& b) {
    double largest = 0.0;
    for (std::size_t c = 0; c < a.size(); ++c) {
        const double scale = c < 4 || c >= at(fine::state::back_stress) ? 350.0
                             : c == at(fine::state::dissipation)        ? 1.0
                                                                        : 1e-3;
        if (c != at(fine::state::work)) largest = std::max(largest, std::abs(a[c] - b[c]) / scale);
    }
    return largest;
}

std::vector<double> in_parts(const fine::MaterialLaw& law, std::vector<double> state, const Mandel& strain, int parts) {
    for (int part = 0; part < parts; ++part) state = update_point(law, state, strain / parts).state;
    return state;
}

TEST(ExactFlow, IsTheLimitOfManyRadialReturns) {
    for (const double isotropic : {0.0, 1000.0, 50e3}) {
        const Laws laws(isotropic);
        const std::vector<double> once = update_point(*laws.exact, strained(laws), turning).state;
        std::vector<double> errors;
        for (const int parts : {200, 400, 800})
            errors.push_back(difference(in_parts(*laws.radial, strained(laws), turning, parts), once));
        EXPECT_NEAR(errors[0] / errors[1], 2.0, 0.02) << isotropic;
        EXPECT_NEAR(errors[1] / errors[2], 2.0, 0.02) << isotropic;
        EXPECT_LT(errors[2], 2e-3);
    }
}

// What is left is the error of the one quadrature: it grows with the hardening of the surface.
TEST(ExactFlow, HalvesMakeTheWhole) {
    const std::vector<std::pair<double, double>> bounds{{0.0, 1e-11}, {1000.0, 1e-8}, {50e3, 1e-5}};
    for (const auto& [isotropic, bound] : bounds) {
        const Laws laws(isotropic);
        for (const double size : {0.3, 1.0, 20.0}) {
            const std::vector<double> once = update_point(*laws.exact, strained(laws), size * turning).state;
            EXPECT_LT(difference(in_parts(*laws.exact, strained(laws), size * turning, 2), once), bound * size)
                << isotropic << " " << size;
        }
    }
}

struct MatrixPair {
    MandelMatrix derivative, tangent;
};

MatrixPair derivative_and_tangent(const std::vector<double>& state, const Mandel& increment) {
    const double h = 1e-8;
    MatrixPair result;
    for (int j = 0; j < 4; ++j) {
        const Mandel step = h * Mandel::Unit(j);
        result.derivative.col(j) = (update_point(*steel.exact, state, increment + step).stress() -
                                    update_point(*steel.exact, state, increment - step).stress()) /
                                   (2.0 * h);
    }
    result.tangent = update_point(*steel.exact, state, increment).tangent;
    return result;
}

TEST(ExactFlow, TangentIsTheSymmetricPartOfTheDerivative) {
    const auto [derivative, tangent] = derivative_and_tangent(strained(), turning);
    EXPECT_EQ(tangent, tangent.transpose());
    EXPECT_LT((tangent - 0.5 * (derivative + derivative.transpose())).norm(), 1e-6 * derivative.norm());
}

TEST(ExactFlow, WithoutATurnNothingIsMissingFromIt) {
    const auto [derivative, tangent] = derivative_and_tangent(virgin(), turning);
    EXPECT_LT((tangent - derivative).norm(), 1e-6 * derivative.norm());
}

TEST(ExactFlow, ElasticIncrementsAreAsBefore) {
    const Mandel small{1e-5, 0.0, 0.0, -1e-5};
    const PointUpdate once = update_point(*steel.exact, strained(), -small),
                      same = update_point(*steel.radial, strained(), -small);
    EXPECT_EQ(once.state, same.state);
    EXPECT_EQ(once.tangent, same.tangent);
}

}  // namespace
}  // namespace stria::test
