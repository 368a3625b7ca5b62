// `stria check`: what it says of K, and how far that is from converged.
#include <gtest/gtest.h>

#include <fmt/format.h>
#include <fstream>

#include "tests/support/program.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria::test {
namespace {

constexpr const char* plate_of_elements = R"(
units = "N-mm-MPa"
mesh = {{ specimen = "plate", width = 20.0, height = 40.0, size = {} }}
material = {{ young = 200e3, poisson = 0.3, yield_stress = 300.0 }}
crack = [ {{ points = [[0.0, 20.1], [5.0, 20.1]] }} ]
boundary = [ {{ on = "top", traction = [0.0, 1.0] }}, {{ on = "bottom", traction = [0.0, -1.0] }} ]
load = {{ blocks = [ {{ cycles = 1, max = 10.0, ratio = 0.0 }} ] }}
)";

class Check : public testing::Test {
protected:
    std::string said_of(double size) {
        std::ofstream(folder / "case.toml") << fmt::format(plate_of_elements, size);
        EXPECT_EQ(run_program("stria", {"check", folder / "case.toml"}, folder / "log"), 0);
        return text_of(folder / "log");
    }

    TemporaryFolder folder;
};

TEST_F(Check, SaysHowFarKIsFromConverged) {
    const std::string changes = "on elements half as large", warns = "# warning: tip 0: K changes by ";
    const std::string coarse = said_of(1.25), fine = said_of(0.25);
    EXPECT_NE(coarse.find("# tip 0: K_I = "), std::string::npos) << coarse;
    EXPECT_NE(coarse.find(changes), std::string::npos) << coarse;
    EXPECT_NE(coarse.find(warns), std::string::npos) << coarse;
    EXPECT_NE(fine.find(changes), std::string::npos) << fine;
    EXPECT_EQ(fine.find(warns), std::string::npos) << fine;
}

}  // namespace
}  // namespace stria::test
