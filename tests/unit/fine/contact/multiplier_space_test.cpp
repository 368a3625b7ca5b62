// The trace of the contact multipliers: hats that add up to one, constant towards tips, broken at kinks, none in a
// notch.
#include "fine/contact/multiplier_space.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <ranges>
#include <set>

#include "common/index.hpp"
#include "fine/contact/face_operators.hpp"
#include "tests/support/cracked_mesh.hpp"
#include "tests/support/plates.hpp"

namespace stria::test {
namespace {

using fine::MultiplierSpace;

MultiplierSpace space_of(const std::vector<Vec2>& crack, double notch = 0.0, int columns = 12, int rows = 6) {
    return {plate_mesh(columns, rows, plate_case(crack)), {}, 0, Notch{0.0, notch}};
}

/// Where the multipliers of a crack stand that began as `first`, and has grown at its first point by so much since; by
/// x, which is to ascend along it.
std::vector<double> places_on(const std::vector<Vec2>& first, const std::vector<Vec2>& now, double grown = 0.0) {
    Case input = plate_case(now);
    input.cracks[0].grown_at_start = grown;
    const EnrichedMesh mesh = plate_mesh(12, 6, input);
    const fine::FaceOperators faces(mesh, {}, plate_case(first).cracks, 1, fine::FrozenTips());
    std::vector<double> places;
    for (const fine::FaceOperators::Key& key : faces.keys()) places.push_back(key.x.x());
    std::ranges::sort(places);
    return places;
}

double sum_at(const MultiplierSpace& space, double s) {
    double sum = 0.0;
    for (const auto& [multiplier, value] : space.acting_at(s)) sum += multiplier >= 0 ? value : 0.0;
    return sum;
}

std::set<int> acting_between(const MultiplierSpace& space, double from, double to) {
    std::set<int> acting;
    for (int k = 1; k < 200; ++k) {
        for (const auto& [multiplier, value] : space.acting_at(from + (to - from) * k / 200)) {
            if (multiplier >= 0 && value > 0.0) acting.insert(multiplier);
        }
    }
    return acting;
}

/// Of the multipliers that act between two arc lengths: the least integral of a function by an opening.
double least_gap(const MultiplierSpace& space, double from, double to, const auto& opening) {
    constexpr int points = 6000;
    std::map<int, double> gap;
    for (int k = 0; k < points; ++k) {
        const double s = from + (to - from) * (k + 0.5) / points;
        for (const auto& [multiplier, value] : space.acting_at(s))
            if (multiplier >= 0) gap[multiplier] += opening(s) * value * (to - from) / points;
    }
    return std::ranges::min(gap | std::views::values);
}

double least_weight(const MultiplierSpace& space, double from, double to) {
    return least_gap(space, from, to, [](double) { return 1.0; });
}

TEST(MultiplierSpace, HatsAddUpToOne) {
    for (const std::vector<Vec2>& crack : {std::vector<Vec2>{{0.0, 2.4}, {12.0, 2.4}},
                                           {{0.0, 2.4}, {8.3, 3.7}},
                                           {{2.2, 1.3}, {9.4, 4.6}},
                                           {{0.0, 1.3}, {4.5, 1.4}, {10.4, 4.6}}}) {
        const MultiplierSpace space = space_of(crack);
        double length = 0.0;
        for (std::size_t k = 1; k < crack.size(); ++k) length += (crack[k] - crack[k - 1]).norm();
        for (int k = 1; k < 100; ++k) EXPECT_NEAR(sum_at(space, length * k / 100), 1.0, 1e-14);
        EXPECT_EQ(sum_at(space, length + 0.1), 0.0);
    }
}

TEST(MultiplierSpace, NoTwoCrossingsWithAMultiplierShareANode) {   // so each has a jump of its own (Bechet 2009)
    EXPECT_EQ(space_of({{0.0, 2.4}, {12.0, 2.4}}).size(), 13);     // along a row every crossing is vital
    const int across = space_of({{0.2, 0.0}, {5.9, 6.0}}).size();  // 13 crossings: neighbours share nodes
    EXPECT_LT(across, 9);
    EXPECT_GT(across, 4);
}

// Of two tips and of a mouth, straight, and with a piece of a hundredth of an element between two kinks.
// Then some whose middle is as far from two crossings that share a node.
TEST(MultiplierSpace, TheyStandWhereTheyDoWhicheverEndOfTheCrackIsFirst) {
    for (std::vector<Vec2> crack : {std::vector<Vec2>{{1.325, 0.775}, {4.225, 3.675}},
                                    {{1.3, 1.1}, {3.9, 3.7}},
                                    {{0.9, 0.8}, {4.2, 4.1}},
                                    {{0.7, 0.6}, {5.4, 5.3}},
                                    {{1.3, 1.6}, {10.4, 4.3}},
                                    {{0.0, 1.2}, {7.0, 5.1}},
                                    {{1.3, 1.4}, {3.3, 1.4}, {3.31, 1.41}, {10.7, 2.6}}}) {
        const std::vector<double> places = places_on(crack, crack);
        std::ranges::reverse(crack);
        const std::vector<double> reversed = places_on(crack, crack);
        ASSERT_EQ(places.size(), reversed.size()) << crack.back().x();
        for (std::size_t k = 0; k < places.size(); ++k) EXPECT_NEAR(places[k], reversed[k], 1e-12) << crack.back().x();
    }
}

// What faces said before a growth they go on to say behind it, be it the crack's first point that has moved.
TEST(MultiplierSpace, GrowthTakesNoneAway) {
    for (const auto& [tip, other] : {std::pair(Vec2(5.4, 2.3), Vec2(8.4, 5.4)),
                                     {Vec2(4.1, 1.6), Vec2(7.4, 4.9)},
                                     {Vec2(7.1, 4.7), Vec2(4.3, 1.9)}}) {
        const Vec2 way = (tip - other).normalized();
        const std::vector<double> before = places_on({tip, other}, {tip, other});
        for (int step = 1; step < 12; ++step) {
            const double grown = 0.15 * step;
            const std::vector<double> places = places_on({tip, other}, {tip + grown * way, tip, other}, grown);
            for (const double place : before)
                EXPECT_TRUE(std::ranges::any_of(places, [&](double x) { return std::abs(x - place) < 1e-9; }))
                    << tip.x() << ' ' << grown << ' ' << place;
        }
    }
}

// Of a wing as short as an element its two ends are alike, whichever the crack begins at.
TEST(MultiplierSpace, AloneOnABranchStandsForItsMiddle) {
    std::vector<Vec2> crack = {{2.3, 2.4}, {2.7, 3.1}, {9.3, 3.1}, {9.7, 2.4}};
    const double wing = (crack[1] - crack[0]).norm(), length = 2.0 * wing + 6.6;
    for (int reversed = 0; reversed < 2; ++reversed) {
        const MultiplierSpace space = space_of(crack);
        ASSERT_EQ(std::ranges::count_if(space.nodes(), [&](double s) { return s < wing; }), 1);
        EXPECT_NEAR(space.middle(0), 0.5 * wing, 1e-12);
        EXPECT_NEAR(space.middle(space.size() - 1), length - 0.5 * wing, 1e-12);
        for (int k = 1; k + 1 < space.size(); ++k) EXPECT_EQ(space.middle(k), space.nodes()[at(k)]);
        std::ranges::reverse(crack);
    }
}

// A corner of the element at the mouth is cut off: both of its edges share a node.
TEST(MultiplierSpace, TwoStandAtAMouthWhereTheCrackCutsOffACorner) {
    for (const double side : {0.4, 0.6, 0.8}) {
        for (std::vector<Vec2> crack :
             {std::vector<Vec2>{{0.0, 3.0 - side}, {2.7, 5.7 - side}}, {{0.0, 3.0 + side}, {2.7, 0.3 + side}}}) {
            const std::vector<double> at_once = places_on(crack, crack);
            ASSERT_GT(at_once.size(), 2U);
            EXPECT_NEAR(at_once[0], 0.0, 1e-12);
            EXPECT_NEAR(at_once[1], side, 1e-12) << "they are 0.56 of an element apart or more";
            EXPECT_GT(std::numbers::sqrt2 * (at_once[2] - at_once[1]), 0.5 - 1e-12);
            std::ranges::reverse(crack);
            EXPECT_NEAR(places_on(crack, crack)[1], side, 1e-12) << "the mouth is its last point";
        }
    }
    EXPECT_GT(places_on({{0.0, 2.7}, {2.7, 5.4}}, {{0.0, 2.7}, {2.7, 5.4}})[1], 0.9) << "0.42 of an element apart";
}

// Of three nodes whose jumps two of them see one must not be the structure's, or be missing: the two would see one
// jump.
TEST(MultiplierSpace, TwoAtAMouthHaveJumpsOfTheirOwn) {
    const EnrichedMesh mesh = plate_mesh(12, 6, plate_case({{0.0, 2.4}, {2.7, 5.1}}));
    const double second = 0.6 * std::numbers::sqrt2;
    ASSERT_NEAR(MultiplierSpace(mesh, {}, 0, Notch()).nodes()[1], second, 1e-12);
    for (const Vec2& shared : {Vec2(0.0, 2.0), Vec2(0.0, 3.0), Vec2(1.0, 3.0)}) {
        std::vector<int> boundary;
        for (const auto& [node, term, unknown] : mesh.own_unknowns())
            if ((mesh.nodes[at(node)] - shared).norm() < 1e-9) boundary.insert(boundary.end(), {unknown, unknown + 1});
        std::ranges::sort(boundary);
        const MultiplierSpace space(mesh, boundary, 0, Notch());
        EXPECT_NEAR(space.nodes()[0], 0.0, 1e-12);
        EXPECT_GT(space.nodes()[1], second + 0.1) << shared.transpose();
    }
}

// The second one beside a mouth is there before the third crossing is.
TEST(MultiplierSpace, GrowthFromAMouthTakesNoneAway) {
    for (const Vec2& way : {Vec2(1.0, 1.0), Vec2(1.0, 0.7), Vec2(0.6, 1.0)}) {
        for (const double side : {0.3, 0.55, 0.7, 0.9}) {
            const Vec2 mouth(0.0, 2.0 - side);
            std::vector<double> before;
            for (double length = 0.4; length < 4.0; length += 0.15) {
                const std::vector<Vec2> crack{mouth, mouth + length * way.normalized()};
                const std::vector<double> places = places_on(crack, crack);
                for (const double place : before)
                    EXPECT_TRUE(std::ranges::any_of(places, [&](double x) { return std::abs(x - place) < 1e-9; }))
                        << side << ' ' << length << ' ' << place;
                before = places;
            }
        }
    }
}

TEST(MultiplierSpace, NodesLieOnCrossings) {
    const MultiplierSpace space = space_of({{0.0, 2.4}, {11.9, 2.4}});
    for (int k = 0; k < space.size(); ++k) EXPECT_NEAR(space.nodes()[at(k)], k, 1e-12);
}

TEST(MultiplierSpace, PressureIsConstantTowardsATip) {
    const MultiplierSpace space = space_of({{0.4, 2.4}, {11.9, 2.4}});
    const double first = space.nodes().front(), last = space.nodes().back();
    EXPECT_EQ(acting_between(space, 0.0, first), std::set<int>{0});
    EXPECT_EQ(acting_between(space, last, 11.5), std::set<int>{space.size() - 1});
}

// There is no jump at a tip, whatever functions its nodes carry: on a node, in the middle of an edge.
TEST(MultiplierSpace, NoneStandsAtATip) {
    for (const Vec2& tip : {Vec2(2.0, 3.0), Vec2(4.0, 3.4)}) {
        const MultiplierSpace space = space_of({{0.0, 1.0}, tip});
        const double length = (tip - Vec2(0.0, 1.0)).norm();
        EXPECT_LT(space.nodes().back(), length - 0.5);
        EXPECT_EQ(acting_between(space, space.nodes().back(), length), std::set<int>{space.size() - 1});
    }
}

TEST(MultiplierSpace, CrossingsThatTheZoneSharesCarryNone) {
    const EnrichedMesh mesh = plate_mesh(6, 5, plate_case({{0.0, 2.4}, {4.3, 2.6}}));
    const MultiplierSpace own(mesh, plate_patch(mesh).boundary, 0, Notch()), all(mesh, {}, 0, Notch());
    EXPECT_EQ(own.size(), all.size() - 1);  // the mouth
    EXPECT_GT(own.nodes().front(), 0.5);
}

// Large elements whose jumps the zone shares, then small ones: the first hats reach far back, and none turns negative.
TEST(MultiplierSpace, EveryMultiplierHasAPositiveWeight) {
    const std::vector<double> xs{0.0, 2.0, 4.0, 4.2, 4.4, 4.6, 4.8, 5.0, 5.2, 5.4, 5.6, 5.8, 6.0};
    const EnrichedMesh mesh =
        cracked(coarse::grid_mesh(xs, equal_cells(5, 1.0)), {{0.0, 0.5}, {5.9, 0.5}}, coarse::TipEnrichment{1, 0.5});
    std::vector<int> shared;
    for (const auto& [node, term, unknown] : mesh.own_unknowns())
        if (mesh.nodes[at(node)].x() < 4.1) shared.insert(shared.end(), {unknown, unknown + 1});
    std::ranges::sort(shared);
    for (const double notch : {0.0, 1.0, 3.9, 4.05, 4.15, 4.25})
        EXPECT_GT(least_weight(MultiplierSpace(mesh, shared, 0, Notch{0.0, notch}), notch, 5.9), 0.0) << notch;
}

// On a mesh line, and by rounding before or behind it: the same multipliers. One at the end itself would act on half of
// its node's share.
TEST(MultiplierSpace, ANotchEndsOnANodeOrBesideIt) {
    const std::vector<Vec2> crack{{0.0, 3.0}, {6.3, 3.0}};
    const MultiplierSpace at_node = space_of(crack, 4.0);
    EXPECT_NEAR(at_node.nodes()[0], 5.0, 1e-12);
    for (const double beside : {-1e-10, 1e-10})
        EXPECT_EQ(space_of(crack, 4.0 + beside).nodes().size(), at_node.nodes().size()) << beside;
    EXPECT_NEAR(space_of(crack).nodes()[0], 0.0, 1e-12) << "no notch";
}

// In through a node whose jump the zone shares, and a kink on the second crossing: the branch's end is as long as its
// only interval, and what hats gain beyond that they have lost before.
TEST(MultiplierSpace, TheLastOfTwoKeepsItsWeight) {
    const EnrichedMesh mesh = plate_mesh(12, 6, plate_case({{0.0, 3.0}, {2.0, 3.4}, {6.3, 2.4}}));
    const double kink = std::hypot(2.0, 0.4);
    const MultiplierSpace space(mesh, plate_patch(mesh).boundary, 0, Notch());
    ASSERT_NEAR(space.nodes()[0], 0.5 * kink, 1e-12);
    ASSERT_NEAR(space.nodes()[1], kink, 1e-12);
    EXPECT_GT(least_weight(space, 0.0, kink), 0.2 * kink);
}

// Behind a bend a crack is open, the more the farther from its tip: no multiplier may see a gap below zero.
TEST(MultiplierSpace, FacesThatGapeFromATipAreOpenToEach) {
    for (const double bend : {4.1, 4.5, 4.9, 6.02}) {
        for (const double tip : {6.3, 7.05, 7.9, 8.3, 9.3, 10.6}) {
            const Vec2 first(0.0, 1.3), second(bend, 1.35), third(tip, 1.35 + 0.4 * (tip - bend));
            const double from = (second - first).norm(), to = from + (third - second).norm();
            if (tip - bend < 1.0) continue;
            const MultiplierSpace space = space_of({first, second, third});
            EXPECT_GT(least_gap(space, from, to, [&](double s) { return to - s; }), 0.0) << bend << ' ' << tip;
            EXPECT_GT(least_gap(space, from, to, [&](double s) { return std::sqrt(to - s); }), 0.0)
                << bend << ' ' << tip;
        }
    }
}

// A tip that has grown out of a notch by two elements: its faces part from the second crossing on.
TEST(MultiplierSpace, FacesThatGapeFromTheMultiplierAtATipAreOpenToIt) {
    for (const double notch : {5.05, 5.2, 5.5, 5.9})
        for (const double tip : {7.1, 7.5, 7.9}) {
            const MultiplierSpace space = space_of({{0.0, 1.4}, {tip, 1.4}}, notch);
            ASSERT_EQ(space.size(), 2);
            EXPECT_GT(least_gap(space, notch, tip, [](double s) { return std::max(7.0 - s, 0.0); }), 0.0) << notch;
        }
}

TEST(MultiplierSpace, OneAtEachPointActsHalfWayToTheNext) {
    const MultiplierSpace space(std::vector{1.0, 2.0, 4.0});
    EXPECT_EQ(space.size(), 3);
    EXPECT_FALSE(space.is_stable());
    EXPECT_TRUE(space_of({{0.0, 2.4}, {11.9, 2.4}}).is_stable());
    for (const auto& [s, nearest] : {std::pair{0.0, 0}, {1.4, 0}, {1.6, 1}, {2.9, 1}, {3.1, 2}, {9.0, 2}}) {
        EXPECT_EQ(space.acting_at(s)[0].multiplier, nearest);
        EXPECT_EQ(space.acting_at(s)[0].value, 1.0);
        EXPECT_EQ(space.acting_at(s)[1].multiplier, -1);
    }
}

TEST(MultiplierSpace, AKinkBreaksThePressure) {
    const double corner = 6.0;
    const MultiplierSpace kinked = space_of({{0.0, 1.4}, {corner, 1.4}, {10.0, 5.4}});
    const std::set<int> before = acting_between(kinked, 0.0, corner), after = acting_between(kinked, corner, 10.0);
    for (const int multiplier : before) EXPECT_FALSE(after.contains(multiplier));
    const MultiplierSpace bent = space_of({{0.0, 1.4}, {corner, 1.4}, {11.5, 1.9}});  // 5 degrees
    EXPECT_EQ(bent.acting_at(corner)[0].multiplier, bent.acting_at(corner + 1e-6)[0].multiplier);
}

// A branch of a hundredth of an element has next to no jumps of its own: at a tip, between two kinks, behind a notch.
TEST(MultiplierSpace, AShortBranchGoesWithItsNeighbour) {
    const MultiplierSpace at_tip = space_of({{0.0, 1.4}, {6.3, 1.4}, {6.31, 1.41}});
    EXPECT_EQ(at_tip.size(), space_of({{0.0, 1.4}, {6.31, 1.4}}).size());
    EXPECT_EQ(at_tip.branch(6.29), at_tip.branch(6.305));
    EXPECT_EQ(acting_between(at_tip, 6.3, 6.31).size(), 1U);  // constant towards the tip
    const MultiplierSpace between = space_of({{0.0, 1.4}, {6.3, 1.4}, {6.31, 1.41}, {10.0, 1.6}});
    EXPECT_EQ(between.branch(6.29), between.branch(6.305));
    EXPECT_NE(between.branch(6.305), between.branch(7.0));
    EXPECT_NEAR(sum_at(between, 6.305), 1.0, 1e-14);
    const MultiplierSpace behind_notch = space_of({{0.0, 1.4}, {6.3, 1.4}, {9.3, 4.4}}, 6.29);
    EXPECT_EQ(behind_notch.branch(6.295), behind_notch.branch(7.0));
    EXPECT_EQ(behind_notch.branch(6.28), -1);
    const MultiplierSpace long_enough = space_of({{0.0, 1.4}, {6.3, 1.4}, {6.4, 1.5}});
    EXPECT_NE(long_enough.branch(6.29), long_enough.branch(6.35));
}

TEST(MultiplierSpace, ANotchCarriesNone) {
    const MultiplierSpace space = space_of({{0.0, 2.4}, {12.0, 2.4}}, 4.7);
    EXPECT_EQ(sum_at(space, 4.6), 0.0);
    EXPECT_GE(space.nodes().front(), 4.7);
    for (const double s : {4.7, 5.0, 12.0}) EXPECT_NEAR(sum_at(space, s), 1.0, 1e-14);
}

// Growth at a crack's first point leaves its notch behind: in other elements, ending on one's edge, within one.
TEST(MultiplierSpace, FacesBeforeANotchCarryThemToo) {
    for (const Notch notch : {Notch{2.3, 4.7}, Notch{2.0, 5.0}, Notch{4.3, 4.6}}) {
        const MultiplierSpace space(plate_mesh(12, 6, plate_case({{0.0, 2.4}, {12.0, 2.4}})), {}, 0, notch);
        const double middle = 0.5 * (notch.from + notch.to);
        EXPECT_EQ(sum_at(space, middle), 0.0);
        for (const double s : {0.5, notch.from - 1e-3, notch.to + 1e-3, 11.5})
            EXPECT_NEAR(sum_at(space, s), 1.0, 1e-14) << s;
        EXPECT_NE(space.branch(1.0), space.branch(6.0));
        EXPECT_TRUE(std::ranges::none_of(space.nodes(), [&](double s) { return s > notch.from && s < notch.to; }));
        EXPECT_TRUE(std::ranges::is_sorted(space.nodes()));
        for (const auto& [from, to] : {std::pair{0.0, notch.from}, {notch.to, 12.0}})
            EXPECT_GT(least_weight(space, from, to), 0.1) << from;
    }
}

TEST(MultiplierSpace, BothSidesOfANotchCarryThemAlike) {
    const auto space = [](double from, double to) {
        return MultiplierSpace(plate_mesh(12, 6, plate_case({{0.0, 2.4}, {12.0, 2.4}})), {}, 0, Notch{from, to});
    };
    EXPECT_EQ(space(4.6, 12.0).size(), space(0.0, 12.0 - 4.6).size());
    EXPECT_EQ(space(4.6, 7.4).size(), 2 * space(4.6, 12.0).size());
}

}  // namespace
}  // namespace stria::test
