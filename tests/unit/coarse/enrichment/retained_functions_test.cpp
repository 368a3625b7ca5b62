// Which functions of old tips stay unknowns.
#include "coarse/enrichment/retained_functions.hpp"

#include <gtest/gtest.h>

#include "tests/support/cracked_mesh.hpp"

namespace stria::coarse {
namespace {

/// Elements of 1 mm.
EnrichedMesh ending_at(double tip) { return test::cracked(test::square_mesh(8, 8.0), {{0.0, 4.4}, {tip, 4.4}}, 1); }

int functions_left(const EnrichedMesh& mesh) {
    int count = 0;
    for (const int node : mesh.terms.nodes())
        for (const Term& term : mesh.terms[at(node)])
            if (term.kind == Term::Kind::Left) ++count;
    return count;
}

TEST(RetainedFunctions, AreThoseOfTipsThatHaveMovedOn) {
    const EnrichedMesh before = ending_at(3.5);
    const EnrichedMesh mesh = with_functions_left(ending_at(4.5), before);
    ASSERT_EQ(mesh.left_tips.size(), 1U);
    EXPECT_EQ(mesh.left_tips[0].position, before.tips[0].position);
    EXPECT_EQ(functions_left(mesh), 4);
    EXPECT_EQ(mesh.unknowns, ending_at(4.5).unknowns + 2 * 4);
    const EnrichedMesh later = with_functions_left(ending_at(5.5), mesh);
    EXPECT_EQ(later.left_tips.size(), 2U);
    EXPECT_EQ(functions_left(later), 8);
}

TEST(RetainedFunctions, AreNotThoseOfATipThatStaysOrHardlyMoves) {
    const EnrichedMesh before = ending_at(3.5);
    for (const double tip : {3.5, 3.5 + 0.21}) {
        EXPECT_TRUE(with_functions_left(ending_at(tip), before).left_tips.empty()) << tip;
        EXPECT_EQ(with_functions_left(ending_at(tip), before).unknowns, ending_at(tip).unknowns) << tip;
    }
    EXPECT_EQ(with_functions_left(ending_at(3.5 + 0.23), before).left_tips.size(), 1U);
}

// A tip that stays has the same functions still.
TEST(RetainedFunctions, AreSaidToBeGivenUpWhereATipHasMovedALittle) {
    const EnrichedMesh before = ending_at(3.5);
    EXPECT_TRUE(tips_nearly_where_they_were(ending_at(3.5), before).empty());
    EXPECT_EQ(tips_nearly_where_they_were(ending_at(3.5 + 0.21), before), std::vector{0});
    EXPECT_TRUE(tips_nearly_where_they_were(ending_at(3.5 + 0.23), before).empty());
    EnrichedMesh without = before;
    without.tip_functions = 0;
    EXPECT_TRUE(tips_nearly_where_they_were(ending_at(3.5 + 0.21), without).empty());
    EXPECT_TRUE(with_functions_left(ending_at(3.5 + 0.21), before).left_tips.empty());
}

}  // namespace
}  // namespace stria::coarse
