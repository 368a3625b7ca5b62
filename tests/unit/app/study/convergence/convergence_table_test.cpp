// Which results of a study are looked at for convergence, and what is said of them.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "app/study/convergence/convergence_table.hpp"

namespace stria::test {
namespace {

using study::Axis;
using study::convergence_rows;
using study::ConvergenceRow;
using study::Report;
using study::Settings;

study::Row variant(Settings settings, std::map<std::string, double> values) {
    study::Row row;
    row.settings = std::move(settings);
    row.outcome.values = std::move(values);
    return row;
}

Report of_axes(std::vector<Axis> axes) {
    Report report;
    report.axes = std::move(axes);
    return report;
}

TEST(ConvergenceTable, HasARowForEachResultThatElementsChangeAndCombination) {
    Report report = of_axes({{"fine.refine", {"8", "16", "32"}}, {"load.scale", {"1", "2"}}});
    for (const double refine : {8.0, 16.0, 32.0})
        for (const double scale : {1.0, 2.0})
            report.rows.push_back(
                variant({{"fine.refine", fmt::format("{:g}", refine)}, {"load.scale", fmt::format("{:g}", scale)}},
                        {{"K_op_end", scale * (100.0 + 80.0 / refine)}, {"a_end", 5.0}}));
    const std::vector<ConvergenceRow> rows = convergence_rows(report);
    ASSERT_EQ(rows.size(), 2U);
    for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_EQ(rows[k].result, "K_op_end");
        EXPECT_EQ(rows[k].along, "fine.refine");
        EXPECT_EQ(rows[k].others, k == 0 ? "load.scale=1" : "load.scale=2");
        EXPECT_EQ(rows[k].sizes, 3);
        EXPECT_NEAR(rows[k].found.order, 1.0, 1e-9);
        EXPECT_NEAR(rows[k].found.limit, k == 0 ? 100.0 : 200.0, 1e-9);
    }
    EXPECT_EQ(sentence(rows[0]),
              "K_op_end at load.scale=1: 102.5 MPa sqrt(mm) on the smallest elements, 100 in the limit "
              "(order 1.00), uncertain by 3 %");
    EXPECT_EQ(cells(rows[0]).size(), study::convergence_columns().size());
    EXPECT_NE(convergence_section(rows).find("<td class=\"word\">load.scale=2</td>"), std::string::npos);
}

// mesh.size falls where fine.refine grows.
TEST(ConvergenceTable, KnowsWhichElementsAreSmaller) {
    Report report = of_axes({{"mesh.size", {"1", "2"}}});
    report.rows = {variant({{"mesh.size", "1"}}, {{"life", 115.0}}), variant({{"mesh.size", "2"}}, {{"life", 130.0}})};
    const std::vector<ConvergenceRow> rows = convergence_rows(report);
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows[0].found.finest, 115.0);
    EXPECT_EQ(rows[0].found.limit, 100.0);
    EXPECT_EQ(sentence(rows[0]),
              "life: 115 cycles on the smallest elements, 100 in the limit by first order, uncertain by 39 %");
}

TEST(ConvergenceTable, LeavesOutWhatHasNoTwoSizes) {
    Report report = of_axes({{"mesh.size", {"1", "2", "4"}}});
    report.rows = {variant({{"mesh.size", "1"}}, {{"J", 1.0}}), variant({{"mesh.size", "2"}}, {}),
                   variant({{"mesh.size", "4"}}, {})};
    EXPECT_TRUE(convergence_rows(report).empty());
    EXPECT_EQ(study::convergence_section({}), "");
    report.rows[1].outcome.values = {{"J", 1.0}, {"CMOD", 0.1}, {"opening_at_min", 1e-16}};
    report.rows[0].outcome.values = {{"J", 1.0}, {"CMOD", 0.1}, {"opening_at_min", -3e-16}};
    EXPECT_TRUE(convergence_rows(report).empty()) << "equal, or nothing beside others in mm";
    Report other = of_axes({{"fine.beta", {"1", "2"}}});
    other.rows = {variant({{"fine.beta", "1"}}, {{"J", 1.0}}), variant({{"fine.beta", "2"}}, {{"J", 2.0}})};
    EXPECT_TRUE(convergence_rows(other).empty());
}

}  // namespace
}  // namespace stria::test
