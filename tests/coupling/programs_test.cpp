// The programs leave the same tables in every mode: two and one to the last byte, the monolithic one to rounding.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "tests/coupling/scenes_of_modes.hpp"
#include "tests/support/program.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria::test {
namespace {

/// history.csv by columns; empty cells are NaN.
std::map<std::string, std::vector<double>> columns_of(const std::string& text) {
    std::istringstream lines(text);
    std::string line, cell;
    std::getline(lines, line);
    std::vector<std::string> names;
    for (std::istringstream header(line); std::getline(header, cell, ',');) names.push_back(cell);
    std::map<std::string, std::vector<double>> columns;
    while (std::getline(lines, line)) {
        std::istringstream row(line);
        for (const std::string& name : names) {
            cell.clear();
            std::getline(row, cell, ',');
            columns[name].push_back(cell.empty() ? std::nan("") : std::stod(cell));
        }
    }
    return columns;
}

class Programs : public testing::Test {
protected:
    [[nodiscard]] std::string run(const std::string& mode, const std::string& ranks = "1",
                                  const std::vector<std::string>& scene = small_scene) const {
        std::vector<std::string> words{
            "run",   shipped_sent,          "--mode", mode, "--fine", ranks, "-o", folder_ / mode, "--quiet",
            "--set", "output.faces=\"all\""};
        for (const std::string& value : scene) words.insert(words.end(), {"--set", value});
        EXPECT_EQ(run_program("stria", words, folder_ / (mode + ".log")), 0) << text_of(folder_ / (mode + ".log"));
        return folder_ / mode;
    }

    void expect_same_tables(const std::string& one, const std::string& other) const {
        for (const char* file : {"/history.csv", "/faces.csv"}) {
            EXPECT_GT(text_of(one + file).size(), 1000U);
            EXPECT_TRUE(text_of(one + file) == text_of(other + file)) << file;
        }
    }
    TemporaryFolder folder_;
};

TEST_F(Programs, TwoProgramsAndOneLeaveTheSameBytes) { expect_same_tables(run("mpi"), run("inprocess")); }

TEST_F(Programs, ThreeProgramsAndOneLeaveTheSameBytes) { expect_same_tables(run("mpi", "3"), run("inprocess", "3")); }

TEST_F(Programs, TwoRanksGrowACrackAsInOneProgram) {
    expect_same_tables(run("mpi", "2", growing_scene), run("inprocess", "2", growing_scene));
}

TEST_F(Programs, TwoRanksSlideAsInOneProgram) {
    expect_same_tables(run("mpi", "2", sliding_scene), run("inprocess", "2", sliding_scene));
}

TEST_F(Programs, MonolithicLeavesTheSameColumnsToRounding) {
    const auto one = columns_of(text_of(run("inprocess") + "/history.csv"));
    const auto whole = columns_of(text_of(run("monolithic") + "/history.csv"));
    ASSERT_EQ(one.size(), whole.size());
    const auto largest = [](const std::vector<double>& values) {
        double size = 0.0;
        for (const double value : values) size = std::max(size, std::abs(value));
        return size;
    };
    for (const auto& [name, values] : one) {
        const std::vector<double>& other = whole.at(name);
        // Spreads are relative to what passes through zero: the difference between the rings is what has to agree.
        const std::string spread_of = name == "J_spread" ? "J" : name == "K_spread" ? "K_I" : "";
        // K_II is zero by symmetry, and the balance is what large numbers leave.
        const double size = largest(one.at(name == "K_II"            ? "K_I"
                                           : name == "balance_error" ? "external_work"
                                           : spread_of.empty()       ? name
                                                                     : spread_of));
        ASSERT_EQ(values.size(), other.size());
        for (std::size_t k = 0; k < values.size(); ++k) {
            const bool both_empty = std::isnan(values[k]) && std::isnan(other[k]);
            const double unit = spread_of.empty() ? 1.0 : std::abs(one.at(spread_of)[k]);
            EXPECT_TRUE(both_empty || unit * std::abs(values[k] - other[k]) <= 1e-9 * size) << name << ' ' << k + 1;
        }
    }
}

}  // namespace
}  // namespace stria::test
