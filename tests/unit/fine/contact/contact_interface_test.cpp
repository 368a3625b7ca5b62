// Contact of the faces: the semismooth equations in both statuses, and cycling.
#include "fine/contact/contact_interface.hpp"

#include <gtest/gtest.h>

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <set>

#include "common/index.hpp"
#include "tests/support/cut_plate.hpp"

namespace stria::test {
namespace {

using fine::FaceStatus;

// Opened like a wedge: what closes by more and more touches where it is narrow, and is not looked at where it is wide.
TEST(ContactInterface, GapsThatCannotCloseAreNotLookedAt) {
    const Cut cut(1.3, 4.2);
    ContactInterface contact = cut.contact();
    const Vec2 normal = Vec2(1.3 - 4.2, 8.0).normalized();
    const auto wedge = [&](double closed_by) {
        return cut.opened([&, closed_by](const Vec2& x) { return ((0.01 + 0.1 * x.x() - closed_by) * normal).eval(); });
    };
    contact.settle(wedge(0.0));
    const Eigen::VectorXd no_pressure = Eigen::VectorXd::Zero(contact.multipliers());
    coupling::WorkCounts work;
    for (const double closed_by : {0.0, 0.005, 0.1, 0.3, 2.0}) {
        const Eigen::VectorXd u = wedge(closed_by);
        const Eigen::VectorXd all = contact.jumps(u).gap, some = contact.jumps_that_matter(u, no_pressure, work).gap;
        for (Eigen::Index k = 0; k < all.size(); ++k) {
            EXPECT_EQ(all[k] > 0.0, some[k] > 0.0) << closed_by << ' ' << k;
            EXPECT_LE(some[k], all[k] + 1e-15);
            EXPECT_TRUE(all[k] > 0.0 || some[k] == all[k]);
        }
        EXPECT_TRUE(closed_by > 0.0 || work.gaps_evaluated == 0);
    }
    EXPECT_GT(work.gaps_proven_open, contact.multipliers());
    EXPECT_GT(work.gaps_evaluated, contact.multipliers());
    EXPECT_EQ(work.gaps_proven_open + work.gaps_evaluated, 5 * contact.multipliers());
    const coupling::WorkCounts before = work;  // who bears or may pull is looked at, however wide
    (void)contact.jumps_that_matter(wedge(0.0), Eigen::VectorXd::Ones(contact.multipliers()), work);
    EXPECT_EQ(work.gaps_evaluated - before.gaps_evaluated, contact.multipliers());
}

/// Random tractions and jumps with statuses chosen for them: about half are closed.
struct Iterate {
    explicit Iterate(const Cut& cut) : contact(cut.contact()) {
        contact.settle(Eigen::VectorXd::Zero(cut.mesh.unknowns));
        u = random_vector(cut.mesh.unknowns, 1e-3, 1);
        traction = random_vector(contact.tractions(), 0.1, 2);
        contact.choose_statuses(traction, contact.jumps(u));
    }
    [[nodiscard]] Eigen::VectorXd right_hand_side() const {
        return contact.right_hand_side(traction, contact.jumps(u));
    }
    [[nodiscard]] auto count(FaceStatus status) const { return std::ranges::count(contact.statuses(), status); }

