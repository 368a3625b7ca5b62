// A zone refined in a coarse mesh against a mesh as fine everywhere (the two agree with `monolithic`: coupling.Modes).
#include <gtest/gtest.h>

#include <cmath>
#include <fmt/format.h>
#include <iostream>

#include "tests/support/sent_analysis.hpp"

namespace stria::test {
namespace {

/// One cycle of tension and compression; plane strain, contact. The crack runs inside elements and meets all sizes.
struct Plate {
    double width, crack;  // mm; twice as high
    double size;          // of elements, mm
    int refine;
    double unit;  // mm: lengths behind the tip are multiples of it
};

Case case_of(const Plate& plate) {
    const double middle = plate.width + 0.13;
    return sent_case({fmt::format("mesh.width={}", plate.width), fmt::format("mesh.height={}", 2.0 * plate.width),
                      "mesh.grading=[]", fmt::format("mesh.size={}", plate.size),
                      fmt::format("fine.refine={}", plate.refine), "fine.growth=0.0", "fine.beta=2.0",
                      fmt::format("crack.0.points=[[0.0, {0}], [{1}, {0}]]", middle, plate.crack), "load.steps=16",
                      "load.grading=0.6", "load.blocks=[{cycles=1, max=55.0, ratio=-1.0}]"});
}

/// Opening at x, linear between stations.
double opening(const coarse::Increment& increment, double x) {
    const auto& faces = increment.zone.faces;
    for (std::size_t k = 1; k < faces.size(); ++k) {
        if (faces[k].x < x) continue;
        const double way = (x - faces[k - 1].x) / (faces[k].x - faces[k - 1].x);
        return faces[k - 1].opening + way * (faces[k].opening - faces[k - 1].opening);
    }
    return NAN;
}

/// `plate` against elements as fine everywhere.
void expect_same(const Plate& plate) {
    Plate everywhere = plate;
    everywhere.size /= plate.refine;
    everywhere.refine = 1;
    const RunHistory refined = run_direct(case_of(plate)), fine = run_direct(case_of(everywhere));
    std::cout << "                 refined zone   fine everywhere   difference\n";
    const auto compare = [](const std::string& name, double of_refined, double of_fine, double scale) {
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
    const double largest = opening(f, plate.crack - 10.0 * plate.unit);
    for (const double distance : {1.0, 2.0, 5.0, 10.0}) {
        const double x = plate.crack - distance * plate.unit;
        compare(fmt::format("opening {} mm behind", distance * plate.unit), opening(r, x), opening(f, x),
                opening(f, x));
        compare("  at the minimum", opening(refined.at_minimum(), x), opening(fine.at_minimum(), x), largest);
    }
}

TEST(SameAnswer, OfARefinedZoneAndAMeshThatIsFineEverywhere) {
    expect_same({.width = 6.0, .crack = 2.43, .size = 0.2, .refine = 4, .unit = 0.05});
}

TEST(SameAnswer, OfARefinedZoneAndAMeshThatIsFineEverywhereLong) {
    expect_same({.width = 12.0, .crack = 4.83, .size = 0.4, .refine = 8, .unit = 0.1});
}

}  // namespace
}  // namespace stria::test
