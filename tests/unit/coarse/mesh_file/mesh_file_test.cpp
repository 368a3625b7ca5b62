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

std::string complaint_of(const std::string& path) {
    try {
        static_cast<void>(read_mesh_file(path));
    } catch (const CaseError& error) {
        return error.what();
    }
    return "";
}

struct Defect {
    const char* file;
    std::string_view text;
    const char* sentence;
};

class DefectOfMesh : public testing::TestWithParam<Defect> {};

TEST_P(DefectOfMesh, IsNamed) {
    const test::TemporaryFolder folder;
    const auto& [file, text, sentence] = GetParam();
    test::write_file(folder / file, std::string(text));
    EXPECT_EQ(complaint_of(folder / file), std::string("mesh.file: ") + file + sentence);
}

// Two squares side by side, as nodes, before what is wrong with them.
#define SQUARES "*NODE\n1,0,0\n2,1,0\n3,2,0\n4,2,1\n5,1,1\n6,0,1\n"
#define QUADS "*ELEMENT,TYPE=CPS4\n1,1,2,5,6\n2,2,3,4,5\n"

INSTANTIATE_TEST_SUITE_P(
    Body, DefectOfMesh,
    testing::Values(
        Defect{"a.inp", SQUARES "*ELEMENT,TYPE=CPS4\n1,1,2,9,6\n",
               ": element 1 has the node 9, which the file does not give"},
        Defect{"a.inp", SQUARES "*NODE\n3,2,2\n" QUADS, ": node 3 is given twice"},
        Defect{"a.inp", "*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0.5\n*ELEMENT,TYPE=CPS3\n1,1,2,3\n",
               ": node 3 lies at z = 0.5, the first one at z = 0; the mesh must be plane, along x and y"},
        Defect{"a.inp", "*NODE\n1,0,0\n2,1,nan\n3,1,1\n*ELEMENT,TYPE=CPS3\n1,1,2,3\n",
               ": node 2 has a coordinate that is no number"},
        Defect{"a.inp", SQUARES,
               ": has no triangle and no quadrilateral; where groups are named, Gmsh saves only what is in one: name "
               "the surface too"},
        Defect{"a.inp", SQUARES "*ELEMENT,TYPE=CPS4\n1,1,1,2,2\n",
               ": element 1 has no area: its nodes are [1, 1, 2, 2]"},
        Defect{"a.inp", SQUARES "*ELEMENT,TYPE=CPS3\n1,1,2,3\n",
               ": element 1 at (0, 0) is flat at its node 1; the mesh needs convex elements there"},
        Defect{"a.inp", "*NODE\n1,0,0\n2,1,0\n3,0.2,0.2\n4,0,1\n*ELEMENT,TYPE=CPS4\n8,1,2,3,4\n",
               ": element 8 at (0.2, 0.2) has a negative Jacobian at its node 3; the mesh needs convex elements there"},
        Defect{"a.inp", SQUARES "7,1,1e-9\n*ELEMENT,TYPE=CPS4\n1,1,2,5,6\n2,7,3,4,5\n",
               ": nodes 2 and 7 lie both at (1, 0); merge them (Gmsh: Coherence Mesh). Cracks are given in the case, "
               "not by the mesh"},
        Defect{"a.inp", SQUARES "7,0.5,2\n" QUADS "*ELEMENT,TYPE=CPS3\n3,2,5,7\n",
               ": elements 1, 2 and 3 share the edge between the nodes 2 and 5; two may"},
        Defect{"a.inp", SQUARES "7,0.3,0.6\n*ELEMENT,TYPE=CPS4\n1,1,2,5,6\n*ELEMENT,TYPE=CPS3\n4,1,2,7\n",
               ": elements 1 and 4 lie on the same side of their edge between the nodes 1 and 2: they overlap"},
        Defect{"a.inp",
               SQUARES "7,1,0.5\n*ELEMENT,TYPE=CPS4\n1,1,2,5,6\n*ELEMENT,TYPE=CPS3\n2,2,3,7\n3,7,3,4\n4,7,4,5\n",
               ": node 7 at (1, 0.5) lies on the edge of element 1 between the nodes 2 and 5: neighbours must share "
               "whole edges"},
        Defect{"a.inp", SQUARES "7,5,0\n8,6,0\n9,6,1\n" QUADS "*ELEMENT,TYPE=CPS3\n3,7,8,9\n",
               ": elements 1 and 3 are not connected by edges: the mesh is of more than one piece"},
        Defect{"a.inp",
               "*NODE\n1,0,0\n2,1,0\n3,1,1\n4,0,1\n5,2,1\n6,2,2\n7,1,2\n8,0,-1\n9,3,-1\n10,3,2\n*ELEMENT,TYPE=CPS4\n"
               "1,1,2,3,4\n2,3,5,6,7\n3,1,8,9,2\n4,9,10,6,5\n*ELEMENT,TYPE=CPS3\n5,2,9,5\n",
               ": at node 3, (1, 1), elements hang together by this point alone"},
        Defect{"a.inp", SQUARES QUADS "*ELEMENT,TYPE=T2D2,ELSET=top\n7,1,5\n",
               ": group \"top\": no element has the edge between the nodes 1 and 5"}));

