// The elements of a zone that take over from those of an earlier one.
#include "fine/bulk/bulk_elements.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "common/enrichment/element_basis.hpp"
#include "common/enrichment/part_of_mesh.hpp"
#include "tests/support/cracked_mesh.hpp"
#include "tests/support/plates.hpp"
#include "tests/support/refined_squares.hpp"

namespace stria::test {
namespace {

// With hanging nodes beside the crack, in a zone that begins elsewhere: all numbers are others.
using fine::BulkElements;

TEST(BulkElements, HaveTheUnknownsOfTheirFunctionsWhereTheyHaveStayed) {
    const Mesh body = refined(square_mesh(8), {{{0.45, 0.47}, {0.6, 0.47}, 0.15, 2, 0.0}}).mesh;
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

// A zone that is extended has its tips where they were. Shared functions have their unknowns far from the element.
TEST(BulkElements, StayWhereTheTipsOfTheirFunctionsDo) {
    const Mesh body = refined(square_mesh(8), {{{0.45, 0.47}, {0.6, 0.47}, 0.15, 2, 0.0}}).mesh;
    const Materials materials(plate_case({{0.0, 2.4}, {2.3, 2.6}}));
    const IntegrationRule rule{.subcells = 2, .tip_points = 4};
    for (const coarse::TipSupport support : {coarse::TipSupport::Nodal, coarse::TipSupport::Gathered}) {
        const auto zone_of = [&](double turn, int begin) {
            EnrichedMesh whole = cracked(body, {{-1.0, 0.47}, {0.5, 0.47}}, {4, 0.5, support, {}});
            whole.tips[0].direction = Vec2(std::cos(turn), std::sin(turn));
            std::vector<int> elements;
            for (int e = begin; e < std::ssize(whole.elements); ++e) elements.push_back(e);
            return extract(whole, elements);
        };
        const auto has_functions = [](const BulkElements& of, int e) {
            return std::ranges::any_of(of.mesh().elements[at(e)],
                                       [&](int node) { return of.mesh().has_tip_functions(node); });
        };
        for (const double turn : {0.0, 1e-6}) {
            BulkElements old(zone_of(0.0, 3), materials, rule, nullptr);
            const BulkElements now(zone_of(turn, 0), materials, rule, &old),
                begun(zone_of(turn, 0), materials, rule, nullptr);
            int with_functions = 0;
            for (int e = 3; e < now.count(); ++e) {
                EXPECT_EQ(now.has_stayed(e), turn == 0.0 || !has_functions(now, e)) << e;
                EXPECT_EQ(now.op(e).unknowns, begun.op(e).unknowns) << e;
                EXPECT_EQ(now.stiffness()[at(e)], begun.stiffness()[at(e)]) << e;
                with_functions += has_functions(now, e) ? 1 : 0;
            }
            EXPECT_GT(with_functions, 15);
        }
    }
}

// Points keep a history. Where nothing may yield they have none, and lie where those of a body would that begins.
TEST(BulkElements, KeepTheirPointsWhereMetalMayYieldAlone) {
    const auto mesh_of = [](double tip) { return cracked(square_mesh(8), {{-1.0, 0.47}, {tip, 0.47}}, 0); };
    const IntegrationRule rule{.subcells = 2, .tip_points = 4};
    for (const bool may_yield : {true, false}) {
        Case input = plate_case({{0.0, 2.4}, {2.3, 2.6}});
        input.material.yield_stress.reset();
        if (may_yield) input.material.yield_stress = 300.0;
        const Materials materials(input);
        BulkElements old(mesh_of(0.3), materials, rule, nullptr);
        const BulkElements now(mesh_of(0.7), materials, rule, &old), begun(mesh_of(0.7), materials, rule, nullptr);
        const UnknownSet changed = now.changed_unknowns();
        int other = 0;
        for (int e = 0; e < now.count(); ++e) {
            const auto same = [](const IntegrationPoint& a, const IntegrationPoint& b) { return a.x == b.x; };
            if (!std::ranges::equal(now.op(e).points, begun.op(e).points, same)) ++other;
            if (now.has_stayed(e)) continue;
            for (const int unknown : now.op(e).unknowns) EXPECT_TRUE(changed.contains(unknown));
        }
        EXPECT_EQ(other > 0, may_yield);
        EXPECT_LT(changed.count(), now.mesh().unknowns);
        EXPECT_GT(changed.count(), 0);
    }
}

// On crooked elements, one of whose diagonals is the longer: which of them have the many points of those that a tip may
// come to.
TEST(BulkElements, HaveAsManyPointsWhicheverCornerIsTheFirst) {
    Mesh body = distorted(square_mesh(16), 0.012), turned = body;
    for (std::array<int, 4>& corners : turned.elements) std::ranges::rotate(corners, corners.begin() + 1);
    for (auto& [name, edges] : turned.boundary)
        for (BoundaryEdge& edge : edges) edge.edge = (edge.edge + 3) % 4;
    const Materials materials(plate_case({{0.0, 2.4}, {2.3, 2.6}}));
    const IntegrationRule rule{.subcells = 2, .far_subcells = 1, .tip_points = 4};
    const auto elements_of = [&](const Mesh& mesh) {
        return BulkElements(cracked(mesh, {{-1.0, 0.47}, {0.4, 0.52}}, 0), materials, rule, nullptr);
    };
    const BulkElements one = elements_of(body), other = elements_of(turned);
    int few = 0, many = 0;
    for (int e = 0; e < one.count(); ++e) {
        EXPECT_EQ(one.op(e).points.size(), other.op(e).points.size()) << e;
        ++(one.op(e).points.size() == 4 ? few : many);
    }
    EXPECT_GT(few, 50);
    EXPECT_GT(many, 50);
}

}  // namespace
}  // namespace stria::test
