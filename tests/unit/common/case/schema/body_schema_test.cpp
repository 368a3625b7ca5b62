// What a case says of its body: specimens, meshes, metals, cracks and what holds or loads its edges.
#include "common/case/schema/case_file.hpp"

#include <gtest/gtest.h>

#include <sys/stat.h>

#include "common/case/case_questions.hpp"
#include "common/error.hpp"
#include "common/memory.hpp"
#include "tests/support/case_text.hpp"
#include "tests/support/folders.hpp"

namespace stria::test {
namespace {

TEST_F(CaseFile, KnowsTheProportionsOfSpecimens) {
    std::string text = complete;
    const std::string height = "height = 200\n";
    text.erase(text.find(height), height.size());
    EXPECT_EQ(read(text).mesh.height, 200.0);
    EXPECT_EQ(read(text, {"mesh.specimen=mt"}).mesh.height, 150.0);
    EXPECT_EQ(read(text, {"mesh.specimen=ct"}).mesh.height, 60.0);
    EXPECT_NE(resolved_toml(read(text)).find("height = 200"), std::string::npos);
    EXPECT_EQ(complaint(text, {"mesh.specimen=plate"}),
              "case.toml:3: mesh needs height: a plate has no standard proportions");
    EXPECT_EQ(complaint(complete, {"mesh.specimen=ct"}),
              "case.toml:6: mesh.height = 200 mm must be 1.2 width, or be left out");
}

TEST_F(CaseFile, GradesTowardsAPointOrAlongAnAxis) {
    const std::string grading = "case.toml:8: mesh.grading.0";
    EXPECT_EQ(complaint_about("at = [20.0, 100.0], size", "at = [[1.0, 1.0], [2.0, 2.0]], size"),
              grading + ".at = [[1.0, 1.0], [2.0, 2.0]] must be one point or the two ends of an axis-parallel line");
    EXPECT_EQ(complaint_about("outer_size = 0.2", "outer_size = 0.05"),
              grading + ".outer_size = 0.05 mm must be >= size");
    EXPECT_EQ(complaint_about("radius = 3.0", "radius = -3.0"), grading + ".radius = -3 mm must be >= 0");
}

TEST_F(CaseFile, TakesForcesAtPins) {
    const std::string pin = "[[boundary]]\non = \"pin-top\"\n";
    EXPECT_EQ(read(complete + pin + "force = [0.0, 1.0]\n").boundaries.back().force, Vec2(0.0, 1.0));
    EXPECT_NE(complaint(complete + pin + "displacement = [\"free\", 1.0]\n").find("a pin turns freely"),
              std::string::npos);
    EXPECT_NE(complaint(complete + pin + "traction = [0.0, 1.0]\n").find("not a point"), std::string::npos);
}

// A body is a specimen with its sizes, or a file whose groups have names.
TEST_F(CaseFile, TakesItsMeshFromAFile) {
    std::string text = complete;
    const std::size_t from = text.find("specimen"), to = text.find("[material]");
    text.replace(from, to - from,
                 "file = \"../part.msh\"\n[[region]]\ngroup = \"weld\"\n[region.material]\nyoung = 1e5\n"
                 "poisson = 0.3\n");
    const Case scene = read(text, {"boundary.0.on=pin-top"});
    EXPECT_EQ(scene.mesh.file, (folder_ / "part.msh").string());
    EXPECT_EQ(scene.regions.at(0).group, "weld");
    const std::string resolved = resolved_toml(scene);
    EXPECT_EQ(resolved.find("specimen = "), std::string::npos);
    EXPECT_EQ(resolved.find("outline = "), std::string::npos);
    EXPECT_EQ(read(resolved), scene);
    EXPECT_EQ(complaint(text, {"mesh.size=2"}),
              "--set: mesh.size belongs to a specimen; the mesh is that of mesh.file");
    EXPECT_EQ(complaint(text, {"region.0.outline=[[0, 0], [1, 1]]"}),
              "case.toml:5: region.0 needs outline or group, one of them");
    EXPECT_EQ(complaint(complete + "[[region]]\ngroup = \"weld\"\n[region.material]\nyoung = 1e5\npoisson = 0.3\n"),
              "case.toml:27: region.0.group = \"weld\" needs mesh.file, whose groups have names");
}

TEST_F(CaseFile, TakesHardeningThatSaturates) {
    const Case input = read(complete + "[material.isotropic]\nlaw = \"voce\"\nQ = 90.0\nb = 12.0\n",
                            {"material.kinematic.0.gamma=50"});
    EXPECT_EQ(input.material.isotropic.Q, 90.0);
    EXPECT_EQ(input.material.kinematic.at(0).gamma, 50.0);
    const auto about = [&](const std::string& keys) { return complaint(complete + "[material.isotropic]\n" + keys); };
    for (const char* keys : {"law = \"voce\"\nQ = 90.0\n", "law = \"voce\"\nb = 3.0\n"})
        EXPECT_EQ(about(keys), "case.toml:26: material.isotropic needs a Q other than 0 and b > 0");
    EXPECT_EQ(about("law = \"voce\"\nQ = -299.0\nb = 3.0\n"), "accepted");
    EXPECT_NE(about("law = \"voce\"\nQ = -300.0\nb = 3.0\n").find("needs a Q above -yield_stress"), std::string::npos);
    EXPECT_NE(about("law = \"voce\"\nQ = -200.0\nb = 100.0\n").find("needs a Q b above"), std::string::npos);
    EXPECT_EQ(about("Q = 90.0\n"), "case.toml:27: material.isotropic.Q = 90 belongs to law = \"voce\"");
    for (const char* keys :
         {"law = \"power\"\nn = 0.5\nalpha = 1.0\n", "law = \"power\"\nn = 900.0\nalpha = 1.0\nreference = 700.0\n",
          "law = \"table\"\nplastic_strain = [0.0, 0.1]\nstress = [300.0]\n",
          "law = \"table\"\nplastic_strain = [0.0, 0.1]\nstress = [300.0, 290.0]\n",
          "law = \"table\"\nplastic_strain = [0.0, 0.1]\nstress = [200.0, 290.0]\n"})
        EXPECT_NE(about(keys).find("material.isotropic needs"), std::string::npos) << keys;
}

TEST_F(CaseFile, TakesFriction) {
    EXPECT_EQ(read(complete, {"crack.0.contact.friction=0.2"}).cracks[0].contact->friction, 0.2);
    EXPECT_EQ(complaint_about("friction = 0.0", "friction = -0.2"),
              "case.toml:16: crack.0.contact.friction = -0.2 must be >= 0");
}

TEST_F(CaseFile, RefusesACrackOfTooManyPoints) {
    std::string points = "[[0.0, 100.0]";
    for (int k = 1; k <= 10'000; ++k) points += ", [" + std::to_string(0.002 * k) + ", 100.0]";
    EXPECT_EQ(complaint_about("[[0.0, 100.0], [20.0, 100.0]]", points + "]"),
              "case.toml:15: crack.0.points has 10001 points, at most 10000 are allowed");
}

}  // namespace
}  // namespace stria::test
