// What contact says of the faces behind a tip: above zero where they touch, and how far from it they are where not.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "common/index.hpp"
#include "tests/support/cut_plate.hpp"

namespace stria::test {
namespace {

/// A crack from s = 0 to 8 mm, whose tip is asked for what is behind 2 mm: at s up to 6.
class ContactBehind : public testing::Test {
protected:
    ContactBehind() { contact.settle(Eigen::VectorXd::Zero(cut.mesh.unknowns)); }

    [[nodiscard]] Eigen::VectorXd opening_to(double at_mouth, double at_tip) const {
        return cut.opened([=](const Vec2& x) { return Vec2(0.0, at_mouth + (at_tip - at_mouth) * x.x() / 8.0); });
    }
    [[nodiscard]] double behind(const Eigen::VectorXd& traction, const Eigen::VectorXd& u) const {
        return contact.contact_behind(part, traction, contact.jumps(u), u);
    }
    [[nodiscard]] Eigen::VectorXd along(double (*pressure)(double)) const {
        Eigen::VectorXd traction = Eigen::VectorXd::Zero(contact.tractions());
        for (int k = 0; k < contact.multipliers(); ++k) traction[k] = pressure(contact.operators().keys()[at(k)].s);
        return traction;
    }
    void choose(const Eigen::VectorXd& traction, const Eigen::VectorXd& u) {
        contact.choose_statuses(traction, contact.jumps(u));
    }
    /// E' / 10 over the length of a multiplier in the middle.
    static constexpr double c = 0.1 * contact_stiffness / 1.0;
    static constexpr double least = std::numeric_limits<double>::min();

    const Cut cut;
    ContactInterface contact = cut.contact();
    const fine::FacesBehind part{.crack = 0, .tip = 8.0, .from = 2.0};
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(contact.tractions()),
                          still = Eigen::VectorXd::Zero(cut.mesh.unknowns);
};

TEST_F(ContactBehind, IsTheLargestPressureOfFacesThatTouch) {
    const Eigen::VectorXd pressed = along([](double s) { return 1.0 + s; });
    choose(pressed, still);
    EXPECT_DOUBLE_EQ(behind(pressed, still), 7.0);
    EXPECT_EQ(behind(-pressed, still), least) << "the status decides the sign";
}

TEST_F(ContactBehind, IsTheSmallestGapOfFacesApart) {
    const Eigen::VectorXd apart = opening_to(0.18, 0.02);  // 0.06 mm at s = 6
    choose(none, apart);
    EXPECT_NEAR(behind(none, apart), -c * 0.06, 1e-12);
}

// Bounds are no wider than gaps, by whatever factor: a multiplier whose bound is the smallest need not have that gap.
TEST_F(ContactBehind, ReadsGapsWhereBoundsStandForThem) {
    const Eigen::VectorXd apart = opening_to(0.18, 0.02);
    choose(none, apart);
    Jumps bounds = contact.jumps(apart);
    for (int k = 0; k < contact.multipliers(); ++k)
        bounds.gap[k] *= contact.operators().keys()[at(k)].s < 3.0 ? 0.1 : 0.9;
    EXPECT_NEAR(contact.contact_behind(part, none, bounds, apart), -c * 0.06, 1e-12);
}

TEST_F(ContactBehind, IsBelowZeroWhereAllAreOpenWhateverTheirGaps) {
    choose(none, opening_to(0.1, 0.1));
    const Eigen::VectorXd overlap = opening_to(-0.1, -0.1);
    EXPECT_EQ(behind(none, overlap), -least);
}

TEST_F(ContactBehind, IsThePressureWhereSomeTouch) {
    const Eigen::VectorXd pressed = along([](double s) { return s < 3.0 ? 5.0 : 0.0; }),
                          apart = cut.opened([](const Vec2&x) { return Vec2(0.0, x.x() < 3.5 ? 0.0 : 0.1); });
    choose(pressed, apart);
    EXPECT_EQ(behind(pressed, apart), 5.0);
}

TEST_F(ContactBehind, IsNothingWhereThereAreNoFaces) {
    choose(none, still);
    EXPECT_EQ(contact.contact_behind({.crack = 1, .tip = 8.0, .from = 2.0}, none, contact.jumps(still), still),
              -std::numeric_limits<double>::infinity());
}

// |tau + c slip| is beyond the bound by c times the slip in excess of what the faces hold.
TEST(NearestContact, IsBeyondItsBoundByItsSlip) {
    const Cut cut(2.4, 2.4, 0.0, 0.4);
    ContactInterface contact = cut.contact();
    contact.settle(Eigen::VectorXd::Zero(cut.mesh.unknowns));
    Jumps jumps = contact.jumps(Eigen::VectorXd::Zero(cut.mesh.unknowns));
    jumps.slip.setConstant(1e-3);
    Eigen::VectorXd traction = Eigen::VectorXd::Constant(contact.tractions(), 10.0);
    traction.tail(contact.multipliers()).setConstant(4.0);
    contact.choose_statuses(traction, jumps);
    const auto nearest = contact.nearest_behind({.crack = 0, .tip = 8.0, .from = 2.0}, traction, jumps, 1e-9);
    EXPECT_NEAR(nearest.excess, 0.1 * contact_stiffness / 1.0 * 1e-3, 1e-12);
    EXPECT_NEAR(nearest.behind, 2.0, 1e-9);
}

}  // namespace
}  // namespace stria::test
