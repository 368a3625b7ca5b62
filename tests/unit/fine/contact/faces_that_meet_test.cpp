// Slip of faces that are apart and come to meet, or part.
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

TEST(ContactInterface, AUniformSlipIsSeenByEveryMultiplierAndHeldOnceSettled) {
    const Cut cut(1.3, 4.2, 0.0, 0.5);
    ContactInterface contact = cut.contact();
    contact.settle(Eigen::VectorXd::Zero(cut.mesh.unknowns));
    const Vec2 tangent = Vec2(8.0, 4.2 - 1.3).normalized();
    const Eigen::VectorXd u = cut.opened([&](const Vec2&) { return 0.25 * tangent; });
    EXPECT_LT((contact.jumps(u).slip.array() - 0.25).abs().maxCoeff(), 1e-13);
    EXPECT_LT(contact.jumps(u).gap.cwiseAbs().maxCoeff(), 1e-13);
    contact.settle(u);
    EXPECT_LT(contact.jumps(2.0 * u).slip.array().abs().maxCoeff() - 0.25, 1e-13);
    EXPECT_EQ(contact.jumps(u).slip.cwiseAbs().maxCoeff(), 0.0);
}

/// Faces that are 0.01 mm apart and go to meet after a slip of -0.005 mm more.
struct GoingToMeet {
    explicit GoingToMeet(const Cut& plate) : cut(plate), contact(plate.contact()) {
        contact.settle(at(0.0, 0.02));
        contact.choose_statuses(none(), contact.jumps(at(-0.005, 0.01)));
        contact.commit(at(-0.005, 0.01));
    }
    [[nodiscard]] Eigen::VectorXd at(double slip, double gap) const {
        return cut.opened([=](const Vec2&) { return Vec2(slip, gap); });
    }
    [[nodiscard]] Eigen::VectorXd none() const { return Eigen::VectorXd::Zero(contact.tractions()); }

    const Cut& cut;
    ContactInterface contact;
};

TEST(ContactInterface, SlipOfFacesApartCountsFromWhereTheyMeet) {
    const Cut cut(2.4, 2.4, 0.0, 0.5);
    GoingToMeet faces(cut);
    const auto off = [&](const Eigen::VectorXd& u, double slip) {
        coupling::WorkCounts work;
        const Eigen::VectorXd closed = Eigen::VectorXd::Ones(faces.contact.tractions());
        return std::max((faces.contact.jumps(u).slip.array() - slip).abs().maxCoeff(),
                        (faces.contact.jumps_that_matter(u, closed, work).slip.array() - slip).abs().maxCoeff());
    };
    EXPECT_LT(off(faces.at(-0.010, 0.0), 0.0), 1e-15);
    EXPECT_LT(off(faces.at(-0.013, 0.0), -0.003), 1e-15);
    ContactInterface resumed = cut.contact();
    resumed.restore(faces.contact.committed_statuses(), faces.contact.approach());
    resumed.settle(faces.at(-0.005, 0.01));
    EXPECT_EQ(resumed.jumps(faces.at(0.0, 0.0)).slip, faces.contact.jumps(faces.at(0.0, 0.0)).slip);
    const Eigen::VectorXd pressed = Eigen::VectorXd::Ones(faces.contact.tractions());
    faces.contact.choose_statuses(pressed, faces.contact.jumps(faces.at(-0.010, 0.0)));
    faces.contact.commit(faces.at(-0.010, 0.0));  // from now on they touch
    EXPECT_LT(off(faces.at(-0.013, 0.0), -0.003), 1e-15);
}

// Which way they come back is not known.
TEST(ContactInterface, SlipOfFacesThatOpenCountsFromWhereTheyAre) {
    const Cut cut(2.4, 2.4, 0.0, 0.5);
    GoingToMeet faces(cut);
    faces.contact.choose_statuses(faces.none(), faces.contact.jumps(faces.at(-0.002, 0.02)));
    faces.contact.commit(faces.at(-0.002, 0.02));
    EXPECT_EQ(faces.contact.approach().until_met, Eigen::VectorXd::Zero(faces.contact.multipliers()).eval());
    EXPECT_LT((faces.contact.jumps(faces.at(-0.005, 0.0)).slip.array() + 0.003).abs().maxCoeff(), 1e-15);
}

