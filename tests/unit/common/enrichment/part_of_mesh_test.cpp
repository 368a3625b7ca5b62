// Parts of an enriched mesh, as ranks have them.
#include "common/enrichment/part_of_mesh.hpp"

#include <gtest/gtest.h>

#include "tests/support/cracked_mesh.hpp"

namespace stria::test {
namespace {

// Beside the crack an element may have a node that jumps, and none of a part's elements that sees the jump. It does not
// know any more then that it lies beside a crack. Behind a bend auxiliary fields took the other branch of theta there:
// K_II was off by 0.15 MPa sqrt(mm) where a rank had such a part.
TEST(PartOfMesh, KnowsTheSideOfElementsWhoseJumpItHasLost) {
    const EnrichedMesh whole = cracked(square_mesh(9), {{-1.0, 0.47}, {0.3, 0.47}, {0.62, 0.29}}, 0);
    int lost = 0;
    for (int e = 0; e < std::ssize(whole.elements); ++e) {
        const EnrichedMesh part = extract(whole, {e});
        EXPECT_EQ(branch_side(part, 0), branch_side(whole, e)) << e;
        const bool jumps = !part.terms.nodes().empty();
        lost += branch_side(whole, e) != 0 && whole.element_side[at(e)] == 0 && !jumps ? 1 : 0;
        EXPECT_EQ(branch_side(extract(part, {0}), 0), branch_side(whole, e)) << "a part of a part";
    }
    EXPECT_GT(lost, 5);
}

}  // namespace
}  // namespace stria::test
