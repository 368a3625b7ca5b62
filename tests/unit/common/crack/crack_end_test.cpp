// The end of a crack at which a tip is: of either end, and of a crack that has become longer.
#include "common/crack/crack_end.hpp"

#include <gtest/gtest.h>

namespace stria {
namespace {

const CrackSection crack{.points = {{0.0, 0.0}, {2.0, 0.0}, {2.0, 3.0}}, .contact = {}};
const Tip first{.crack = 1, .position = {0.0, 0.0}, .direction = {-1.0, 0.0}, .s = 0.0, .upper = -1};
const Tip last{.crack = 1, .position = {2.0, 1.0}, .direction = {0.0, 1.0}, .s = 3.0, .upper = 1};

TEST(CrackEnd, IsThatOfTheTipsSide) {
    EXPECT_EQ(end_of(crack, first), Vec2(0.0, 0.0));
    EXPECT_EQ(end_of(crack, last), Vec2(2.0, 3.0));  // the crack has grown since the tip was found
    EXPECT_EQ(last_stretch(crack, first), Vec2(-2.0, 0.0));
    EXPECT_EQ(last_stretch(crack, last), Vec2(0.0, 3.0));
    EXPECT_EQ(direction_of_end(crack, first), Vec2(-1.0, 0.0));
    EXPECT_EQ(direction_of_end(crack, last), Vec2(0.0, 1.0));
}

TEST(CrackEnd, PointsLeadToTheTip) {
    EXPECT_EQ(points_to(crack, first), (std::vector<Vec2>{{2.0, 3.0}, {2.0, 0.0}, {0.0, 0.0}}));
    EXPECT_EQ(points_to(crack, last), crack.points);
}

TEST(CrackEnd, PieceIsTheOutermostOfTheTipsCrack) {
    std::vector<CrackPiece> pieces;
    for (const auto& [of_crack, element] : {std::pair{0, 10}, {1, 11}, {1, 12}, {1, 13}, {2, 14}}) {
        pieces.emplace_back();
        pieces.back().crack = of_crack;
        pieces.back().element = element;
    }
    EXPECT_EQ(piece_of(pieces, first)->element, 11);
    EXPECT_EQ(piece_of(pieces, last)->element, 13);
    pieces.resize(1);
    EXPECT_EQ(piece_of(pieces, last), nullptr);
}

}  // namespace
}  // namespace stria
