// Contact of the faces: the work of a pressure, the semismooth equations in both statuses, and cycling.
#include "fine/contact/contact_interface.hpp"

#include <gtest/gtest.h>

#include <Eigen/SVD>
#include <algorithm>

#include "common/index.hpp"
#include "tests/support/plates.hpp"

namespace stria::test {
namespace {

using fine::ContactInterface;

constexpr double stiffness = 1000.0;

/// A crack through the whole plate, horizontal unless `right` differs from `left`.
struct Cut {
    explicit Cut(double left = 2.4, double right = 2.4, double notch = 0.0)
        : from(0.0, left), to(8.0, right), input(plate_case({from, to})), mesh(plate_mesh(8, 5, input)) {
        input.cracks[0].notch = notch;
    }
    [[nodiscard]] ContactInterface contact() const { return {mesh, {}, input.cracks, 2, stiffness}; }
    [[nodiscard]] Eigen::VectorXd opened(const Field& above) const {
        return two_sided(mesh, from, to, above, [](const Vec2&) { return Vec2::Zero().eval(); });
    }

    Vec2 from, to;
    Case input;
    EnrichedMesh mesh;
};

TEST(ContactInterface, ConstantPressureDoesTheWorkOfTheOpening) {
    for (const auto& [left, right] : {std::pair{2.4, 2.4}, {1.3, 4.2}, {4.1, 0.8}, {2.0, 2.0}}) {
        const Cut cut(left, right);
        const ContactInterface contact = cut.contact();
        const auto above = [](const Vec2& x) { return Vec2(0.1 + 0.2 * x.x(), 0.3 - 0.05 * x.x() + 0.1 * x.y()); };
        const Eigen::VectorXd u = cut.opened(above);
        const Vec2 along = cut.to - cut.from,
                   normal(-along.y(), along.x());  // a linear opening: its middle times the length
        const double work = 7.0 * above(0.5 * (cut.from + cut.to)).dot(normal);
        const Eigen::VectorXd pressure = Eigen::VectorXd::Constant(contact.multipliers(), 7.0);
        Eigen::VectorXd force = Eigen::VectorXd::Zero(cut.mesh.unknowns);
        contact.add_force(pressure, force);
        EXPECT_NEAR(-force.dot(u), work, 1e-12 * std::abs(work));
    }
}

TEST(ContactInterface, ANotchIsFree) {
    const Cut cut(2.4, 2.4, 3.0);
    const ContactInterface contact = cut.contact();
    Eigen::VectorXd force = Eigen::VectorXd::Zero(cut.mesh.unknowns);
    contact.add_force(Eigen::VectorXd::Ones(contact.multipliers()), force);
    const Eigen::VectorXd lifted = cut.opened([](const Vec2&) { return Vec2(0.0, 1.0); });
    EXPECT_LT(-force.dot(lifted), 5.5);  // mm: no interface element is split, so up to one is lost
    EXPECT_GT(-force.dot(lifted), 4.4);
}

TEST(ContactInterface, AUniformGapIsSeenByEveryMultiplier) {
    const Cut cut(1.3, 4.2);
    const Vec2 normal = Vec2(1.3 - 4.2, 8.0).normalized();
    const Eigen::VectorXd gaps = cut.contact().gaps(cut.opened([&](const Vec2&) { return 0.25 * normal; }));
    EXPECT_LT((gaps.array() - 0.25).abs().maxCoeff(), 1e-13);
}

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
        const Eigen::VectorXd all = contact.gaps(u), some = contact.gaps_that_matter(u, no_pressure, work);
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
    (void)contact.gaps_that_matter(wedge(0.0), Eigen::VectorXd::Ones(contact.multipliers()), work);
    EXPECT_EQ(work.gaps_evaluated - before.gaps_evaluated, contact.multipliers());
}

TEST(ContactInterface, EveryMultiplierHasAJumpOfItsOwn) {  // or a pressure would do no work
    for (const auto& [left, right] : {std::pair{2.4, 2.4}, {1.3, 4.2}, {4.1, 0.8}, {2.0, 2.0}, {2.001, 3.999}}) {
        const Eigen::MatrixXd B = Cut(left, right).contact().operator_B();
        EXPECT_GT(Eigen::JacobiSVD<Eigen::MatrixXd>(B).singularValues().tail<1>()[0], 0.1) << left << ' ' << right;
    }
}

/// Random pressures and gaps with statuses chosen for them: about half are closed.
struct Iterate {
    explicit Iterate(const Cut& cut) : contact(cut.contact()) {
        u = random_vector(cut.mesh.unknowns, 1e-3, 1);
        pressure = random_vector(contact.multipliers(), 0.1, 2);
        contact.choose_statuses(pressure, contact.gaps(u));
    }
    [[nodiscard]] Eigen::VectorXd right_hand_side() const { return contact.right_hand_side(pressure, contact.gaps(u)); }

