#include "common/case/checks/boundary_checks.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "common/case/schema/case_file.hpp"
#include "common/error.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria {
namespace {

// 12 lines.
const std::string specimen = R"(units = "N-mm-MPa"
[material]
young = 200e3
poisson = 0.3
[load]
blocks = [ { cycles = 3, max = 50.0, ratio = -1.0 } ]
[[boundary]]
on = "pin-bottom"
force = [0.0, -1.0]
[mesh]
specimen = "ct"
width = 50.0
)";
const std::string point = "on = \"point\"\nat = [0.0, 0.0]\n", pin = "on = \"pin-top\"\n", edge = "on = \"top\"\n";
const std::string pull = "[0.0, 1.0]\n", slope = "traction_gradient = [[1.0, 0.0], [0.0, 0.0]]\n";

/// Of a case with one more boundary that says this.
std::string complaint_about_boundary(const std::string& says) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "case.toml") << specimen << "size = 5.0\n[[boundary]]\n" << says;
    const std::string said = test::refusal_of([&] { return read_case(folder / "case.toml", {}); });
    return said.substr(said.rfind('/') + 1);
}

TEST(BoundaryChecks, EachKeyHasItsPlaces) {
    for (const std::string& says :
         {point + "force = " + pull, point + "displacement = " + pull, pin + "force = " + pull,
          edge + "displacement = " + pull, edge + "traction = " + pull, edge + slope, edge + "pressure = 1.0\n"})
        EXPECT_EQ(complaint_about_boundary(says), "accepted") << says;
    const std::string an_edge = "needs an edge, not a point";
    for (const auto& [says, complaint] :
         {std::pair(point + "traction = " + pull, "17: boundary.1.traction = [0.0, 1.0] " + an_edge),
          {point + "pressure = 1.0\n", "17: boundary.1.pressure = 1 " + an_edge},
          {point + slope, "17: boundary.1.traction_gradient = [[1.0, 0.0], [0.0, 0.0]] " + an_edge},
          {pin + "traction = " + pull, "16: boundary.1.traction = [0.0, 1.0] " + an_edge},
          {pin + "pressure = 1.0\n", "16: boundary.1.pressure = 1 " + an_edge},
          {pin + slope, "16: boundary.1.traction_gradient = [[1.0, 0.0], [0.0, 0.0]] " + an_edge},
          {pin + "displacement = " + pull, "16: boundary.1.displacement = [0.0, 1.0] needs an edge or a point: a pin "
                                           "turns freely and carries a force"},
          {edge + "force = " + pull, "16: boundary.1.force = [0.0, 1.0] needs on = \"point\" or a pin"},
          {edge + "at = [0.0, 0.0]\npressure = 1.0\n", "16: boundary.1.at = [0.0, 0.0] needs on = \"point\""},
          {pin + "at = [0.0, 0.0]\nforce = " + pull, "16: boundary.1.at = [0.0, 0.0] needs on = \"point\""},
          {"on = \"point\"\nforce = " + pull, "14: boundary.1 on = \"point\" needs at = [x, y]"},
          {edge, "14: boundary.1 needs a displacement, traction, pressure or force"}})
        EXPECT_EQ(complaint_about_boundary(says), "case.toml:" + complaint);
}

TEST(BoundaryChecks, AGradientOfZeroSaysNothing) {
    const std::string zero = "traction_gradient = [[0.0, 0.0], [0.0, 0.0]]\n";
    EXPECT_EQ(complaint_about_boundary(point + "force = " + pull + zero), "accepted");
    EXPECT_EQ(complaint_about_boundary(pin + "force = " + pull + zero), "accepted");
}

}  // namespace
}  // namespace stria
