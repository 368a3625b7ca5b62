// The tables and figures that stand beside the shipped cases are those of a run.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/io/number_table.hpp"
#include "tests/end_to_end/figures.hpp"
#include "tests/support/program.hpp"
#include "tests/support/sent_analysis.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria::test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::filesystem::path folder_of_case(const std::string& name) {
    return std::filesystem::path(source_folder) / "cases" / name;
}

Case changed(const std::string& name, std::vector<std::string> values) {
    return read_case(folder_of_case(name) / "case.toml", std::move(values));
}

/// Of the last six cycles; NaN where the crack never closes in them.
double mean_opening(const std::vector<coarse::CycleResult>& cycles) {
    double sum = 0.0;
    for (auto cycle = cycles.end() - 6; cycle != cycles.end(); ++cycle)
        sum += cycle->opening.K_op > cycle->K_min ? cycle->opening.K_op / cycle->K_max / 6.0 : nan;
    return sum;
}

/// The first cycles of cases/overload against its table.
void expect_overload_table(const std::vector<coarse::CycleResult>& cycles) {
    const NumberTable table = read_table(folder_of_case("overload") / "reference/cycles.csv");
    ASSERT_LE(cycles.size(), table.rows);
    for (std::size_t k = 0; k < cycles.size(); ++k) {
        const coarse::CycleResult& cycle = cycles[k];
        EXPECT_NEAR(cycle.a, table["a"][k], 1e-9) << k;
        EXPECT_NEAR(cycle.K_max, table["K_max"][k], 1e-6 * cycle.K_max) << k;
        EXPECT_NEAR(cycle.opening.K_op, table["K_op"][k], 0.002 * cycle.K_max) << k;  // how well it is located
        EXPECT_NEAR(cycle.J_max, table["J_max"][k], 1e-6 * cycle.J_max) << k;
        EXPECT_NEAR(cycle.forward, table["forward_zone"][k], 1e-9) << k;
        EXPECT_NEAR(cycle.cyclic, table["cyclic_zone"][k], 1e-9) << k;
    }
}

TEST(ShippedCases, OverloadBeginsAsItsTableDoes) {
    const auto cycles = run_cycles(changed("overload", {}), 3);
    EXPECT_EQ(cycles.size(), 3U);
    expect_overload_table(cycles);
}

TEST(ShippedCases, OverloadIsThatOfItsTableLong) {
    const auto cycles = run_cycles(changed("overload", {}));
    EXPECT_EQ(cycles.size(), 61U);
    expect_overload_table(cycles);
}

TEST(ShippedCases, AWeldOpensItsCrackAsItsReadmeSays) {
    const std::vector<double> row = figures_of("weld", "-2");
    Case input = changed("weld", {});
    const coarse::CycleResult with = run_cycles(input).back();
    EXPECT_NEAR(with.K_initial, row.at(0), 0.05);
    EXPECT_NEAR(with.K_max, row.at(1), 0.05);
    EXPECT_NEAR(with.K_min, row.at(2), 0.05);
    EXPECT_NEAR(with.opening.K_op, row.at(3), 0.002 * with.K_max);
    const auto share = [](const coarse::CycleResult& cycle) {
        return (cycle.K_max - cycle.opening.K_op) / (cycle.K_max - cycle.K_min);
    };
    EXPECT_NEAR(share(with), row.at(4), 0.002);
    input.initial_stress.reset();
    EXPECT_NEAR(share(run_cycles(input).back()), row.at(5), 0.002);
}

TEST(ShippedCases, ParisLifeLastsAsLongAsItsReadmeSaysLong) {
    for (const std::string driving : {"dK", "dK_eff"}) {
        double life = 0.0;
        for (const coarse::CycleResult& cycle : run_cycles(changed("paris-life", {"growth.driving=" + driving})))
            life += cycle.dN;
        const std::string row = driving == "dK" ? "dK = K_max - K_min" : "dK_eff = K_max - K_op";
        EXPECT_NEAR(life, figures_of("paris-life", row).at(0), 0.001 * life) << driving;
    }
}

/// Cycles up to a length, mm.
double life_to(double a, const std::vector<std::string>& values) {
    double life = 0.0;
    for (const coarse::CycleResult& cycle : run_cycles(changed("paris-life", values))) {
        if (cycle.a >= a) return life + cycle.dN * (1.0 - (cycle.a - a) / cycle.da);
        life += cycle.dN;
    }
    return life;
}