INSTANTIATE_TEST_SUITE_P(
    Abaqus, DefectOfMesh,
    testing::Values(
        Defect{"a.inp", SQUARES "*ELEMENT,TYPE=CPS8R\n5,1,2,5,6,7,8,9,10\n",
               ":9: element 5 is of second order (CPS8R); Stria reads first order: CPS3, CPS4, CPE3, CPE4"},
        Defect{"a.inp", SQUARES "*ELEMENT,TYPE=C3D8\n5,1,2,5,6,7,8,9,10\n",
               ":9: element 5 is three-dimensional (C3D8); Stria reads plane meshes: mesh the cross section"},
        Defect{"a.inp", SQUARES "*ELEMENT,TYPE=CAX4\n5,1,2,5,6\n",
               ":9: element 5 is of type CAX4; CPS3, CPS4, CPE3, CPE4 with R, I or H, and T2D2, T3D2 or B21 for edges "
               "are read"},
        Defect{"a.inp", SQUARES "*ELEMENT,TYPE=CPS4\n5,1,2,5\n", ":9: element 5 of type CPS4 has 4 nodes on its line"},
        Defect{"a.inp", SQUARES "*ELEMENT,TYPE=CPS4\n5,1,2,5,6,,\n6,2,3,4,5,6\n",
               ":10: element 6 of type CPS4 has 4 nodes on its line"},
        Defect{"a.inp", SQUARES QUADS "*ELEMENT,TYPE=CPS3\n1,1,2,5\n", ":12: element 1 is given twice"},
        Defect{"a.inp", "*NODE\n1,zero,0\n", ":2: expects a number, and has \"zero\""},
        Defect{"a.inp", "*NODE\n1,0\n", ":2: a node has a number, x and y"},
        Defect{"a.inp", SQUARES "*NSET,NSET=a\n1,b\n", ":9: expects a whole number, and has \"b\""},
        Defect{"a.inp", SQUARES "*NSET,NSET=a,GENERATE\n9,3\n", ":9: GENERATE needs an ascending range"},
        Defect{"a.inp", SQUARES "*NSET,NSET=a,GENERATE\n-9223372036854775808,9223372036854775807\n",
               ":9: set a has more than 10000000 members"},
        Defect{"a.inp", SQUARES "*NSET,NSET=a\n1\n*NSET,NSET=a,GENERATE\n1,10000000\n",
               ":11: set a has more than 10000000 members"},
        Defect{"a.inp", "*NODE,INPUT=nodes.txt\n" QUADS,
               ":1: *NODE, INPUT: other files are not read; write the mesh with all its lines in one"},
        Defect{"a.inp", SQUARES "*ELEMENT,TYPE=CPS4,INPUT=e.txt\n",
               ":8: *ELEMENT, INPUT: other files are not read; write the mesh with all its lines in one"},
        Defect{"a.inp", SQUARES QUADS "*NSET,NSET=a,INPUT=a.txt\n",
               ":11: *NSET, INPUT: other files are not read; write the mesh with all its lines in one"},
        Defect{"a.inp", SQUARES QUADS "*SURFACE,NAME=a,INPUT=a.txt\n",
               ":11: *SURFACE, INPUT: other files are not read; write the mesh with all its lines in one"},
        Defect{"a.inp", SQUARES QUADS "*NSET,NSET=a,ELSET=b\n", ":11: set a: there is no set of elements b"},
        Defect{"a.inp", SQUARES QUADS "*ELSET,ELSET=b\n3\n*NSET,NSET=a,ELSET=b\n", ":13: set a: there is no element 3"},
        Defect{"a.inp", SQUARES QUADS "*SURFACE,TYPE=ELEMENT\n1,S1\n", ":11: *SURFACE has no name"},
        Defect{"a.inp", SQUARES "*ELGEN\n1,2\n",
               ":8: *ELGEN is not read; write the mesh with all its nodes and elements"},
        Defect{"a.inp", "*PART,NAME=a\n*END PART\n*PART,NAME=b\n", ":3: has more than one *PART; one is read"},
        Defect{"a.inp", "*INSTANCE,NAME=a,PART=b\n1.0,0.0,0.0\n",
               ":2: *INSTANCE moves its part; write the mesh where it lies"},
        Defect{"a.inp", SQUARES QUADS "*SURFACE,NAME=s\n2,S5\n", ":12: surface s: element 2 has no side \"S5\""},
        Defect{"a.inp", SQUARES QUADS "*SURFACE,NAME=s\n3,S1\n", ":12: surface s: there is no element 3"},
        Defect{"a.inp", std::string_view("*\0N\0O\0D\0E\0", 10),
               ": is no text of one byte a letter: save it as ASCII or UTF-8"},
        Defect{"a.stl", "solid", ": a mesh is a .msh of Gmsh, or an .inp of Abaqus or CalculiX"}));