TEST(ContactInterface, AResumedOneForetellsTheNextMeetingAlike) {
    const Cut cut(2.4, 2.4, 0.0, 0.5);
    GoingToMeet faces(cut);
    ContactInterface resumed = cut.contact();
    resumed.restore(faces.contact.committed_statuses(), faces.contact.approach());
    resumed.settle(faces.at(-0.005, 0.01));
    for (ContactInterface* contact : {&faces.contact, &resumed}) {
        contact->choose_statuses(faces.none(), contact->jumps(faces.at(-0.009, 0.004)));
        contact->commit(faces.at(-0.009, 0.004));
    }
    EXPECT_GT(faces.contact.approach().until_met.cwiseAbs().minCoeff(), 1e-3);
    EXPECT_EQ(resumed.approach().until_met, faces.contact.approach().until_met);
}

TEST(ContactInterface, WhereTheLoadsTurnSlipOfFacesApartCountsFromWhereTheyAre) {
    const Cut cut(2.4, 2.4, 0.0, 0.5);
    GoingToMeet faces(cut);
    faces.contact.forget_approach();
    EXPECT_LT(faces.contact.jumps(faces.at(-0.005, 0.0)).slip.cwiseAbs().maxCoeff(), 1e-15);
}

// They meet, and slide on by 0.01 mm under a pressure that grows to 6 MPa.
TEST(ContactInterface, OnlyWhatFacesSlideAfterMeetingDissipates) {
    const Cut cut(2.4, 2.4, 0.0, 0.4);
    GoingToMeet faces(cut);
    const int m = faces.contact.multipliers();
    Eigen::VectorXd after(2 * m);
    after << Eigen::VectorXd::Constant(m, 6.0), Eigen::VectorXd::Constant(m, -2.4);
    const Jumps jumps = faces.contact.jumps(faces.at(-0.020, 0.0));
    faces.contact.choose_statuses(after, jumps);
    EXPECT_NEAR(faces.contact.dissipated(faces.none(), after, jumps), 0.4 * 3.0 * 0.01 * 8.0, 1e-13);
}

// Where they will meet is known before, so the rows have no more terms.
TEST(ContactInterface, RowsOfFacesThatMeetAreTheDerivativeOfTheirRightHandSide) {
    const Cut cut(2.4, 2.4, 0.0, 0.4);
    GoingToMeet faces(cut);
    const ContactInterface& contact = faces.contact;
    const int m = contact.multipliers();
    const Eigen::VectorXd u = faces.at(-0.012, -1e-4), traction = random_vector(2 * m, 0.1, 2);
    faces.contact.choose_statuses(traction, contact.jumps(u));
    const Eigen::VectorXd du = random_vector(u.size(), 1e-4, 3), dt = random_vector(2 * m, 1e-2, 4);
    Eigen::VectorXd all(du.size() + dt.size()), predicted = Eigen::VectorXd::Zero(all.size());
    all << du, dt;
    for (int k = 0; k < m; ++k) {
        const std::vector<int> unknowns = contact.unknowns_of(k, static_cast<int>(du.size()));
        predicted(unknowns) += contact.matrix_of(k) * all(unknowns);
    }
    const Eigen::VectorXd difference = contact.right_hand_side(traction, contact.jumps(u)) -
                                       contact.right_hand_side(traction + dt, contact.jumps(u + du));
    EXPECT_LT((predicted.tail(dt.size()) - difference).norm(), 1e-12 * difference.norm());
    EXPECT_GT(std::ranges::count_if(contact.statuses(), fine::is_closed), 0);
}

}  // namespace
}  // namespace stria::test
