// A zone refined in a coarse mesh against a mesh as fine everywhere (the two agree with `monolithic`: coupling.Modes).
#include <gtest/gtest.h>

#include <cmath>
#include <fmt/format.h>
#include <iostream>

#include "tests/support/sent_analysis.hpp"

namespace stria::test {
namespace {

/// One cycle of tension and compression; plane strain, contact. The crack runs inside elements and meets all sizes.
Case plate(double size, int refine) {
    return sent_case({"mesh.width=12.0", "mesh.height=24.0", "mesh.grading=[]", fmt::format("mesh.size={}", size),
                      fmt::format("fine.refine={}", refine), "fine.growth=0.0", "fine.beta=2.0",
                      "crack.0.points=[[0.0, 12.13], [4.83, 12.13]]", "load.steps=16", "load.grading=0.6",
                      "load.blocks=[{cycles=1, max=55.0, ratio=-1.0}]"});
}

/// Opening at a distance behind the tip, linear between stations.
double opening(const coarse::Increment& increment, double behind) {
    const double x = 4.83 - behind;
    const auto& faces = increment.zone.faces;
    for (std::size_t k = 1; k < faces.size(); ++k) {
        if (faces[k].x < x) continue;
        const double way = (x - faces[k - 1].x) / (faces[k].x - faces[k - 1].x);
        return faces[k - 1].opening + way * (faces[k].opening - faces[k - 1].opening);
    }
    return NAN;
}

TEST(SameAnswer, OfARefinedZoneAndAMeshThatIsFineEverywhereLong) {
    const RunHistory refined = run_direct(plate(0.4, 8)), fine = run_direct(plate(0.05, 1));
    std::cout << "                 refined zone   fine everywhere   difference\n";
    const auto compare = [](const char* name, double of_refined, double of_fine, double scale) {
        const double difference = (of_refined - of_fine) / scale;
        std::cout << fmt::format("{:24} {:12.6g} {:12.6g} {:+10.3f} %\n", name, of_refined, of_fine,
                                 100.0 * difference);
        EXPECT_LT(std::abs(difference), 0.005) << name;
    };
    const auto &r = refined.at_maximum(), &f = fine.at_maximum();
    compare("J, N/mm", r.tips[0].J, f.tips[0].J, f.tips[0].J);
    compare("CTOD, mm", r.tips[0].CTOD, f.tips[0].CTOD, f.tips[0].CTOD);
    compare("plastic zone, mm", r.tips[0].plastic_zone, f.tips[0].plastic_zone, f.tips[0].plastic_zone);
    compare("  on the axis, mm", r.tips[0].plastic_zone_axis, f.tips[0].plastic_zone_axis, f.tips[0].plastic_zone_axis);
    const double largest = opening(f, 1.0);
    for (const double behind : {0.1, 0.2, 0.5, 1.0}) {
        compare(fmt::format("opening {} mm behind", behind).c_str(), opening(r, behind), opening(f, behind),
                opening(f, behind));
        compare("  at the minimum", opening(refined.at_minimum(), behind), opening(fine.at_minimum(), behind), largest);
    }
}

}  // namespace
}  // namespace stria::test
