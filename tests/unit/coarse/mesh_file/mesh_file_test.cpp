// Files that Gmsh 4.8 has written (tests/data/meshes/two-squares.geo) in every format, and what they become.
#include "coarse/mesh_file/mesh_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <fstream>
#include <iterator>
#include <string_view>

#include "coarse/model/loads/boundary_conditions.hpp"
#include "coarse/specimen/structured.hpp"
#include "common/error.hpp"
#include "common/fem/centre.hpp"
#include "common/fem/shape_q4.hpp"
#include "tests/support/mesh_files.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria::coarse {
namespace {

double area_of(const Mesh& mesh, int element) {
    const QuadNodes corners = corners_of_element(mesh, element);
    for (const Vec2& xi : {Vec2(-1.0, -1.0), Vec2(1.0, -1.0), Vec2(1.0, 1.0), Vec2(-1.0, 1.0)})
        EXPECT_GT(shape_q4(corners, xi).jacobian, 0.0) << element;
    return 4.0 * shape_q4(corners, Vec2::Zero()).jacobian;
}

/// The body lies left of its edges: around all of them once, the normals add up to nothing and the area comes out.
void expect_closed(const Mesh& mesh, double area) {
    Vec2 sum = Vec2::Zero();
    double enclosed = 0.0;
    for (const auto& [name, edges] : mesh.boundary) {
        for (const BoundaryEdge& edge : edges) {
            const EdgeGeometry ends = edge_geometry(mesh, edge);
            sum += ends.to - ends.from;
            enclosed += 0.5 * cross(ends.from, ends.to);
        }
    }
    EXPECT_LT(sum.norm(), 1e-12);
    EXPECT_NEAR(enclosed, area, 1e-12 * area);
}

Mesh mesh_of_text(const char* file, const char* text) {
    const test::TemporaryFolder folder;
    test::write_file(folder / file, text);
    return read_mesh_file(folder / file);
}

class FormatOfMesh : public testing::TestWithParam<const char*> {};

// One square is a quadrilateral, the other two triangles: ten elements.
TEST_P(FormatOfMesh, GivesTheSameBody) {
    const std::string file = std::string("two-squares") + GetParam();
    Mesh mesh = read_mesh_file(test::mesh_data(file));
    EXPECT_EQ(mesh.nodes.size(), 6U + 8U + 3U);
    ASSERT_EQ(mesh.elements.size(), 10U);
    double area = 0.0;
    for (int e = 0; e < 10; ++e) area += area_of(mesh, e);
    EXPECT_NEAR(area, 2.0, 1e-14);
    EXPECT_EQ(mesh.groups.at("plate").size(), 4U);
    EXPECT_EQ(mesh.groups.at("weld").size(), 6U);
    for (const int e : mesh.groups.at("plate"))
        for (const int node : mesh.elements[at(e)]) EXPECT_LE(mesh.nodes[at(node)].x(), 1.0);
    for (const auto& [name, y] : {std::pair{"bottom", 0.0}, std::pair{"top", 1.0}}) {
        EXPECT_EQ(mesh.boundary.at(name).size(), 4U);
        for (const BoundaryEdge& edge : mesh.boundary.at(name)) {
            EXPECT_EQ(edge_geometry(mesh, edge).from.y(), y);
            EXPECT_EQ(edge_geometry(mesh, edge).to.y(), y);
        }
    }
    EXPECT_EQ(mesh.boundary.at(unnamed_edges).size(), 4U);
    EXPECT_FALSE(mesh.boundary.contains("inner line"));
    if (file.ends_with(".inp"))
        std::erase_if(mesh.boundary, [](const auto& named) { return named.first.starts_with("Line"); });
    else
        EXPECT_EQ(mesh.nodes[at(mesh.node_sets.at("corner").front())], Vec2(0.0, 0.0));
    EXPECT_EQ(mesh.boundary.size(), 3U);
    expect_closed(mesh, 2.0);
}

INSTANTIATE_TEST_SUITE_P(Gmsh, FormatOfMesh,
                         testing::Values("-41-text.msh", "-41-binary.msh", "-22-text.msh", "-22-binary.msh", ".inp"));

TEST_P(FormatOfMesh, MayBeginWithAByteOrderMark) {
    const std::string file = std::string("two-squares") + GetParam();
    const test::TemporaryFolder folder;
    std::ifstream as_written(test::mesh_data(file), std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(as_written), {});
    test::write_file(folder / file, "\xEF\xBB\xBF" + text);
    EXPECT_EQ(read_mesh_file(folder / file).nodes, read_mesh_file(test::mesh_data(file)).nodes);
}

TEST(MeshOfAbaqus, MayBeginWithAByteOrderMarkBeforeItsNodes) {
    const test::TemporaryFolder folder;
    test::write_file(folder / "a.inp",
                     "\xEF\xBB\xBF*NODE\n1,0,0\n2,1,0\n3,1,1\n4,0,1\n*ELEMENT,TYPE=CPS4\n1,1,2,3,4\n");
    EXPECT_EQ(read_mesh_file(folder / "a.inp").nodes.size(), 4U);
}

// All that a mesh may say in Abaqus's words: sets of nodes, ranges, surfaces, elements that run clockwise or are
// folded.
TEST(MeshOfAbaqus, KnowsSetsAndSurfaces) {
    const test::TemporaryFolder folder;
    test::write_file(folder / "part.inp", R"(*Heading
** a comment
*Part, name=plate
*Node
 1, 0., 0.
 2, 1.D0, 0.
 3, 2., 0.
 4, 2., 1.
 5, 1., 1.
 6, 0., 1.
 7, 9., 9.
*Element, type=CPE4R, elset=Whole
 10, 1, 2, 5, 6
 11, 2, 5, 4, 3
*Nset, nset=Left
 1, 6, 4
*Nset, nset=corners, generate
 1, 6, 2
*Elset, elset=right half
 11,
*Elset, elset=both
 Whole, right half
*Surface, type=ELEMENT, name=lower
 10, S1
 right half, S4
*Material, name=steel
*Elastic
 200e3, 0.3
)");
    const Mesh mesh = read_mesh_file(folder / "part.inp");
    EXPECT_EQ(mesh.nodes.size(), 6U);
    ASSERT_EQ(mesh.elements.size(), 2U);
    for (const int e : {0, 1}) EXPECT_EQ(area_of(mesh, e), 1.0);
    EXPECT_EQ(mesh.groups.at("right half"), std::vector<int>{1});
    EXPECT_EQ(mesh.groups.at("both"), (std::vector<int>{0, 1}));
    EXPECT_EQ(mesh.boundary.at("Left").size(), 1U);
    BoundarySection left;
    left.on = "Left";
    EXPECT_EQ(place_of(mesh, left, "").nodes.size(), 3U) << "one of them at no edge of the set";
    EXPECT_EQ(mesh.node_sets.at("corners").size(), 3U);
    for (const BoundaryEdge& edge : mesh.boundary.at("lower")) EXPECT_EQ(edge_geometry(mesh, edge).from.y(), 0.0);
    EXPECT_EQ(mesh.boundary.at("lower").size(), 2U);
    expect_closed(mesh, 2.0);
    const std::vector<std::string> lines = describe_mesh_file(folder / "part.inp");
    ASSERT_EQ(lines.size(), 6U);
    EXPECT_EQ(lines[0], "mesh.file: part.inp: Abaqus or CalculiX; 2 quadrilaterals, 0 triangles");
    EXPECT_EQ(lines[1], "1 elements ran clockwise and were turned");
    EXPECT_EQ(lines[2], "1 nodes are of no element");
    EXPECT_EQ(lines[3], "passed over: *ELASTIC, *MATERIAL");
    EXPECT_NE(lines[4].find("Left (1 edges), "), std::string::npos) << lines[4];
    EXPECT_NE(lines[4].find("Left (and 1 nodes)"), std::string::npos) << lines[4];
}

TEST(MeshOfAbaqus, ARangeEndsWhereItsStepLeadsBeyondAllNumbers) {
    const Mesh mesh = mesh_of_text(
        "a.inp", "*NODE\n1,0,0\n2,1,0\n3,1,1\n-1,0,1\n*ELEMENT,TYPE=CPS4\n1,1,2,3,-1\n"
                 "*NSET,NSET=corner,GENERATE\n1,3,9223372036854775807\n"
                 "*NSET,NSET=three,GENERATE\n-9223372036854775808,9223372036854775807,9223372036854775807\n");
    EXPECT_EQ(mesh.node_sets.at("corner").size(), 1U);
    EXPECT_EQ(mesh.node_sets.at("three"), std::vector<int>{3});  // -1 of the three
}

TEST(MeshOfAbaqus, ASetMayNameItself) {
    const Mesh mesh = mesh_of_text("a.inp", "*NODE\n1,0,0\n2,1,0\n3,1,1\n4,0,1\n5,2,0\n6,2,1\n*ELEMENT,TYPE=CPS4\n"
                                            "1,1,2,3,4\n2,2,5,6,3\n*ELSET,ELSET=Half\n1,HALF\nhalf,half,1\n"
                                            "*NSET,NSET=ends\n4,ends,6\nEnds,ends\n");
    EXPECT_EQ(mesh.groups.at("Half"), std::vector<int>{0});
    EXPECT_EQ(mesh.node_sets.at("ends").size(), 2U);
}

TEST(MeshOfAbaqus, ASetOfNodesMayBeThoseOfElements) {
    const test::TemporaryFolder folder;
    test::write_file(folder / "a.inp", "*NODE\n1,0,0\n2,1,0\n3,1,1\n4,0,1\n5,2,0\n6,2,1\n*ELEMENT,TYPE=CPS4\n"
                                       "1,1,2,3,4\n2,2,5,6,3\n*ELSET,ELSET=Right\n2\n*NSET,NSET=held,ELSET=RIGHT\n"
                                       "*SURFACE,TYPE=NODE,NAME=pushed\nheld,1.0\n");
    EXPECT_EQ(read_mesh_file(folder / "a.inp").boundary.at("held").size(), 3U);  // all but the one inside
    EXPECT_EQ(describe_mesh_file(folder / "a.inp").at(1), "passed over: *SURFACE, TYPE=NODE");
}

// The sign tells which way a curve or a surface runs, and no part of the name does.
TEST(MeshOfGmsh, GroupsKeepTheirNamesWhereTheyRunBackwards) {
    const test::TemporaryFolder folder;
    const std::string names = "$PhysicalNames\n2\n1 7 \"foot\"\n2 8 \"plate\"\n$EndPhysicalNames\n";
    test::write_file(folder / "2.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + names +
                                           "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n$EndNodes\n$Elements\n"
                                           "3\n1 1 2 -7 -1 2 1\n2 1 2 -9 -3 3 4\n3 3 2 -8 1 1 2 3 4\n$EndElements\n");
    test::write_file(folder / "4.msh",
                     "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n" + names +
                         "$Entities\n0 2 1 0\n1 0 0 0 1 0 0 1 -7 0\n3 0 1 0 1 1 0 1 -9 0\n1 0 0 0 1 1 0 1 -8 0\n"
                         "$EndEntities\n$Nodes\n1 4 1 4\n2 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n$EndNodes\n"
                         "$Elements\n3 3 1 3\n1 1 1 1\n1 2 1\n1 3 1 1\n2 3 4\n2 1 3 1\n3 1 2 3 4\n$EndElements\n");
    for (const char* file : {"2.msh", "4.msh"}) {
        const Mesh mesh = read_mesh_file(folder / file);
        EXPECT_EQ(mesh.groups.at("plate").size(), 1U) << file;
        EXPECT_EQ(mesh.boundary.at("foot").size(), 1U) << file;
        EXPECT_EQ(mesh.boundary.at("9").size(), 1U) << file;
    }
}

TEST(MeshOfGmsh, TakesAnElementOfTwoGroupsOnce) {
    const Mesh mesh =
        mesh_of_text("part.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n"
                                 "4 0 1 0\n$EndNodes\n$Elements\n2\n1 3 2 7 1 1 2 3 4\n2 3 2 8 1 1 2 3 4\n"
                                 "$EndElements\n");
    EXPECT_EQ(mesh.elements.size(), 1U);
    EXPECT_EQ(mesh.groups.at("7"), mesh.groups.at("8"));
    EXPECT_EQ(mesh.boundary.at(unnamed_edges).size(), 4U);
}

// In columns of a regular mesh many nodes have the same x.
TEST(MeshFile, TakesNoLongerToReadATallBodyThanAWideOne) {
    const test::TemporaryFolder folder;
    const auto seconds_for = [&](int columns, int rows) {
        std::vector<double> xs, ys;
        for (int i = 0; i <= columns; ++i) xs.push_back(i);
        for (int i = 0; i <= rows; ++i) ys.push_back(i);
        test::write_file(folder / "strip.msh", test::msh_text(grid_mesh(xs, ys)));
        const std::clock_t start = std::clock();
        EXPECT_EQ(read_mesh_file(folder / "strip.msh").elements.size(), at(columns * rows));
        return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    };
    const double wide = seconds_for(16000, 3);
    EXPECT_LT(seconds_for(3, 16000), 4.0 * wide);
}

}  // namespace
}  // namespace stria::coarse
