// Whether a mesh lets rings tell K and J.
#include "coarse/advice/ring_adequacy.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "coarse/fracture/plastic_zone.hpp"
#include "coarse/specimen/specimen.hpp"
#include "tests/support/advice.hpp"

namespace stria::test {
namespace {

// Elements of 1 mm: a bend of 45 degrees is seen where the crack has left the tip's line by 0.35 mm.
TEST_F(Advice, NamesABendNearATip) {
    input.cracks[0].contact.reset();
    const auto bent = [&](double behind) {
        input.cracks[0].points = {{0.0, 10.3}, {5.3, 10.3}, {5.3 + behind * 0.6, 10.3 + behind * 0.8}};
        return at(300.0);
    };
    ASSERT_EQ(bent(1.3).size(), 1U);
    EXPECT_NE(bent(1.3)[0].find("tip 0: its crack bends 1.6"), std::string::npos) << bent(1.3)[0];
    ASSERT_EQ(bent(1.9).size(), 1U);
    EXPECT_NE(bent(1.3)[0].find("and J is not told nearer than 4: smaller"), std::string::npos) << bent(1.3)[0];
    EXPECT_NE(bent(1.9)[0].find("2.1 elements of 1 mm; K and J want 3 or more"), std::string::npos) << bent(1.9)[0];
    EXPECT_NE(bent(1.9)[0].find("not told nearer than 4 elements to a sharp bend"), std::string::npos) << bent(1.9)[0];
    ASSERT_EQ(bent(3.0).size(), 1U);
    EXPECT_NE(bent(3.0)[0].find("bends sharply 3 mm behind it, 3 elements of 1 mm; J wants 4 or more and is not told: "
                                "elements of 0.75 mm or less there"),
              std::string::npos)
        << bent(3.0)[0];
    EXPECT_TRUE(bent(4.1).empty());
    input.cracks[0].points = {{0.0, 10.3}, {7.3, 10.3}, {8.3, 10.4}};  // too little to see
    EXPECT_TRUE(at(300.0).empty());
    input.cracks[0].points = {{0.0, 10.1}, {6.3, 10.1}, {7.3, 10.5}, {8.3, 10.5}};  // a step of as little
    EXPECT_EQ(at(300.0).size(), 1U);
    input.cracks[0].points = {{0.0, 10.1}, {6.3, 10.1}, {6.5, 10.3}, {8.3, 10.3}};
    EXPECT_TRUE(at(300.0).empty());
}

// On thin rings K of an exact field is off by tens of percent at worst (stria_stress).
TEST_F(Advice, NamesATipWithoutRoomForRings) {
    input.cracks[0].contact.reset();
    const auto from_far_edge = [&](double distance) {
        input.cracks[0].points = {{0.0, 10.3}, {input.mesh.width - distance, 10.3}};
        return at(300.0);
    };
    ASSERT_EQ(from_far_edge(2.4).size(), 1U);
    EXPECT_NE(from_far_edge(2.4)[0].find("elements of 1 mm; K and J want 3 or more"), std::string::npos)
        << from_far_edge(2.4)[0];
    EXPECT_TRUE(from_far_edge(4.3).empty());
}

// Errors by what stands at the tip: docs/verification/elastic.md, "Tips that are near to each other".
TEST_F(Advice, WantsTwoElementsForRingsOfElasticTipsAndThreeBesideOtherCracks) {
    input.cracks[0].contact.reset();
    const auto of_length = [&](double length) {
        input.cracks[0].points = {{8.2, 10.3}, {8.2 + length, 10.3}};
        return at(300.0);
    };
    ASSERT_FALSE(of_length(3.0).empty());  // yields
    EXPECT_NE(of_length(3.0)[0].find("K and J want 3 or more"), std::string::npos) << of_length(3.0)[0];
    input.material.yield_stress.reset();
    input.material.kinematic.clear();
    EXPECT_TRUE(of_length(3.0).empty());
    ASSERT_EQ(of_length(2.4).size(), 2U);
    EXPECT_NE(of_length(2.4)[0].find("1.9 elements of 1 mm; K and J want 2 or more"), std::string::npos)
        << of_length(2.4)[0];
    input.cracks.push_back({.points = {{0.0, 10.3}, {3.2, 10.3}}, .contact = {}});
    ASSERT_FALSE(of_length(7.0).empty());
    EXPECT_NE(of_length(7.0)[0].find("K and J want 3 or more"), std::string::npos) << of_length(7.0)[0];
    input.cracks.pop_back();
    input.cracks[0].points = {{0.0, 10.3}, {input.mesh.width - 2.4, 10.3}};
    EXPECT_TRUE(at(300.0).empty()) << "functions on all elements about the tip's";
    input.fine.enrichment = Enrichment::Topological;
    EXPECT_EQ(at(300.0).size(), 1U);
}

// The same table: rings have room there, but the crack is short by a part of an element.
TEST_F(Advice, NamesAnotherCrackThatIsNearToFunctionsOfOneElement) {
    input.cracks[0].contact.reset();
    input.mesh.width = 40.0;
    const auto apart = [&](double distance) {
        input.cracks[0].points = {{0.0, 10.3}, {0.5 * (input.mesh.width - distance), 10.3}};
        input.cracks.resize(1);
        input.cracks.push_back(
            {.points = {{input.mesh.width, 10.3}, {0.5 * (input.mesh.width + distance), 10.3}}, .contact = {}});
        return at(300.0);
    };
    ASSERT_EQ(apart(9.1).size(), 2U);
    ASSERT_EQ(apart(9.1).size(), 2U);
    EXPECT_NE(apart(9.1)[1].find("tip 1: another crack is 9.1 mm away, 9.1 elements of 1 mm; with tip functions on one "
                                 "element alone J of the zone may be off by more than four percent below 16"),
              std::string::npos)
        << apart(9.1)[1];
    EXPECT_TRUE(apart(16.1).empty());
    input.fine.enrichment = Enrichment::None;
    ASSERT_EQ(apart(16.1).size(), 2U);
    EXPECT_NE(apart(16.1)[0].find("with no tip functions"), std::string::npos) << apart(16.1)[0];
    input.fine.enrichment = Enrichment::Auto;
    input.material.yield_stress.reset();
    input.material.kinematic.clear();
    EXPECT_TRUE(apart(9.1).empty()) << "functions on a whole disk";
}

TEST_F(Advice, MindsTheRoomForJInsideAMetal) {
    input.cracks[0].contact.reset();
    input.regions = {{.outline = {{12.0, -1.0}, {21.0, 21.0}}, .material = input.material, .initial_stress = {}}};
    input.regions[0].material.young /= 2.0;
    EXPECT_TRUE(at(600.0).empty());
    input.regions[0].outline[0].x() = 10.3;
    const auto warnings = at(600.0);
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_NE(warnings[0].find(
                  "the largest ring in its own metal has a radius of 1.9 mm, 1.9 elements of 1.02 mm; J wants 2"),
              std::string::npos)
        << warnings[0];
    EXPECT_EQ(warnings[0].find("K is off"), std::string::npos);
    input.cracks[0].points.back().x() = 10.1;  // 0.2 elements from it
    ASSERT_EQ(at(600.0).size(), 1U);
    EXPECT_NE(at(600.0)[0].find("J wants 2 or more and is not told, and K is off"), std::string::npos);
    input.cracks[0].points.back().x() = 8.3;
    input.regions[0].material = input.material;  // what yields elsewhere is as stiff
    input.regions[0].material.yield_stress = 500.0;
    EXPECT_TRUE(at(600.0).empty());
}

// Elements of a tenth at both tips; one crack is fifty of them long, the other is not.
TEST_F(Advice, NamesATipThatPutsFunctionsAtAnotherOne) {
    input = specimen("plate", 40.0, {{0.0, 10.05}, {6.05, 10.05}});
    input.mesh.width = 20.0;
    input.mesh.size = 1.0;
    input.cracks.push_back({.points = {{20.0, 30.05}, {18.0, 30.05}}, .contact = ContactSection{}});
    for (const Vec2& tip : {Vec2(6.0, 10.02), Vec2(18.0, 30.02)})
        input.mesh.grading.push_back({.at = {tip}, .size = 0.1, .outer_size = 0.1, .radius = 0.6, .growth = 0.3});
    input.cracks[0].contact = ContactSection{};
    input.growth = GrowthSection{.increment = 0.1};
    input.material.yield_stress = 300.0;
    const auto named = [&] {
        const BodyMesh mesh(coarse::make_mesh(input.mesh, input.cracks, input.regions));
        const std::size_t tips = input.cracks.size();
        const std::vector<std::string> all = coarse::mesh_warnings(
            coarse::make_scene(input, mesh), std::vector<double>(tips, 100.0), std::vector<double>(tips, 1.0));
        return std::ranges::count_if(all, [](const std::string& warning) {
            return warning.starts_with("tip 1: its elements of 0.0979 mm are larger than 1/50 of its crack") &&
                   warning.find("at tip 0, too") != std::string::npos &&
                   warning.find("or elements below 0.04 mm at tip 1") != std::string::npos;
        });
    };
    EXPECT_EQ(named(), 1);
    input.fine.enrichment = Enrichment::None;
    EXPECT_EQ(named(), 0);
    input.fine.enrichment = Enrichment::Auto;
    input.cracks.pop_back();
    input.mesh.grading.pop_back();
    EXPECT_EQ(named(), 0);
}

}  // namespace
}  // namespace stria::test