// Elements of 0.1 mm: chosen increments are 0.1 mm.
TEST(ShippedCases, ParisLifeDoesNotDependOnIncrementsFourTimesFinerLong) {
    const double chosen = life_to(13.0, {"growth.increment=auto"});
    const double finer = life_to(13.0, {"growth.increment=0.02495", "load.blocks.0.cycles=100"});
    EXPECT_NEAR(chosen, finer, 0.005 * finer);  // measured: 0.0014
}

TEST(ShippedCases, ResidualStressShortensTheLifeOfTheTJointAsItsReadmeSaysLong) {
    const auto life = [](const std::vector<coarse::CycleResult>& cycles) {
        double sum = 0.0;
        for (const coarse::CycleResult& cycle : cycles) sum += cycle.dN;
        return sum;
    };
    const std::vector<std::string> relaxed = {"region.0.initial_stress.xx=0", "region.0.initial_stress.yy=0"};
    const auto cycles = run_cycles(changed("t-joint", {})), relaxed_cycles = run_cycles(changed("t-joint", relaxed));
    for (const char* length : {"0.5", "1", "2", "4", "8"}) {
        const auto at_length = [&](const coarse::CycleResult& cycle) {
            return std::abs(cycle.a - std::stod(length)) < 1e-9;
        };
        const std::vector<double> figures = figures_of("t-joint", length);
        const auto with = std::ranges::find_if(cycles, at_length),
                   without = std::ranges::find_if(relaxed_cycles, at_length);
        ASSERT_NE(with, cycles.end());
        EXPECT_NEAR(with->K_max, figures.at(0), 0.06) << length;
        EXPECT_NEAR(with->K_min, figures.at(1), 0.06) << length;
        EXPECT_NEAR(without->K_max, figures.at(2), 0.06) << length;
    }
    const double with = life(cycles), without = life(relaxed_cycles);
    EXPECT_NEAR(with, figures_of("t-joint", "with the residual stress").at(0), 1e-3 * with);
    EXPECT_NEAR(without, figures_of("t-joint", "without").at(0), 1e-3 * without);
}

TEST(ShippedCases, ThreeHolesSteerTheCrackAsTheirReadmeSaysLong) {
    const TemporaryFolder folder;
    const std::string input = (folder_of_case("three-holes") / "case.toml").string();
    ASSERT_EQ(run_program("stria", {"run", input, "-o", folder / "out", "--mode", "inprocess", "--no-report"},
                          folder / "log"),
              0);
    const NumberTable history = read_table(folder / "out/history.csv");
    for (const int step : {16, 32, 48, 64, 80}) {
        const std::vector<double> place = figures_of("three-holes", std::to_string(step));
        double nearest = 1e9;
        for (std::size_t row = 0; row < history.rows; ++row)
            nearest = std::min(nearest, std::hypot(history["x"][row] - place.at(0), history["y"][row] - place.at(1)));
        EXPECT_LT(nearest, 0.02) << "step " << step;
    }
    const double radius = 6.35, to_centre = std::hypot(history["x"].back() - 152.4, history["y"].back() - 120.65);
    EXPECT_LT(to_centre, radius + 2.54);  // the next step leaves less than an element before the middle hole
}

/// A row of opening loads over load ratios in a README against runs at some of them.
void expect_openings(const std::string& name, const std::string& plane,
                     const std::map<std::string, std::size_t>& ratios) {
    const std::vector<double> row = figures_of(name, "plane " + plane);
    for (const auto& [ratio, column] : ratios) {
        const double found =
            mean_opening(run_cycles(changed(name, {"load.blocks.0.ratio=" + ratio, "model.plane=" + plane})));
        if (std::isnan(row.at(column)))
            EXPECT_TRUE(std::isnan(found)) << name << ", " << plane << ", R = " << ratio;
        else
            EXPECT_NEAR(found, row.at(column), 0.0015) << name << ", " << plane << ", R = " << ratio;
    }
}

TEST(ShippedCases, CtClosureOpensWhereItsReadmeSaysLong) {
    expect_openings("ct-closure", "strain", {{"0.1", 0}, {"0.3", 1}});
    expect_openings("ct-closure", "stress", {{"0.1", 0}, {"0.3", 1}, {"0.5", 2}, {"0.7", 3}});
}

TEST(ShippedCases, SentClosureOpensWhereItsReadmeSaysLong) {
    expect_openings("sent-closure", "stress", {{"-1.0", 0}, {"0.0", 1}, {"0.3", 3}, {"0.7", 5}});
    expect_openings("sent-closure", "strain", {{"-1.0", 0}, {"0.0", 1}, {"0.1", 2}, {"0.3", 3}});
}

}  // namespace
}  // namespace stria::test
