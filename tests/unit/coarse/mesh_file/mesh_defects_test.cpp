// What is wrong with a mesh file is named, with its place.
#include "coarse/mesh_file/mesh_file.hpp"

#include <gtest/gtest.h>

#include <string_view>

#include "common/error.hpp"
#include "tests/support/mesh_files.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria::coarse {
namespace {

std::string complaint_of(const std::string& path) {
    return test::refusal_of([&] { return read_mesh_file(path); });
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
