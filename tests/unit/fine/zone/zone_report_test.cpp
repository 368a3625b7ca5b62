// Which energy density the rings about a tip take: whether it has grown is seen by the elements about it.
#include "fine/zone/zone_report.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/plates.hpp"

namespace stria::test {
namespace {

/// Of a crack that began at the left edge of a plate of unit elements and had its tip at x = 12.25 then.
std::vector<fine::EnergyDensity> densities_with_tip_at(double x, bool leftward = false) {
    const Case input = plate_case({{0.0, 5.5}, {x, 5.5}});
    coupling::Patch zone = plate_patch(plate_mesh(24, 11, input, 0));
    zone.rings = {{.tip = 0, .number = 0, .inner_radius = 1.0, .outer_radius = 4.0, .element = 1.0}};
    Case at_first = plate_case({{0.0, 5.5}, {12.25, 5.5}});
    if (leftward) {
        std::ranges::reverse(at_first.cracks[0].points);
        zone.mesh.tips[0].upper = -1;
    }
    std::vector<fine::EnergyDensity> densities;
    for (const fine::TipRings& rings : fine::rings_of(zone, Materials(input), at_first.cracks, 1))
        densities.push_back(rings.density);
    return densities;
}

// A thousandth of this crack is 0.012 elements, and of a longer one may be many: its length is no measure.
TEST(ZoneReport, ATipHasGrownWhereItHasLeftItsPlaceByAPartOfAnElement) {
    const std::vector stress_work{fine::EnergyDensity::StressWork}, elastic{fine::EnergyDensity::Elastic};
    EXPECT_EQ(densities_with_tip_at(12.25), stress_work);
    EXPECT_EQ(densities_with_tip_at(12.251), stress_work) << "a mesh moves a tip onto a node by as much";
    EXPECT_EQ(densities_with_tip_at(12.257), elastic);
    EXPECT_EQ(densities_with_tip_at(12.75), elastic);
    EXPECT_EQ(densities_with_tip_at(12.251, true), stress_work);
    EXPECT_EQ(densities_with_tip_at(12.75, true), elastic);
}

}  // namespace
}  // namespace stria::test
