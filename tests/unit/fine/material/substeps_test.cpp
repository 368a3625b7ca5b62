// A strain increment taken in parts at points that flow: the result is that of the parts one after the other, the
// tangent the symmetric part of its derivative.
#include <gtest/gtest.h>

#include "tests/support/material_point.hpp"

#include "common/index.hpp"

namespace stria::test {
namespace {

constexpr int parts = 8;

MaterialSection mixed() {
    MaterialSection material;
    material.young = 200e3;
    material.poisson = 0.3;
    material.yield_stress = 350.0;
    material.isotropic.modulus = 1000.0;
    material.kinematic = {{3000.0, 0.0}, {20000.0, 0.0}};
    return material;
}

const auto whole = fine::make_material_law(mixed(), PlaneState::Strain);
const auto in_parts = fine::make_material_law(mixed(), PlaneState::Strain, parts);

std::vector<double> strained() {
    const std::vector<double> virgin(at(whole->state_size()), 0.0);
    return update_point(*whole, virgin, {1e-3, -3e-3, 0.0, 1e-3}).state;
}

struct MatrixPair {
    MandelMatrix derivative, tangent;
};

const Mandel turning{2e-3, 1e-3, 0.0, -3e-3};

TEST(Substeps, AreUpdatesOneAfterTheOther) {
    std::vector<double> state = strained();
    for (int part = 0; part < parts; ++part) state = update_point(*whole, state, turning / parts).state;
    const PointUpdate once = update_point(*in_parts, strained(), turning);
    EXPECT_TRUE(once.yields);
    for (std::size_t c = 0; c < state.size(); ++c) {
        if (c == at(fine::state::work)) continue;  // by the trapezoid rule of each
        EXPECT_NEAR(once.state[c], state[c], 1e-11 * (1.0 + std::abs(state[c]))) << c;
    }
}

MatrixPair derivative_and_tangent(const std::vector<double>& state, const Mandel& increment) {
    const double h = 1e-8;
    MatrixPair result;
    for (int j = 0; j < 4; ++j) {
        const Mandel step = h * Mandel::Unit(j);
        result.derivative.col(j) = (update_point(*in_parts, state, increment + step).stress() -
                                    update_point(*in_parts, state, increment - step).stress()) /
                                   (2.0 * h);
    }
    result.tangent = update_point(*in_parts, state, increment).tangent;
    return result;
}

TEST(Substeps, TangentIsTheSymmetricPartOfTheDerivative) {
    const auto [derivative, tangent] = derivative_and_tangent(strained(), turning);
    EXPECT_EQ(tangent, tangent.transpose());
    EXPECT_LT((tangent - 0.5 * (derivative + derivative.transpose())).norm(), 1e-6 * derivative.norm());
}

TEST(Substeps, WithoutATurnNothingIsMissingFromIt) {
    const std::vector<double> virgin(at(whole->state_size()), 0.0);
    const auto [derivative, tangent] = derivative_and_tangent(virgin, turning);
    EXPECT_LT((tangent - derivative).norm(), 1e-6 * derivative.norm());
}

TEST(Substeps, ElasticIncrementsAreAsBefore) {
    const Mandel small{1e-5, 0.0, 0.0, -1e-5};
    const PointUpdate once = update_point(*in_parts, strained(), -small),
                      same = update_point(*whole, strained(), -small);
    EXPECT_EQ(once.state, same.state);
    EXPECT_EQ(once.tangent, same.tangent);
}

}  // namespace
}  // namespace stria::test
