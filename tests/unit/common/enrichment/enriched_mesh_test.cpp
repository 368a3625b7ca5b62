#include "common/enrichment/enriched_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "common/crack/crack_crossings.hpp"
#include "tests/support/cracked_mesh.hpp"
#include "tests/support/refined_squares.hpp"

namespace stria::test {
namespace {

// With hanging nodes, some of which have jumps of their own alone, and functions that many nodes share.
TEST(NodesOfUnknowns, AreThoseThatTheyAreNumberedBy) {
    const Mesh finer = refined(square_mesh(8), {{{0.45, 0.47}, {0.6, 0.47}, 0.15, 2, 0.0}}).mesh;
    int gathered = 0, jumps_alone = 0;
    for (const Mesh& body : {square_mesh(16), finer}) {
        for (double y = 0.26; y < 0.7; y += 0.017) {
            const EnrichedMesh mesh = cracked(body, {{-1.0, y}, {0.55, y}}, {4, 0.5, coarse::TipSupport::Gathered, {}});
            for (const auto& [node, term, unknown] : mesh.own_unknowns()) {
                const bool shared = term > 0 && mesh.terms[at(node)][at(term - 1)].kind == Term::Kind::Gathered;
                for (const int c : {0, 1}) {
                    EXPECT_EQ(mesh.node_of(unknown + c), shared ? -1 : node) << node << " " << term;
                    EXPECT_EQ(mesh.is_standard(unknown + c), term == 0) << node << " " << term;
                }
                gathered += shared ? 1 : 0;
                jumps_alone += mesh.tie(node) != nullptr ? 1 : 0;
            }
        }
    }
    EXPECT_GT(gathered, 0);
    EXPECT_GT(jumps_alone, 0);
}

TEST(TermsOfNodes, AreEmptyButOfFewNodes) {
    TermsOfNodes terms(5);
    terms.of(3).push_back({Term::Kind::Heaviside, 0, 0, 1.0});
    terms.of(1).push_back({Term::Kind::Tip, 0, 2, 0.5});
    EXPECT_TRUE(terms.of(4).empty());
    EXPECT_EQ(terms.size(), 5U);
    EXPECT_EQ(terms.nodes(), (std::vector{1, 3}));
    EXPECT_EQ(terms[1].at(0).function, 2);
    EXPECT_TRUE(terms[0].empty());
    const TermsOfNodes again = terms.lists();
    EXPECT_EQ(again.nodes(), terms.nodes());
    EXPECT_EQ(again[3].at(0).shift, 1.0);
}

// With hanging nodes, which follow, and with and without functions of a tip, which goes elsewhere.
TEST(SameUnknowns, AreThoseOfTheSameNodeAndFunction) {
    const Mesh body = refined(square_mesh(8), {{{0.45, 0.47}, {0.6, 0.47}, 0.15, 2, 0.0}}).mesh;
    for (const int tip_functions : {0, 6}) {
        const EnrichedMesh mesh = cracked(body, {{-1.0, 0.47}, {0.6, 0.47}}, tip_functions),
                           other = cracked(body, {{-1.0, 0.47}, {0.5, 0.47}}, tip_functions);
        const std::vector<int> same = same_unknowns(mesh, other);
        ASSERT_EQ(std::ssize(same), mesh.unknowns);
        int jumps = 0, more = 0;
        for (const auto& [node, term, unknown] : mesh.own_unknowns()) {
            const Term* const own = term > 0 ? &mesh.terms[at(node)][at(term - 1)] : nullptr;
            const int twin = own != nullptr ? other.term_index(node, *own) : 0;
            const bool tips = own != nullptr && own->kind != Term::Kind::Heaviside;
            const bool lacks = tips || (own != nullptr && twin == 0) || other.follows(node, twin);
            for (const int c : {0, 1})
                EXPECT_EQ(same[at(unknown + c)], lacks ? -1 : other.unknown(node, twin, c)) << node << " " << term;
            jumps += own != nullptr && !lacks ? 1 : 0;
            more += lacks ? 1 : 0;
        }
        EXPECT_GT(jumps, 5);
        EXPECT_GT(more, 2);
    }
}

// Which moves the point behind the tip, and by that its direction. A zone that was extended lost what they held.
TEST(SameUnknowns, AreThoseOfATipWhoseMouthAFinerMeshHoldsElsewhere) {
    const Mesh body = square_mesh(4), finer = refined(body, {{{0.0, 0.25}, {0.0, 0.25}, 0.01, 1, 0.0}}).mesh;
    const std::vector<Vec2> points{{0.0, 0.25 + 0.6 * snap_fraction * 0.25}, {0.85, 0.4}};
    const EnrichedMesh before = cracked(body, points, 1), after = cracked(finer, points, 1);
    ASSERT_NE(before.tips[0].direction, after.tips[0].direction);
    const std::vector<int> same = same_unknowns(after, before);
    int of_tip = 0;
    for (const auto& [node, term, unknown] : after.own_unknowns()) {
        if (term == 0 || after.terms[at(node)][at(term - 1)].kind == Term::Kind::Heaviside) continue;
        EXPECT_GE(same[at(unknown)], 0) << node;
        ++of_tip;
    }
    EXPECT_EQ(of_tip, 4);
}

}  // namespace
}  // namespace stria::test
