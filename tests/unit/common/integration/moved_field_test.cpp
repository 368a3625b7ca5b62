#include "common/integration/moved_field.hpp"

#include <gtest/gtest.h>

#include "tests/support/cracked_mesh.hpp"
#include "tests/support/refined_squares.hpp"

namespace stria {
namespace {

/// A linear field, and a linear jump across the crack, both written as of the tip.
Eigen::VectorXd field_of_tip(const EnrichedMesh& mesh) {
    const Vec2 tip = mesh.tips.at(0).position;
    Eigen::Matrix2d gradient, opening;
    gradient << 0.3, -0.2, 0.5, 0.7;
    opening << -0.4, 0.0, 0.1, 0.0;
    Eigen::VectorXd u = Eigen::VectorXd::Zero(mesh.unknowns);
    for (const auto& [node, term, unknown] : mesh.own_unknowns()) {
        const Vec2 x = mesh.nodes[at(node)] - tip, jump = opening * x;
        const auto jumps = std::ranges::find(mesh.terms[at(node)], Term::Kind::Heaviside, &Term::kind);
        const bool on_crack = std::abs(x.y()) < 1e-12 && jumps != mesh.terms[at(node)].end();
        const double side = on_crack ? jumps->shift : x.y() > 0.0 ? 1.0 : -1.0;
        if (term == 0) u.segment<2>(unknown) = gradient * x + (x.x() < 0.0 ? Vec2(side * jump) : Vec2::Zero());
        if (term > 0) u.segment<2>(unknown) = jump;
    }
    return u;
}

class MovedFieldAt : public testing::TestWithParam<double> {};

// In the middle of elements, and along their edges.
INSTANTIATE_TEST_SUITE_P(Height, MovedFieldAt, testing::Values(0.47, 0.5));

TEST_P(MovedFieldAt, GoesAlongWithTheTip) {
    const double y = GetParam();
    const Mesh body = test::refined(test::square_mesh(8), {{{0.45, y}, {0.6, y}, 0.15, 2, 0.0}}).mesh;
    const auto with_crack_to = [&](double x) { return test::cracked(body, {{-1.0, y}, {x, y}}, 0); };
    const EnrichedMesh from = with_crack_to(0.50), to = with_crack_to(0.53125);
    const TipMoves moves = TipMoves::between(from, to).value();
    const Eigen::VectorXd moved = MovedField(from, to, moves).of(field_of_tip(from)), wanted = field_of_tip(to);
    int compared = 0, jumps = 0;
    for (const auto& [node, term, unknown] : to.own_unknowns()) {
        const Vec2 x = to.nodes[at(node)];
        if (x.x() < 0.04 || (std::abs(x.y() - y) < 0.13 && x.x() > 0.4)) continue;  // no mesh behind; the jump's end
        EXPECT_LT((moved.segment<2>(unknown) - wanted.segment<2>(unknown)).norm(), 1e-12)
            << x.transpose() << " " << term;
        ++compared;
        jumps += term > 0 ? 1 : 0;
    }
    EXPECT_GT(compared, 100);
    EXPECT_GT(jumps, 5);
}

// Where elements come to lie on elements: in the middle of them, and along their edges.
TEST_P(MovedFieldAt, IsExactlyThatOfTheNodeBehind) {
    const double y = GetParam();
    const auto with_crack_to = [&](double x) { return test::cracked(test::square_mesh(8), {{-1.0, y}, {x, y}}, 0); };
    const EnrichedMesh from = with_crack_to(0.55), to = with_crack_to(0.675);
    const Eigen::VectorXd u = Eigen::VectorXd::LinSpaced(from.unknowns, -1.0, 900.0).array().sin();
    const Eigen::VectorXd moved = MovedField(from, to, TipMoves::between(from, to).value()).of(u);
    int plain = 0, jumps = 0;
    for (const auto& [node, term, unknown] : to.own_unknowns()) {
        const Vec2& here = to.nodes[at(node)];
        const auto behind = [&](const Vec2& x) { return (here - x - Vec2(0.125, 0.0)).norm() < 1e-9; };
        const auto found = std::ranges::find_if(from.nodes, behind);
        if (found == from.nodes.end()) continue;
        const int old = static_cast<int>(found - from.nodes.begin());
        if (from.terms[at(old)].size() != to.terms[at(node)].size()) continue;
        EXPECT_EQ(moved.segment<2>(unknown), u.segment<2>(from.unknown(old, term, 0))) << here.transpose();
        (term > 0 ? jumps : plain) += 1;
    }
    EXPECT_GT(plain, 50);
    EXPECT_GT(jumps, 3);
}

// Of a crack across the mesh: where the tip goes on by an element, some nodes lie on the other side of it than what is
// behind them. Its sides move apart as rigid bodies. Such nodes had the displacement of the other face, and Newton's
// method began with half of the opening as a strain.
TEST(MovedField, KeepsTheSidesOfACrackAcrossTheMesh) {
    constexpr double element = 1.0 / 16.0;
    int changed = 0;
    for (const double slope : {0.15, -0.15, 0.3, -0.3}) {
        const auto on_crack = [&](double x) { return Vec2(x, 0.512 + slope * (x - 0.5)); };
        const auto side = [&](const Vec2& x) { return x.y() > on_crack(x.x()).y() ? 1.0 : -1.0; };
        const auto with_crack_to = [&](double x) {
            return test::cracked(test::square_mesh(16), {on_crack(-1.0), on_crack(x)}, 0);
        };
        const EnrichedMesh from = with_crack_to(0.72), to = with_crack_to(0.72 + element);
        Eigen::VectorXd u = Eigen::VectorXd::Zero(from.unknowns);
        for (const auto& [node, term, unknown] : from.own_unknowns())
            u.segment<2>(unknown).setConstant(term > 0 ? 1.0 : side(from.nodes[at(node)]));
        const Eigen::VectorXd moved = MovedField(from, to, TipMoves::between(from, to).value()).of(u);
        for (const auto& [node, term, unknown] : to.own_unknowns()) {
            const Vec2& x = to.nodes[at(node)];
            if (term > 0 || x.x() > 0.65) continue;  // there may be no jump behind; the jump's end
            EXPECT_NEAR(moved[unknown], side(x), 1e-12) << slope << " at " << x.transpose();
            changed += side(x) != side(x - Vec2(element, 0.0)) ? 1 : 0;
        }
    }
    EXPECT_GT(changed, 0);
}

TEST(MovedField, IsThatOfTheNearestTip) {
    const Mesh body = test::square_mesh(9);
    const auto with_crack = [&](double left, double right) {
        return test::cracked(body, {{left, 0.5}, {right, 0.5}}, 0);
    };
    constexpr double element = 1.0 / 9.0;
    const EnrichedMesh from = with_crack(0.3, 0.6), to = with_crack(0.2, 0.65);
    const TipMoves moves = TipMoves::between(from, to).value();
    EXPECT_LT((moves.of_nearest_tip({0.2, 0.5}) - Vec2(-element, 0.0)).norm(), 1e-12);  // 0.1, to whole elements
    EXPECT_LT(moves.of_nearest_tip({0.6, 0.4}).norm(), 1e-12);                          // 0.05
    EXPECT_FALSE(TipMoves::between(from, test::cracked(body, {{0.3, 0.5}, {0.65, 0.5}}, 6)));
}

TEST(MovedField, StaysAsItIsWhereNoTipMoves) {
    const Mesh body = test::refined(test::square_mesh(8), {{{0.5, 0.47}, {0.5, 0.47}, 0.1, 2, 0.0}}).mesh;
    const EnrichedMesh mesh = test::cracked(body, {{-1.0, 0.47}, {0.5, 0.47}}, 0);
    const Eigen::VectorXd u = Eigen::VectorXd::LinSpaced(mesh.unknowns, -1.0, 1.0).array().sin();
    const Eigen::VectorXd moved = MovedField(mesh, mesh, TipMoves::between(mesh, mesh).value()).of(u);
    int plain = 0;
    for (const auto& [node, term, unknown] : mesh.own_unknowns()) {
        if (!mesh.terms[at(node)].empty()) continue;
        EXPECT_EQ(moved.segment<2>(unknown), u.segment<2>(unknown)) << mesh.nodes[at(node)].transpose();
        ++plain;
    }
    EXPECT_GT(plain, 50);
    EXPECT_LT((moved - u).norm(), 1e-12 * u.norm());
}

// Where small elements give way to large ones no move takes the mesh onto itself.
TEST(MovedField, WantsTheSameMeshAboutTheTip) {
    const auto with_disk = [](double x) {
        const Mesh body = test::refined(test::square_mesh(8), {{{x, 0.47}, {x, 0.47}, 0.1, 2, 0.0}}).mesh;
        return test::cracked(body, {{-1.0, 0.47}, {x, 0.47}}, 0);
    };
    EXPECT_TRUE(TipMoves::between(with_disk(0.4), with_disk(0.4)).has_value());
    const Mesh coarse_body = test::square_mesh(8);
    EXPECT_FALSE(TipMoves::between(with_disk(0.4), test::cracked(coarse_body, {{-1.0, 0.47}, {0.5, 0.47}}, 0)));
}

}  // namespace
}  // namespace stria
