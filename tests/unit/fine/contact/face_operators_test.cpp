// Gaps and slips of the faces, and the work of the tractions on them.
#include "fine/contact/face_operators.hpp"

#include <gtest/gtest.h>

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <set>

#include "common/index.hpp"
#include "tests/support/cut_plate.hpp"

namespace stria::test {
namespace {

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
        contact.operators().add_force(pressure, force);
        EXPECT_NEAR(-force.dot(u), work, 1e-12 * std::abs(work));
    }
}

TEST(ContactInterface, ConstantTractionsDoTheWorkOfTheJumps) {
    for (const auto& [left, right] : {std::pair{2.4, 2.4}, {1.3, 4.2}, {4.1, 0.8}, {2.0, 2.0}}) {
        const Cut cut(left, right, 0.0, 0.5);
        const ContactInterface contact = cut.contact();
        ASSERT_EQ(contact.tractions(), 2 * contact.multipliers());
        const auto above = [](const Vec2& x) { return Vec2(0.1 + 0.2 * x.x(), 0.3 - 0.05 * x.x() + 0.1 * x.y()); };
        const Eigen::VectorXd u = cut.opened(above);
        const Vec2 along = cut.to - cut.from, normal(-along.y(), along.x());
        const Vec2 jump = above(0.5 * (cut.from + cut.to));
        const double work = 7.0 * jump.dot(normal) - 3.0 * jump.dot(along);
        Eigen::VectorXd traction(contact.tractions());
        traction << Eigen::VectorXd::Constant(contact.multipliers(), 7.0),
            Eigen::VectorXd::Constant(contact.multipliers(), 3.0);
        Eigen::VectorXd force = Eigen::VectorXd::Zero(cut.mesh.unknowns);
        contact.operators().add_force(traction, force);
        EXPECT_NEAR(-force.dot(u), work, 1e-12 * std::abs(work));
    }
}

// As a tip leaves its functions behind nothing opens or closes.
TEST(ContactInterface, WhatIsFrozenWeighsAsItsUnknownsDid) {
    for (const auto& [from, to] : {std::pair{Vec2(0.0, 2.4), Vec2(5.3, 2.4)}, {Vec2(0.0, 1.3), Vec2(5.6, 3.2)}}) {
        Case input = plate_case({from, to});
        input.cracks[0].contact->friction = 0.5;
        input.fine.enrichment = Enrichment::Topological;
        const EnrichedMesh mesh = plate_mesh(8, 5, input);
        Eigen::VectorXd u = Eigen::VectorXd::Zero(mesh.unknowns);
        for (const auto& [node, term, unknown] : mesh.own_unknowns())
            if (term > 0 && mesh.terms[at(node)][at(term - 1)].kind == Term::Kind::Tip)
                u.segment<2>(unknown) = Vec2(0.01 * std::sin(unknown), 0.01 * std::cos(unknown));
        fine::FrozenTips frozen;
        frozen.freeze(mesh, 0, u);
        const ContactInterface own(mesh, {}, input.cracks, 2, contact_stiffness),
            fixed(mesh, {}, input.cracks, 2, contact_stiffness, frozen);
        const Eigen::VectorXd gaps = own.operators().gaps(u), slips = own.operators().slips(u), none = 0.0 * u;
        EXPECT_GT(gaps.norm(), 1e-4);
        EXPECT_LT((fixed.operators().gaps(none) - gaps).norm(), 1e-12 * gaps.norm());
        EXPECT_LT((fixed.operators().slips(none) - slips).norm(), 1e-12 * slips.norm());
    }
}

