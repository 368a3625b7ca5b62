// The law of contact and friction at one multiplier: where its residuals vanish, their derivatives on each branch, and
// at the kinks between them.
#include "fine/contact/contact_law.hpp"

#include <gtest/gtest.h>

#include <array>

namespace stria::fine {
namespace {

constexpr double mu = 0.3, c = 40.0;
constexpr CoulombContact law{mu, c};

TEST(ContactLaw, ResidualsVanishExactlyWhereTheConditionsHold) {
    const auto holds = [](const FaceState& s) {
        return law.pressure_residual(s) == 0.0 && law.shear_residual(s) == 0.0;
    };
    EXPECT_TRUE(holds({0.0, 0.0, 0.5, 0.1}));    // open: slides without traction
    EXPECT_TRUE(holds({2.0, 0.3, 0.0, 0.0}));    // sticks
    EXPECT_TRUE(holds({2.0, 0.6, 0.0, 0.1}));    // slides on
    EXPECT_TRUE(holds({2.0, -0.6, 0.0, -0.1}));  // slides back
    EXPECT_FALSE(holds({2.0, 0.7, 0.0, 0.0}));   // beyond the cone
    EXPECT_FALSE(holds({2.0, 0.6, 0.0, -0.1}));  // along a shear that drives it
    EXPECT_FALSE(holds({2.0, 0.3, 0.0, 0.01}));  // slides inside the cone
    EXPECT_FALSE(holds({0.0, 0.1, 0.5, 0.0}));   // shear across a gap
}

struct Branch {
    const char* name;
    FaceState state;
    FaceStatus status;
    // Of the residual of the shear, by pressure, shear, gap, slip.
    std::array<double, 4> derivative;
};

class Branches : public testing::TestWithParam<Branch> {};

double shear_residual_at(FaceState s, int variable, double step) {
    double* const variables[] = {&s.pressure, &s.shear, &s.gap, &s.slip};
    *variables[variable] += step;
    return law.shear_residual(s);
}

TEST_P(Branches, DerivativesAreThoseOfTheBranch) {
    const Branch& branch = GetParam();
    EXPECT_EQ(law.status(branch.state), branch.status);
    constexpr double h = 1e-7;
    for (int variable = 0; variable < 4; ++variable) {
        const double difference =
            (shear_residual_at(branch.state, variable, h) - shear_residual_at(branch.state, variable, -h)) / (2.0 * h);
        EXPECT_NEAR(difference, branch.derivative[static_cast<std::size_t>(variable)], 1e-6) << variable;
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, Branches,
    testing::Values(Branch{"open", {0.5, 0.2, 0.1, 0.3}, FaceStatus::Open, {0.0, 1.0, 0.0, 0.0}},
                    Branch{"stick", {2.0, 0.2, 0.001, 0.002}, FaceStatus::Stick, {0.0, 0.0, 0.0, -c}},
                    Branch{"forward", {2.0, 0.5, 0.001, 0.02}, FaceStatus::SlipForward, {-mu, 1.0, mu* c, 0.0}},
                    Branch{"back", {2.0, -0.5, 0.001, -0.02}, FaceStatus::SlipBack, {mu, 1.0, -mu* c, 0.0}}),
    [](const auto& test) { return test.param.name; });

// On either side of the edge of the cone, and where the cone opens, one-sided differences are those of the branches.
TEST(ContactLaw, AtAKinkEitherSideIsABranch) {
    const FaceState edge{2.0, 0.6, 0.0, 0.0};
    constexpr double h = 1e-7;
    EXPECT_NEAR((shear_residual_at(edge, 3, h) - law.shear_residual(edge)) / h, 0.0, 1e-6);
    EXPECT_NEAR((law.shear_residual(edge) - shear_residual_at(edge, 3, -h)) / h, -c, 1e-6);
    const FaceState touching{0.0, 0.0, 0.0, 0.01};
    EXPECT_NEAR((shear_residual_at(touching, 0, h) - law.shear_residual(touching)) / h, -mu, 1e-6);
    EXPECT_NEAR((law.shear_residual(touching) - shear_residual_at(touching, 0, -h)) / h, 0.0, 1e-6);
    EXPECT_EQ(law.status(edge), FaceStatus::Stick);
    EXPECT_EQ(law.status(touching), FaceStatus::Open);
}

TEST(ContactLaw, WithoutFrictionNothingSlides) {
    constexpr CoulombContact smooth{0.0, c};
    EXPECT_EQ(smooth.status({2.0, 0.0, 0.0, 5.0}), FaceStatus::Stick);
    EXPECT_EQ(smooth.shear_residual({2.0, 0.0, 0.0, 5.0}), 0.0);
}

TEST(ContactLaw, ViolationIsWhatIsBeyondTheBranch) {
    EXPECT_DOUBLE_EQ(law.violation({2.0, 0.5, 0.0, 0.02}, FaceStatus::Stick), 0.5 + c * 0.02 - mu * 2.0);
    EXPECT_DOUBLE_EQ(law.violation({2.0, 0.5, 0.0, 0.0}, FaceStatus::Open), 2.0);
    EXPECT_DOUBLE_EQ(law.violation({2.0, 0.5, 0.1, 0.0}, FaceStatus::Stick), 2.0);
}

// From the bound it slides at once; from elsewhere the later, the farther the shear is from the side that brakes.
TEST(ContactLaw, SlipBeginsWhereTheShearComesToItsBoundAsThePressureFalls) {
    const auto begins = [](double shear, double slip) { return law.slides_from({8.0, shear, 0.0, slip}, 2.0); };
    EXPECT_DOUBLE_EQ(begins(mu * 8.0, 0.1), 8.0);
    EXPECT_DOUBLE_EQ(begins(-mu * 8.0, -0.1), 8.0);
    EXPECT_DOUBLE_EQ(begins(0.0, 0.1), 5.0);
    EXPECT_DOUBLE_EQ(begins(mu * 8.0, -0.1), 2.0);
    EXPECT_EQ(law.slides_from({2.0, 0.0, 0.0, 0.1}, 8.0), 2.0);  // the pressure grows
    EXPECT_DOUBLE_EQ(law.pressure_times_slip({8.0, 0.0, 0.0, -0.1}, 2.0), 3.5 * 0.1);
}

TEST(ContactLaw, OnAStraightWayFacesThatCloseMeetWhereItEnds) {
    for (const double unit : {1.0, 1e-9}) {  // whichever part of it the increments took
        const auto meet = [=](double gap, const FaceJumps& last, const FaceJumps& before) {
            const auto in_units = [=](const FaceJumps& of) { return FaceJumps{unit * of.gap, unit * of.slip}; };
            return slip_until_met(unit * gap, in_units(last), in_units(before)) / unit;
        };
        EXPECT_DOUBLE_EQ(meet(2.0, {-2.0, 1.0}, {-2.0, 1.0}), 1.0);
        EXPECT_DOUBLE_EQ(meet(2.0, {-2.0, -1.0}, {-2.0, -1.0}), -1.0);
        EXPECT_DOUBLE_EQ(meet(1.0, {-2.0, 1.0}, {-1.0, 0.5}), 0.5);
        EXPECT_DOUBLE_EQ(meet(2.0, {-2.0, 1.0}, {-4.0, 2.0}), 1.0);
        EXPECT_DOUBLE_EQ(meet(2.0, {-2.0, 1.0}, {0.0, 0.0}), 1.0);  // from rest
        EXPECT_DOUBLE_EQ(meet(2.0, {-2.0, 1.0}, {2.0, -1.0}), 1.0);
    }
}

// g = 9 - t^2 and a slip of t or of t^2 / 2 + t, from t = 2: the chord says 5/3 and 25/6 instead.
TEST(ContactLaw, FacesThatCloseFasterAndFasterMeetOnTheParabola) {
    EXPECT_DOUBLE_EQ(slip_until_met(5.0, {-3.0, 1.0}, {-1.0, 1.0}), 1.0);
    EXPECT_DOUBLE_EQ(slip_until_met(5.0, {-3.0, 2.5}, {-1.0, 1.5}), 3.5);
    EXPECT_DOUBLE_EQ(slip_until_met(1.25, {-1.0, 1.0}, {1.0, 1.0}), 0.5);  // they have just turned
}

TEST(ContactLaw, WhereFacesWillMeetIsNotSaidOfWhatDoesNotBringThemTogether) {
    EXPECT_EQ(slip_until_met(2.0, {1.0, 1.0}, {-1.0, 1.0}), 0.0);
    EXPECT_EQ(slip_until_met(2.0, {0.0, 1.0}, {-1.0, 1.0}), 0.0);
    EXPECT_EQ(slip_until_met(0.0, {-1.0, 1.0}, {-1.0, 1.0}), 0.0);
    EXPECT_DOUBLE_EQ(slip_until_met(8.0, {-2.0, 1.0}, {-2.0, 1.0}), 1.0 / 16.0);  // 4 increments away
    EXPECT_DOUBLE_EQ(slip_until_met(8.0, {-2.0, 1.0}, {-2.0, 1.0}, 2.0), 0.5);    // 2 of the next
    // Of gaps that stand still rounding says which way they went.
    for (const double rounding : {-1e-15, 1e-15})
        for (const double before : {0.0, -1e-15, 1e-15})
            EXPECT_NEAR(slip_until_met(8.0, {rounding, 1.0}, {before, 0.0}), 0.0, 1e-7);
    EXPECT_NEAR(slip_until_met(0.125, {1e-15, 1.0}, {1.0, 1.0}), slip_until_met(0.125, {-1e-15, 1.0}, {1.0, 1.0}),
                1e-14);
}

// At a load of zero rounding says whether faces part or slide without a pressure, and of which sign a pressure is.
TEST(ContactLaw, WhatSlipDissipatesDoesNotLeap) {
    for (const double shear : {-mu * 8.0, -1.0, 0.0, 1.0, mu * 8.0}) {
        const FaceState parted{8.0, shear, 1e-17, 0.1};
        EXPECT_NEAR(law.pressure_times_slip_until_open(parted), law.pressure_times_slip(parted, 0.0), 1e-12);
        EXPECT_NEAR(law.pressure_times_slip(parted, 1e-16), law.pressure_times_slip(parted, -1e-16), 1e-12);
        const double without = law.pressure_times_slip({0.0, 0.0, 0.0, 0.1}, 8.0);
        EXPECT_NEAR(law.pressure_times_slip({1e-14, 1e-16 * shear, 0.0, 0.1}, 8.0), without, 1e-12);
    }
    EXPECT_DOUBLE_EQ(law.pressure_times_slip_until_open({8.0, mu * 8.0, 0.2, 0.1}), 0.25 * 4.0 * 0.1);  // half the way
    EXPECT_EQ(law.pressure_times_slip_until_open({-1e-15, 0.0, 0.2, 0.1}), 0.0);
}

}  // namespace
}  // namespace stria::fine
