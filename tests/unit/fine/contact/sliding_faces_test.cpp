// Faces with friction: which of them slide, what tells it behind a tip, and what sliding dissipates.
#include "fine/contact/contact_interface.hpp"

#include <gtest/gtest.h>

#include <Eigen/SVD>
#include <cmath>

#include "common/index.hpp"
#include "tests/support/cut_plate.hpp"

namespace stria::test {
namespace {

using fine::FaceStatus;

// A trial often stands where faces meet or part, as nearly as numbers can: of what touches there rounding decides, and
// with it would whether the tip slides.
TEST(ContactInterface, FacesThatHardlyTouchNeitherStickNorSlide) {
    const Cut cut(2.4, 2.4, 0.0, 0.4);
    ContactInterface contact = cut.contact();
    contact.settle(Eigen::VectorXd::Zero(cut.mesh.unknowns));
    Jumps jumps = contact.jumps(Eigen::VectorXd::Zero(cut.mesh.unknowns));
    jumps.slip.setConstant(1e-3);
    for (const double pressure : {1e-13, 1.0}) {
        Eigen::VectorXd traction = Eigen::VectorXd::Zero(contact.tractions());
        traction.setConstant(pressure);  // as much shear: friction of 0.4 slides
        contact.choose_statuses(traction, jumps);
        const auto nearest = contact.nearest_behind({.crack = 0, .tip = 8.0, .from = 0.1}, traction, jumps, 1e-9);
        const bool presses = pressure == 1.0;
        EXPECT_EQ(nearest.slides(), presses);
        EXPECT_EQ(nearest.closed > 0, presses);
        EXPECT_EQ(std::isfinite(nearest.behind), presses);
    }
}

// Pressed behind s = 2 mm, the farther half sliding back: whoever is nearest to the tip at s = 8 mm, and closed, says
// whether it slides.
TEST(ContactInterface, SlipBehindATipIsThatOfTheNearestContact) {
    const Cut cut(2.4, 2.4, 0.0, 0.4);
    ContactInterface contact = cut.contact();
    contact.settle(Eigen::VectorXd::Zero(cut.mesh.unknowns));
    Jumps jumps = contact.jumps(Eigen::VectorXd::Zero(cut.mesh.unknowns));
    const auto& keys = contact.operators().keys();
    Eigen::VectorXd traction = Eigen::VectorXd::Zero(contact.tractions());
    for (int k = 0; k < contact.multipliers(); ++k) {
        traction[k] = keys[at(k)].s < 6.0 ? 10.0 : -1.0;
        traction[contact.shear_of(k)] = keys[at(k)].s < 4.0 ? -4.1 : 3.8;
        jumps.slip[k] = keys[at(k)].s < 4.0 ? -1e-3 : 1e-3;
    }
    contact.choose_statuses(traction, jumps);
    const auto behind = [&](const fine::FacesBehind& part) {
        return contact.nearest_behind(part, traction, jumps, 1e-6);
    };
    for (const auto& [distance, slides] : {std::pair{0.1, false}, {3.0, false}, {4.1, true}, {9.0, false}})
        EXPECT_EQ(behind({.crack = 0, .tip = 8.0, .from = distance}).slides(), slides) << distance;
    EXPECT_FALSE(contact.nearest_behind({.crack = 0, .tip = 8.0, .from = 4.1}, traction, jumps, 1e-2).slides());
    const auto none = behind({.crack = 1, .tip = 8.0, .from = 4.1});
    EXPECT_FALSE(none.slides());
    EXPECT_TRUE(std::isinf(none.behind));
    EXPECT_FALSE(behind({.crack = 0, .tip = 8.0, .from = 4.1, .to = 4.2}).slides());
    const auto sticks = behind({.crack = 0, .tip = 8.0, .from = 0.1}),
               all_slide = behind({.crack = 0, .tip = 8.0, .from = 4.1});
    EXPECT_EQ(sticks.pressure, 10.0);
    EXPECT_DOUBLE_EQ(sticks.excess, 3.8 - 0.4 * 10.0);
    EXPECT_EQ(sticks.sliding, all_slide.closed);
    EXPECT_EQ(all_slide.sliding, all_slide.closed);
    EXPECT_GT(sticks.closed, all_slide.closed);
}

// A block that slides under a pressure that grows from 2 to 6 MPa: the mean bound times the slip.
TEST(ContactInterface, SlidingDissipatesTheMeanBoundTimesTheSlip) {
    const Cut cut(2.4, 2.4, 0.0, 0.4);
    ContactInterface contact = cut.contact();
    contact.settle(Eigen::VectorXd::Zero(cut.mesh.unknowns));
    const auto all = [&](double p, double tau) {
        Eigen::VectorXd traction(contact.tractions());
        traction << Eigen::VectorXd::Constant(contact.multipliers(), p),
            Eigen::VectorXd::Constant(contact.multipliers(), tau);
        return traction;
    };
    const Jumps slipped = contact.jumps(cut.opened([](const Vec2&) { return Vec2(-0.01, 0.0); }));
    contact.choose_statuses(all(6.0, -2.4), slipped);
    EXPECT_NEAR(contact.dissipated(all(2.0, -0.8), all(6.0, -2.4), slipped), 0.4 * 4.0 * 0.01 * 8.0, 1e-13);
    contact.choose_statuses(all(6.0, 0.0), contact.jumps(Eigen::VectorXd::Zero(cut.mesh.unknowns)));
    EXPECT_EQ(contact.dissipated(all(2.0, 0.0), all(6.0, 0.0), slipped), 0.0);
}

// Pressed by 2 MPa and then 0.01 mm apart: a trapezoid sees a triangle of work on 8 mm, though nothing is done.
TEST(ContactInterface, TrapezoidsSeeWorkWhereFacesPartOrMeet) {
    const Cut cut;
    const ContactInterface interface = cut.contact();
    const fine::FaceOperators& contact = interface.operators();
    const Eigen::VectorXd touching = Eigen::VectorXd::Zero(cut.mesh.unknowns),
                          apart = cut.opened([](const Vec2&) { return Vec2(0.0, 0.01); }),
                          pressed = Eigen::VectorXd::Constant(contact.tractions(), 2.0),
                          free = Eigen::VectorXd::Zero(contact.tractions());
    EXPECT_NEAR(contact.work_by_trapezoid({touching, pressed}, {apart, free}), 0.5 * 2.0 * 0.01 * 8.0, 1e-13);
    EXPECT_NEAR(contact.work_by_trapezoid({apart, free}, {touching, pressed}), -0.5 * 2.0 * 0.01 * 8.0, 1e-13);
    EXPECT_EQ(contact.work_by_trapezoid({touching, pressed}, {touching, 3.0 * pressed}), 0.0);
    EXPECT_EQ(contact.work_by_trapezoid({apart, free}, {2.0 * apart, free}), 0.0);
}

// Faces that stuck come free at a load of zero, on their way back: whether they part then or slide is rounding.
TEST(ContactInterface, FacesThatComeFreeDissipateTheSameWhetherTheyPartOrSlide) {
    const Cut cut(2.4, 2.4, 0.0, 0.4);
    ContactInterface contact = cut.contact();
    contact.settle(Eigen::VectorXd::Zero(cut.mesh.unknowns));
    Eigen::VectorXd before(contact.tractions());
    before << Eigen::VectorXd::Constant(contact.multipliers(), 2.0), Eigen::VectorXd::Zero(contact.multipliers());
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(contact.tractions());
    const auto dissipated = [&](double gap, FaceStatus status) {
        const Jumps jumps = contact.jumps(cut.opened([&](const Vec2&) { return Vec2(-0.01, gap); }));
        contact.choose_statuses(none, jumps);
        EXPECT_EQ(contact.statuses()[0], status);
        return contact.dissipated(before, none, jumps);
    };
    const double parted = dissipated(1e-14, FaceStatus::Open), slid = dissipated(-1e-14, FaceStatus::SlipBack);
    EXPECT_NEAR(slid, 0.4 * 0.5 * 1.0 * 0.01 * 8.0, 1e-12);
    EXPECT_NEAR(parted, slid, 1e-12);
}

}  // namespace
}  // namespace stria::test