// The paper's plain space: the jump of each Gauss point is its own condition, and closed ones give way to a step or the
// matrix would be singular.
TEST(ContactInterface, OneMultiplierAtEachGaussPointSeesTheJumpThere) {
    Cut cut(1.3, 4.2, 0.0, 0.5);
    cut.input.cracks[0].contact->multipliers = MultiplierKind::Gauss;
    ContactInterface contact = cut.contact();
    const auto& stations = contact.operators().stations();
    ASSERT_EQ(contact.multipliers(), std::ssize(stations));
    const auto above = [](const Vec2& x) { return Vec2(0.1 + 0.2 * x.x(), 0.3 - 0.05 * x.x() + 0.1 * x.y()); };
    const Jumps jumps = contact.jumps(cut.opened(above));
    contact.choose_statuses(Eigen::VectorXd::Ones(contact.tractions()),
                            contact.jumps(cut.opened([](const Vec2&) { return Vec2::Zero().eval(); })));
    for (const FaceStation& station : stations) {
        const int k = contact.operators().functions_at(station)[0].multiplier;
        EXPECT_NEAR(jumps.gap[k], above(station.x).dot(station.normal), 1e-12);
        EXPECT_NEAR(jumps.slip[k], above(station.x).dot(station.tangent), 1e-12);
        EXPECT_NEAR(contact.operators().weight(k), station.weight, 1e-14);
        const Eigen::VectorXd own = contact.matrix_of(k).diagonal().tail(2);
        EXPECT_LT(own.maxCoeff(), 0.0);
    }
}

TEST(ContactInterface, ANotchIsFree) {
    const Cut cut(2.4, 2.4, 3.0);
    const ContactInterface contact = cut.contact();
    Eigen::VectorXd force = Eigen::VectorXd::Zero(cut.mesh.unknowns);
    contact.operators().add_force(Eigen::VectorXd::Ones(contact.multipliers()), force);
    const Eigen::VectorXd lifted = cut.opened([](const Vec2&) { return Vec2(0.0, 1.0); });
    EXPECT_LT(-force.dot(lifted), 5.5);  // mm: no interface element is split, so up to one is lost
    EXPECT_GT(-force.dot(lifted), 4.4);
}

TEST(ContactInterface, LessOfTheCrackThanBetweenTwoPointsStaysOpen) {
    const Cut cut(2.4, 2.4, 8.0 - 1e-3);
    ContactInterface contact = cut.contact();
    ASSERT_EQ(contact.multipliers(), 1);
    const Eigen::VectorXd closed = cut.opened([](const Vec2&) { return Vec2(0.0, -1.0).eval(); });
    contact.settle(Eigen::VectorXd::Zero(cut.mesh.unknowns));
    coupling::WorkCounts work;
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(1);
    const ContactInterface::Jumps jumps = contact.jumps_that_matter(closed, none, work);
    EXPECT_GT(jumps.gap[0], 0.0);
    contact.choose_statuses(none, jumps);
    EXPECT_EQ(contact.status_changes(), 0);
}

TEST(ContactInterface, AUniformGapIsSeenByEveryMultiplier) {
    const Cut cut(1.3, 4.2);
    const Vec2 normal = Vec2(1.3 - 4.2, 8.0).normalized();
    const Eigen::VectorXd gaps = cut.contact().jumps(cut.opened([&](const Vec2&) { return 0.25 * normal; })).gap;
    EXPECT_LT((gaps.array() - 0.25).abs().maxCoeff(), 1e-13);
}

TEST(ContactInterface, EveryTractionHasAJumpOfItsOwn) {  // or it would do no work
    for (const auto& [left, right] : {std::pair{2.4, 2.4}, {1.3, 4.2}, {4.1, 0.8}, {2.0, 2.0}, {2.001, 3.999}}) {
        const ContactInterface contact = Cut(left, right, 0.0, 0.5).contact();
        Eigen::MatrixXd B(contact.tractions(), contact.operators().operator_B().cols());
        B << Eigen::MatrixXd(contact.operators().operator_B()), Eigen::MatrixXd(contact.operators().operator_T());
        EXPECT_GT(Eigen::JacobiSVD<Eigen::MatrixXd>(B).singularValues().tail<1>()[0], 0.1) << left << ' ' << right;
    }
}

}  // namespace
}  // namespace stria::test
