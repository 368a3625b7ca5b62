// Which slivers bear less than the residual shows.
#include "fine/bulk/idle_sides.hpp"

#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "tests/support/cracked_mesh.hpp"
#include "tests/support/plates.hpp"

namespace stria::test {
namespace {

using fine::BulkElements;
using fine::IdleSides;

/// Eight by eight elements, and a crack that descends by `slope`, `gap` edges below the node in the middle: of the
/// element below it on the left it leaves a triangle of (gap^2 / 2 slope) of its area.
BulkElements beside_a_node(double gap, double slope) {
    const double edge = 1.0 / 8.0, height = 0.5 - gap * edge;
    const EnrichedMesh mesh = cracked(square_mesh(8), {{-1.0, height + 1.5 * slope}, {0.9, height - 0.4 * slope}}, 0);
    return {mesh, Materials(plate_case({{0.0, 2.4}, {2.3, 2.6}})), {.subcells = 2, .tip_points = 4}, nullptr};
}

/// With the sides of their points.
std::set<std::pair<int, int>> idle_in(const BulkElements& elements, double tolerance, double flow = 0.0) {
    const IdleSides idle(elements, tolerance);
    std::set<std::pair<int, int>> found;
    for (int e = 0; e < elements.count(); ++e)
        for (const IntegrationPoint& point : elements.op(e).points)
            if (idle.contain(e, point, flow)) found.emplace(e, point.side);
    return found;
}

TEST(IdleSides, AreThoseOfSliversWhoseForcesAreTolerated) {
    const double gap = 2e-3, slope = 0.14, share = gap * gap / (2.0 * slope);
    const BulkElements elements = beside_a_node(gap, slope);
    const std::set<std::pair<int, int>> triangle{{3 * 8 + 3, 1}};
    EXPECT_EQ(idle_in(elements, 1.001 * share), triangle);
    EXPECT_TRUE(idle_in(elements, 0.999 * share).empty());
}

TEST(IdleSides, AreNoLargerThanAHundredthOfAnElementWhateverIsTolerated) {
    const BulkElements elements = beside_a_node(2e-3, 0.14);
    EXPECT_EQ(idle_in(elements, 0.5).size(), 1U);
    EXPECT_TRUE(idle_in(beside_a_node(0.06, 0.14), 0.5).empty());  // 1.3 hundredths
}

TEST(IdleSides, AreThinUpToAHundredthOfAnElementWhateverIsTolerated) {
    const std::set<std::pair<int, int>> triangle{{3 * 8 + 3, 1}};
    EXPECT_EQ(idle_in(beside_a_node(0.04, 0.14), 1e-9, 2e-3), triangle);  // 0.6 hundredths
    EXPECT_TRUE(idle_in(beside_a_node(0.04, 0.14), 1e-9).empty());
    EXPECT_TRUE(idle_in(beside_a_node(0.04, 0.14), 1e-9, 5e-4).empty()) << "it flows as metal does";
    EXPECT_TRUE(idle_in(beside_a_node(0.06, 0.14), 1e-9, 2e-3).empty());  // 1.3 hundredths
}

}  // namespace
}  // namespace stria::test