    ContactInterface contact;
    Eigen::VectorXd u, pressure;
};

TEST(ContactInterface, RowsAreTheDerivativeOfTheirRightHandSide) {
    const Cut cut(1.3, 4.2);
    Iterate now(cut);
    const Eigen::VectorXd before = now.right_hand_side();
    const Eigen::VectorXd du = random_vector(now.u.size(), 1e-4, 3), dp = random_vector(now.pressure.size(), 1e-2, 4);
    Eigen::VectorXd predicted = now.contact.open_diagonal().cwiseProduct(dp);
    const Eigen::VectorXd closing = -(now.contact.operator_B() * du);
    for (Eigen::Index k = 0; k < dp.size(); ++k)
        if (now.contact.statuses()[at(k)] != 0) predicted[k] = closing[k];
    now.u += du;
    now.pressure += dp;
    const Eigen::VectorXd difference = before - now.right_hand_side();  // the statuses stay
    EXPECT_LT((predicted - difference).norm(), 1e-12 * difference.norm());
    EXPECT_GT(std::ranges::count(now.contact.statuses(), 0), 0);
    EXPECT_GT(std::ranges::count(now.contact.statuses(), 1), 0);
}

TEST(ContactInterface, StatusesAreTheBranchesOfTheComplementarityEquation) {
    const Cut cut;
    const Iterate now(cut);
    const Eigen::VectorXd gap = now.contact.gaps(now.u);
    const Eigen::VectorXd lifted = cut.opened([](const Vec2&) { return Vec2(0.0, 1.0); });
    const Eigen::VectorXd weight = now.contact.operator_B() * lifted;  // mm
    double largest = 0.0;
    for (Eigen::Index k = 0; k < gap.size(); ++k) {
        const double c = 0.1 * stiffness / weight[k];
        const auto equation = [&](double p, double g) { return fine::UnilateralContact::residual(p, g, c); };
        constexpr double h = 1e-7;
        const double by_pressure =
            (equation(now.pressure[k] + h, gap[k]) - equation(now.pressure[k] - h, gap[k])) / (2 * h);
        const double by_gap = (equation(now.pressure[k], gap[k] + h) - equation(now.pressure[k], gap[k] - h)) / (2 * h);
        const bool closed = now.contact.statuses()[at(k)] != 0;
        EXPECT_NEAR(by_pressure, closed ? 0.0 : 1.0, 1e-6);
        EXPECT_NEAR(by_gap, closed ? c : 0.0, 1e-4);
        largest = std::max(largest, weight[k] * std::abs(equation(now.pressure[k], gap[k])));
        EXPECT_NEAR(now.right_hand_side()[k], weight[k] / c * equation(now.pressure[k], gap[k]), 1e-14);
    }
    EXPECT_NEAR(now.contact.residual(now.pressure, gap), largest, 1e-12);
}

TEST(ContactInterface, ResidualVanishesExactlyWhereTheConditionsHold) {
    const Cut cut;
    const ContactInterface contact = cut.contact();
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(contact.multipliers()), one = Eigen::VectorXd::Ones(zero.size());
    EXPECT_EQ(contact.residual(zero, one), 0.0);   // open
    EXPECT_EQ(contact.residual(one, zero), 0.0);   // closed
    EXPECT_EQ(contact.residual(zero, zero), 0.0);  // touching
    EXPECT_GT(contact.residual(one, one), 0.0);    // pressure across a gap
    EXPECT_GT(contact.residual(zero, -one), 0.0);  // penetration
    EXPECT_GT(contact.residual(-one, zero), 0.0);  // suction
}

TEST(ContactInterface, WhereStatusesComeBackOneFlipsAtATime) {
    const Cut cut;
    ContactInterface contact = cut.contact();
    contact.begin_increment();
    const Eigen::VectorXd gap = Eigen::VectorXd::Zero(contact.multipliers());
    Eigen::VectorXd closed = Eigen::VectorXd::Ones(gap.size()), open = -closed;
    closed[2] = 3.0;  // the worst
    open[1] = -5.0;
    for (const Eigen::VectorXd& pressure : {closed, open, closed}) contact.choose_statuses(pressure, gap);
    EXPECT_EQ(contact.status_changes(), 1);
    EXPECT_EQ(std::ranges::count(contact.statuses(), 1), 1);
    EXPECT_EQ(contact.statuses()[2], 1);
    contact.begin_increment();
    contact.choose_statuses(closed, gap);
    EXPECT_EQ(std::ranges::count(contact.statuses(), 1), gap.size());
}

}  // namespace
}  // namespace stria::test
