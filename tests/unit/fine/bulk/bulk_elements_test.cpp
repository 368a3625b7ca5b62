// The elements of a zone that take over from those of an earlier one.
#include "fine/bulk/bulk_elements.hpp"

#include <gtest/gtest.h>

#include "coarse/model/mesh_refinement.hpp"
#include "common/enrichment/element_basis.hpp"
#include "common/enrichment/part_of_mesh.hpp"
#include "tests/support/cracked_mesh.hpp"
#include "tests/support/plates.hpp"

namespace stria::test {
namespace {

// With hanging nodes beside the crack, in a zone that begins elsewhere: all numbers are others.
using fine::BulkElements;

TEST(BulkElements, HaveTheUnknownsOfTheirFunctionsWhereTheyHaveStayed) {
    const Mesh body = coarse::refine(square_mesh(8), {{{0.45, 0.47}, {0.6, 0.47}, 0.15, 2, 0.0}}).mesh;
    const auto zone_of = [&](double tip, int begin) {
        const EnrichedMesh whole = cracked(body, {{-1.0, 0.47}, {tip, 0.47}}, 0);
        std::vector<int> elements;
        for (int e = begin; e < std::ssize(whole.elements); ++e) elements.push_back(e);
        return extract(whole, elements);
    };
    const Materials materials(plate_case({{0.0, 2.4}, {2.3, 2.6}}));
    const IntegrationRule rule{.subcells = 2, .tip_points = 4};
    BulkElements old(zone_of(0.5, 3), materials, rule, nullptr);
    const BulkElements now(zone_of(0.6, 0), materials, rule, &old);
    int stayed = 0, cut = 0;
    for (int e = 0; e < now.count(); ++e) {
        const bool is_cut = piece_in(now.mesh(), e) != nullptr;
        EXPECT_EQ(now.op(e).unknowns, ElementBasis(now.mesh(), e, is_cut).unknowns()) << e;
        stayed += now.has_stayed(e) ? 1 : 0;
        cut += now.has_stayed(e) && is_cut ? 1 : 0;
    }
    EXPECT_GT(stayed, 100);
    EXPECT_GT(cut, 5);
    EXPECT_GT(now.built(), 3);
}

}  // namespace
}  // namespace stria::test