    ContactInterface contact;
    Eigen::VectorXd u, traction;
};

class EitherContact : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Friction, EitherContact, testing::Values(0.0, 0.4), [](const auto& test) {
    return test.param > 0.0 ? std::string("rough") : std::string("smooth");
});

TEST_P(EitherContact, RowsAreTheDerivativeOfTheirRightHandSide) {
    const Cut cut(1.3, 4.2, 0.0, GetParam());
    Iterate now(cut);
    const Eigen::VectorXd before = now.right_hand_side();
    const Eigen::VectorXd du = random_vector(now.u.size(), 1e-4, 3), dt = random_vector(now.traction.size(), 1e-2, 4);
    Eigen::VectorXd all(du.size() + dt.size()), predicted = Eigen::VectorXd::Zero(all.size());
    all << du, dt;
    for (int k = 0; k < now.contact.multipliers(); ++k) {
        const std::vector<int> unknowns = now.contact.unknowns_of(k, static_cast<int>(du.size()));
        const Eigen::MatrixXd matrix = now.contact.matrix_of(k);
        EXPECT_EQ(now.contact.slides(k), matrix != matrix.transpose());
        predicted(unknowns) += matrix * all(unknowns);
    }
    now.u += du;
    now.traction += dt;
    const Eigen::VectorXd difference = before - now.right_hand_side();  // the statuses stay
    EXPECT_LT((predicted.tail(dt.size()) - difference).norm(), 1e-12 * difference.norm());
    EXPECT_GT(now.count(FaceStatus::Open), 0);
    EXPECT_GT(now.count(FaceStatus::Stick), 0);
    EXPECT_EQ(now.count(FaceStatus::SlipForward) > 0, GetParam() > 0.0);
    EXPECT_EQ(now.count(FaceStatus::SlipBack) > 0, GetParam() > 0.0);
}

TEST_P(EitherContact, StatusesAreTheBranchesOfTheLaw) {
    const Cut cut(2.4, 2.4, 0.0, GetParam());
    const Iterate now(cut);
    const Jumps jumps = now.contact.jumps(now.u);
    const Eigen::VectorXd lifted = cut.opened([](const Vec2&) { return Vec2(0.0, 1.0); });
    const Eigen::VectorXd weight = now.contact.operators().operator_B() * lifted;  // mm
    double largest = 0.0;
    for (int k = 0; k < weight.size(); ++k) {
        const fine::CoulombContact law{GetParam(), 0.1 * contact_stiffness / weight[k]};
        const int shear = now.contact.shear_of(k);
        const fine::FaceState state{now.traction[k], shear < 0 ? 0.0 : now.traction[shear], jumps.gap[k],
                                    jumps.slip[k]};
        EXPECT_EQ(now.contact.statuses()[at(k)], law.status(state));
        largest = std::max(
            largest, weight[k] * std::max(std::abs(law.pressure_residual(state)), std::abs(law.shear_residual(state))));
    }
    EXPECT_NEAR(now.contact.residual(now.traction, jumps), largest, 1e-12);
}

TEST(ContactInterface, CleanTractionsAreOnTheirBranches) {
    const Cut cut(1.3, 4.2, 0.0, 0.4);
    const Iterate now(cut);
    Eigen::VectorXd traction = now.traction.cwiseAbs();
    now.contact.clean(traction);
    for (int k = 0; k < now.contact.multipliers(); ++k) {
        const double p = traction[k], tau = traction[now.contact.shear_of(k)];
        switch (now.contact.statuses()[at(k)]) {
        case FaceStatus::Open:
            EXPECT_EQ(p, 0.0);
            EXPECT_EQ(tau, 0.0);
            break;
        case FaceStatus::Stick:
            EXPECT_EQ(tau, std::abs(now.traction[now.contact.shear_of(k)]));
            break;
        case FaceStatus::SlipForward:
            EXPECT_EQ(tau, 0.4 * p);
            break;
        case FaceStatus::SlipBack:
            EXPECT_EQ(tau, -0.4 * p);
            break;
        }
    }
}

// New faces beside old ones that are pressed bear nothing yet and have no gap but rounding: its sign decides nothing.
TEST(ContactInterface, GapsThatAreRoundingLeaveFacesThatBearNothingAsTheyWere) {
    for (const auto& [left, right] : {std::pair{1.3, 4.2}, {2.4, 2.3}, {4.1, 0.8}}) {
        const Cut cut(left, right);
        ContactInterface contact = cut.contact();
        const Vec2 along = cut.to - cut.from;
        const Jumps jumps = contact.jumps(cut.opened([&](const Vec2&) -> Vec2 { return 0.01 * along; }));
        EXPECT_EQ(jumps.gap, Eigen::VectorXd::Zero(contact.multipliers()).eval());
        const Eigen::VectorXd none = Eigen::VectorXd::Zero(contact.tractions());
        contact.begin_increment();
        contact.choose_statuses(none, jumps);
        for (int k = 0; k < contact.multipliers(); ++k) EXPECT_EQ(contact.statuses()[at(k)], FaceStatus::Open) << k;
        contact.begin_touching();
        contact.begin_increment();
        contact.choose_statuses(none, jumps);
        for (int k = 0; k < contact.multipliers(); ++k) EXPECT_EQ(contact.statuses()[at(k)], FaceStatus::Stick) << k;
    }
}

TEST(ContactInterface, ResidualVanishesExactlyWhereTheConditionsHold) {
    const Cut cut;
    const ContactInterface contact = cut.contact();
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(contact.multipliers()), one = Eigen::VectorXd::Ones(zero.size());
    EXPECT_EQ(contact.residual(zero, {one, zero}), 0.0);   // open
    EXPECT_EQ(contact.residual(one, {zero, zero}), 0.0);   // closed
    EXPECT_EQ(contact.residual(zero, {zero, zero}), 0.0);  // touching
    EXPECT_GT(contact.residual(one, {one, zero}), 0.0);    // pressure across a gap
    EXPECT_GT(contact.residual(zero, {-one, zero}), 0.0);  // penetration
    EXPECT_GT(contact.residual(-one, {zero, zero}), 0.0);  // suction
}

// What only its faces hold does not float before anything is known of them.
TEST(ContactInterface, FacesThatWereNeverLoadedTouchUntilTheyPart) {
    const Cut cut;
    ContactInterface contact = cut.contact();
    const Eigen::VectorXd at_rest = Eigen::VectorXd::Zero(cut.mesh.unknowns),
                          none = Eigen::VectorXd::Zero(contact.tractions());
    const auto statuses_at = [&](const Eigen::VectorXd& u) {
        contact.begin_increment();
        contact.choose_statuses(none, contact.jumps(u));
        return std::set<FaceStatus>(contact.statuses().begin(), contact.statuses().end());
    };
    EXPECT_EQ(statuses_at(at_rest), std::set{FaceStatus::Open});  // as after a growth
    contact.begin_touching();
    EXPECT_EQ(statuses_at(at_rest), std::set{FaceStatus::Stick});
    EXPECT_EQ(statuses_at(cut.opened([](const Vec2&) { return Vec2(0.0, 1e-9); })), std::set{FaceStatus::Open});
}

// Pressures of before say nothing then: the first correction lets go of them, and faces that overlap touch.
TEST(ContactInterface, FacesThatBeginApartTouchWhereTheyOverlap) {
    const Cut cut;
    ContactInterface contact = cut.contact();
    contact.begin_touching();
    contact.begin_increment(true);
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(contact.multipliers()), one = Eigen::VectorXd::Ones(zero.size());
    contact.choose_statuses(one, {zero, zero});
    EXPECT_EQ(std::ranges::count(contact.statuses(), FaceStatus::Open), zero.size());
    EXPECT_EQ(contact.status_changes(), 0);
    Eigen::VectorXd gap = one;
    gap[1] = -1.0;
    contact.choose_statuses(zero, {gap, zero});
    EXPECT_EQ(contact.statuses()[1], FaceStatus::Stick);
    EXPECT_EQ(contact.status_changes(), 1);
    contact.begin_increment();
    contact.choose_statuses(one, {zero, zero});
    EXPECT_EQ(std::ranges::count(contact.statuses(), FaceStatus::Stick), zero.size());
}

TEST(ContactInterface, WhereStatusesComeBackOneFlipsAtATime) {
    const Cut cut;
    ContactInterface contact = cut.contact();
    contact.begin_increment();
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(contact.multipliers());
    const Jumps none{zero, zero};
    Eigen::VectorXd closed = Eigen::VectorXd::Ones(zero.size()), open = -closed;
    closed[2] = 3.0;  // the worst
    open[1] = -5.0;
    for (const Eigen::VectorXd& pressure : {closed, open, closed}) contact.choose_statuses(pressure, none);
    EXPECT_EQ(contact.status_changes(), 1);
    EXPECT_EQ(std::ranges::count(contact.statuses(), FaceStatus::Stick), 1);
    EXPECT_EQ(contact.statuses()[2], FaceStatus::Stick);
    contact.begin_increment();
    contact.choose_statuses(closed, none);
    EXPECT_EQ(std::ranges::count(contact.statuses(), FaceStatus::Stick), zero.size());
}

TEST(ContactInterface, WhereSlipsComeBackAllSticksOnceAndThenOneFlipsAtATime) {
    const Cut cut(2.4, 2.4, 0.0, 0.5);
    ContactInterface contact = cut.contact();
    const int m = contact.multipliers();
    const Eigen::VectorXd traction = Eigen::VectorXd::Ones(contact.tractions());
    const auto slid = [&](double by) {
        Eigen::VectorXd slip = Eigen::VectorXd::Constant(m, by);
        slip[0] *= 10.0;  // the worst
        contact.choose_statuses(traction, {Eigen::VectorXd::Zero(m), slip});
        return std::pair(contact.statuses()[0], contact.statuses()[at(m - 1)]);
    };
    const auto all = [](FaceStatus status) { return std::pair(status, status); };
    EXPECT_EQ(slid(1.0), all(FaceStatus::SlipForward));
    EXPECT_EQ(slid(-1.0), all(FaceStatus::SlipBack));
    EXPECT_EQ(slid(1.0), all(FaceStatus::Stick));
    EXPECT_EQ(slid(-1.0), all(FaceStatus::SlipBack));
    EXPECT_EQ(slid(1.0), all(FaceStatus::SlipForward));
    EXPECT_EQ(slid(-1.0), std::pair(FaceStatus::SlipBack, FaceStatus::SlipForward));
    slid(std::nan(""));  // the residual says that this is no state; until then one flips like any other
    EXPECT_EQ(contact.status_changes(), 1);
    EXPECT_EQ(std::ranges::count(contact.statuses(), FaceStatus::SlipBack), 2);
    contact.begin_increment();
    EXPECT_EQ(slid(1.0), all(FaceStatus::SlipForward));
}

}  // namespace
}  // namespace stria::test