#define HEAD "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
#define NODES "$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 1 1 0\n$EndNodes\n"

INSTANTIATE_TEST_SUITE_P(
    Gmsh, DefectOfMesh,
    testing::Values(
        Defect{"a.msh", "solid", ":1: expects a section, which begins with $"},
        Defect{"a.msh", "", ":1: is no mesh of Gmsh: it does not begin with $MeshFormat"},
        Defect{"a.msh", "$MeshFormat\n4 0 8\n$EndMeshFormat\n",
               ":2: is of format 4; 4.1 and 2.2 are read (Mesh.MshFileVersion = 4.1)"},
        Defect{"a.msh", "$MeshFormat\n2.2 0 4\n$EndMeshFormat\n", ":2: has numbers of 4 bytes, not 8"},
        Defect{"a.msh", HEAD "$Nodes\n3\n1 0 0 0\n", ":6: ends too early"},
        Defect{"a.msh", HEAD "$Nodes\n1\n1 0 0 0\n2 1 0 0\n$EndNodes\n",
               ":7: expects $EndNodes: the section has more than it says"},
        Defect{"a.msh", HEAD "$EndNodes\n", ":4: $EndNodes ends a section that has not begun"},
        Defect{"a.msh", HEAD "$Nodes\nx\n", ":5: expects a number, and has \"x\""},
        Defect{"a.msh", HEAD "$PhysicalNames\n2\n1 1 \"foot\n1 2 \"top\"\n$EndPhysicalNames\n",
               ":6: expects a name in quotes"},
        Defect{"a.msh", HEAD "$Comment\n", ":5: $Comment has no $EndComment"},
        Defect{"a.msh", HEAD NODES "$Elements\n1\n6 9 2 0 1 1 2 3 1 2 3\n",
               ":12: element 6 is of second or higher order (type 9); Stria reads first order: Mesh.ElementOrder = 1, "
               "or gmsh -order 1"},
        Defect{"a.msh", HEAD NODES "$Elements\n1\n6 4 2 0 1 1 2 3 1\n",
               ":12: element 6 is three-dimensional; Stria reads plane meshes: mesh the cross section, and save it "
               "without volumes"},
        Defect{"a.msh", HEAD NODES "$Elements\n1\n6 99 2 0 1 1 2 3 1\n",
               ":12: element 6 is of type 99; lines (1), triangles (2), quadrilaterals (3) and points (15) are read"}));

TEST(MeshOfGmsh, MustBeWhole) {
    const test::TemporaryFolder folder;
    const std::string whole = test::text_of(test::mesh_data("two-squares-41-binary.msh"));
    constexpr std::size_t odd = 5;  // so that numbers of four and eight bytes are cut at each of them
    for (std::size_t bytes = 0; bytes + 13 < whole.size(); bytes += odd) {  // but for its last line
        test::write_file(folder / "cut.msh", whole.substr(0, bytes));
        EXPECT_EQ(complaint_of(folder / "cut.msh").substr(0, 18), "mesh.file: cut.msh") << bytes;
    }
    std::string turned = whole;
    std::swap(turned[20], turned[23]);  // of the one that tells the order of bytes
    test::write_file(folder / "turned.msh", turned);
    EXPECT_NE(complaint_of(folder / "turned.msh").find("byte order of another machine"), std::string::npos);
    EXPECT_EQ(complaint_of("/nowhere/part.msh"), "mesh.file: /nowhere/part.msh: cannot be read, no such file");
}

}  // namespace
}  // namespace stria::coarse
