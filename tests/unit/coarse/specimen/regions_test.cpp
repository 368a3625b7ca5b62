// Which element is of which material, and the node lines along outlines.
#include "coarse/specimen/regions.hpp"

#include <gtest/gtest.h>

#include "coarse/specimen/specimen.hpp"
#include "common/error.hpp"
#include "common/fem/centre.hpp"
#include "common/index.hpp"
#include "tests/support/refusal.hpp"

namespace stria::coarse {
namespace {

RegionSection region(std::vector<Vec2> outline) {
    RegionSection section;
    section.outline = std::move(outline);
    return section;
}

MeshSection plate(double size) {
    MeshSection section;
    section.specimen = "plate";
    section.width = section.height = 10.0;
    section.size = size;
    return section;
}

std::string complaint(const Mesh& mesh, const std::vector<RegionSection>& regions) {
    return test::refusal_of([&] { return materials_of_elements(mesh, regions); });
}

TEST(Regions, AxisParallelOutlinesAreNodeLines) {
    const std::vector regions{region({{3.3, 2.1}, {7.7, 10.0}})};
    const Mesh mesh = make_mesh(plate(0.7), {}, regions);
    EXPECT_TRUE(region_warnings(mesh, regions).empty());
    const std::vector<int> material = materials_of_elements(mesh, regions);
    double area = 0.0;
    for (int e = 0; e < std::ssize(mesh.elements); ++e) {
        const auto& nodes = mesh.elements[at(e)];
        const Vec2 extent = mesh.nodes[at(nodes[2])] - mesh.nodes[at(nodes[0])];
        EXPECT_LE(extent.maxCoeff(), 0.7 * 1.2);
        if (material[at(e)] == 1) area += extent.x() * extent.y();
    }
    EXPECT_NEAR(area, 4.4 * 7.9, 1e-12);
}

TEST(Regions, LinesBesideAGradingKeepItsSize) {
    MeshSection section = plate(1.0);
    section.grading = {{.at = {{5.0, 5.0}}, .size = 0.1, .outer_size = 0.1, .radius = 0.4, .growth = 0.2}};
    const std::vector regions{region({{5.03, -1.0}, {20.0, 11.0}})};
    const Mesh mesh = make_mesh(section, {}, regions);
    EXPECT_TRUE(region_warnings(mesh, regions).empty());
    for (int e = 0; e < std::ssize(mesh.elements); ++e) {
        const auto& nodes = mesh.elements[at(e)];
        const Vec2 extent = mesh.nodes[at(nodes[2])] - mesh.nodes[at(nodes[0])];
        EXPECT_GT(extent.minCoeff(), 0.02);
        if ((centre(mesh, e) - Vec2(5.0, 5.0)).norm() < 0.3) {
            EXPECT_LT(extent.maxCoeff(), 0.1 + 1e-12);
        }
    }
}

TEST(Regions, ObliqueOutlinesHaveStepsAndSaySo) {
    const std::vector regions{region({{0.0, 0.0}, {10.0, 0.0}, {0.0, 10.0}})};
    const Mesh mesh = make_mesh(plate(0.9), {}, regions);
    const std::vector<std::string> warnings = region_warnings(mesh, regions);
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_NE(warnings[0].find("region 0: its outline runs through"), std::string::npos);
    const std::vector<int> material = materials_of_elements(mesh, regions);
    for (int e = 0; e < std::ssize(mesh.elements); ++e) {
        if (const double x = centre(mesh, e).sum(); std::abs(x - 10.0) > 1e-9) {
            EXPECT_EQ(material[at(e)] == 1, x < 10.0);
        }
    }
}

TEST(Regions, NeighboursShareNoElement) {
    const std::vector<Vec2> shared{{2.0, 0.0}, {6.0, 10.0}};
    const std::vector regions{region({{0.0, 0.0}, shared[0], shared[1], {0.0, 10.0}}),
                              region({shared[0], {10.0, 0.0}, {10.0, 10.0}, shared[1]})};
    for (const double size : {1.0, 0.5, 0.4}) {  // centres on the shared edge among them
        const std::vector<int> material = materials_of_elements(make_mesh(plate(size), {}), regions);
        for (const int m : material) EXPECT_GT(m, 0);
    }
}

TEST(Regions, MayBeGroupsOfTheMesh) {
    Mesh mesh = make_mesh(plate(5.0), {});
    mesh.groups = {{"weld", {1, 3}}, {"all", {0, 1, 2, 3}}};
    RegionSection weld, all, other;
    weld.group = "weld";
    all.group = "all";
    other.group = "cast";
    EXPECT_EQ(materials_of_elements(mesh, {weld}), (std::vector<int>{0, 1, 0, 1}));
    EXPECT_TRUE(region_warnings(mesh, {weld}).empty());
    EXPECT_EQ(complaint(mesh, {all, weld}), "region.1.group: overlaps region 0 near (7.5, 2.5)");
    EXPECT_EQ(complaint(mesh, {other}),
              "region.0.group: \"cast\" is no group of elements of the mesh, available: all, weld");
}

TEST(Regions, MustHoldElementsAndNotOverlap) {
    const Mesh mesh = make_mesh(plate(1.0), {});
    EXPECT_TRUE(materials_of_elements(mesh, {}).empty());
    EXPECT_EQ(complaint(mesh, {region({{1.0, 1.0}, {3.0, 3.0}})}), "accepted");
    EXPECT_NE(complaint(mesh, {region({{11.0, 1.0}, {13.0, 3.0}})}).find("region.0.outline: holds no element"),
              std::string::npos);
    EXPECT_NE(complaint(mesh, {region({{1.0, 1.0}, {3.0, 3.0}}), region({{2.0, 2.0}, {4.0, 4.0}})})
                  .find("region.1.outline: overlaps region 0 near (2.5, 2.5)"),
              std::string::npos);
}

}  // namespace
}  // namespace stria::coarse
