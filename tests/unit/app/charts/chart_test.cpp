// Scales, ticks and the SVG made of them.
#include "app/charts/bar_chart.hpp"
#include "app/charts/chart.hpp"
#include "app/charts/scale.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace stria::charts {
namespace {

using Ticks = std::vector<double>;

int occurrences(const std::string& text, const std::string& word) {
    int count = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
    return count;
}

TEST(ChartScale, LinearTicksAreRoundAndEncloseTheRange) {
    EXPECT_EQ(linear_ticks({0.0, 10.0}, 5), (Ticks{0, 2, 4, 6, 8, 10}));
    for (const Range range : {Range{0.013, 0.87}, Range{-3.2, 41.0}, Range{3.2709, 3.2786}, Range{1e6, 7e6}}) {
        const Ticks ticks = linear_ticks(range, 5);
        const double step = ticks[1] - ticks[0];
        EXPECT_LE(ticks.front(), range.low + 2e-3 * step);
        EXPECT_GE(ticks.back(), range.high - 2e-3 * step);
        EXPECT_LE(ticks.size(), 8);
    }
}

TEST(ChartScale, ARangeOfRoundingIsWidened) {
    for (const Range range : {Range{2.0, 2.0}, Range{0.0, 0.0}, Range{3.278543154725, 3.278543154734}}) {
        const Ticks ticks = linear_ticks(range, 5);
        EXPECT_GT(ticks.back() - ticks.front(), 0.1 * range.high);
        EXPECT_LT(ticks.size(), 10);
    }
}

TEST(ChartScale, LogarithmicTicksArePowersOfTen) {
    const Ticks ticks = log_ticks({2e-4, 3.0});
    ASSERT_EQ(ticks.size(), 6);
    EXPECT_DOUBLE_EQ(ticks.front(), 1e-4);
    EXPECT_DOUBLE_EQ(ticks.back(), 10.0);
    EXPECT_THROW(log_ticks({0.0, 1.0}), std::logic_error);
}

TEST(ChartScale, LogarithmicTicksOfLessThanTwoDecadesAreCloser) {
    EXPECT_EQ(log_ticks({0.5, 8.0}), (Ticks{0.5, 1, 2, 5, 10}));
    EXPECT_GE(log_ticks({1.0, 1.0}).size(), 2);
}

TEST(ChartScale, LogarithmicTicksOfManyDecadesAreThinnedAndStillEnclose) {
    const Ticks ticks = log_ticks({3e-13, 0.2});
    EXPECT_LE(ticks.size(), 10);
    EXPECT_LE(ticks.front(), 3e-13);
    EXPECT_GE(ticks.back(), 0.2);
}

TEST(ChartScale, LabelsHaveTheDigitsThatTellThemApart) {
    EXPECT_EQ(tick_labels({0.0, 0.5, 1.0}), (std::vector<std::string>{"0", "0.5", "1"}));
    EXPECT_EQ(tick_labels({1e-13, 1e-12}), (std::vector<std::string>{"1e-13", "1e-12"}));
    const std::vector<std::string> close = tick_labels({3.2785431, 3.2785432, 3.2785433});
    EXPECT_EQ(std::ranges::adjacent_find(close), close.end());
}

TEST(ChartScale, MapsTheFirstAndLastTickOntoThePixels) {
    const Scale linear({0.0, 5.0, 10.0}, false, {200.0, 0.0});
    EXPECT_DOUBLE_EQ(linear(0.0), 200.0);
    EXPECT_DOUBLE_EQ(linear(2.5), 150.0);
    const Scale logarithmic({0.01, 1.0}, true, {0.0, 100.0});
    EXPECT_NEAR(logarithmic(0.1), 50.0, 1e-9);
}

TEST(Chart, ShowsEachPointThatHasAPlace) {
    LineChart chart{.title = "Error", .x_label = "s", .log_y = true};
    chart.curves = {{.name = "a", .x = {1, 2, 3}, .y = {0.1, 0.0, 0.01}}, {.name = "b", .x = {1, NAN}, .y = {0.2, 1}}};
    const std::string text = svg(chart);
    EXPECT_EQ(occurrences(text, "<circle"), 2 + 1);  // one in the legend
    EXPECT_EQ(occurrences(text, "v6h-6z"), 1 + 1);
    EXPECT_EQ(occurrences(text, "<title>Error</title>"), 1);
    EXPECT_EQ(occurrences(text, "nan"), 0);
}

TEST(Chart, IsEmptyWithoutAPoint) {
    EXPECT_EQ(svg(LineChart{.title = "none", .x_label = "", .curves = {{.name = "", .x = {1}, .y = {NAN}}}}), "");
    EXPECT_EQ(svg(BarChart{.title = "none", .x_label = "", .parts = {"p"}, .bars = {{.name = "b", .lengths = {0}}}}),
              "");
}

TEST(Chart, PlacesWordsSideBySide) {
    LineChart chart{.title = "J", .x_label = "mode", .words = {"mpi", "monolithic"}};
    chart.curves = {{.name = "", .x = {0, 1}, .y = {3, 4}}};
    const std::string text = svg(chart);
    EXPECT_EQ(occurrences(text, ">mpi</text>"), 1);
    EXPECT_EQ(occurrences(text, ">monolithic</text>"), 1);
}

TEST(Chart, NamesItsPoints) {
    LineChart chart{.title = "Error", .curves = {{.name = "", .x = {1, NAN, 3}, .y = {3, 4, 5}}}};
    chart.curves.front().points = {"p=1", "p=2", "p=3"};
    const std::string text = svg(chart);
    EXPECT_EQ(occurrences(text, ">p=1</text>"), 1);
    EXPECT_EQ(occurrences(text, ">p=2</text>"), 0);
    EXPECT_EQ(occurrences(text, "p=3: 3, 5</title>"), 1);
}

TEST(Chart, FramesShareTheirAxesAndOneOfThemIsShown) {
    LineChart chart{.title = "Faces", .shown = 1};
    for (const double height : {1.0, 10.0})
        chart.frames.push_back({.name = "", .curves = {{.name = "", .x = {0, 1}, .y = {0, height}, .markers = false}}});
    const std::string text = svg(chart);
    EXPECT_EQ(occurrences(text, "class=\"frame\" data-k=\"0\""), 1);
    EXPECT_EQ(occurrences(text, "class=\"frame shown\" data-k=\"1\""), 1);
    EXPECT_EQ(occurrences(text, ">10</text>"), 1);
    EXPECT_EQ(occurrences(text, "446.0 230.0"), 1);  // the lower one reaches a tenth of the height
}

TEST(Chart, LinesEndWhereAPointIsMissing) {
    const Curve curve{.name = "", .x = {0, 1, 2, 3, 4, 5}, .y = {1, 1, NAN, 1, NAN, 1}, .markers = false};
    const std::string text = svg(LineChart{.title = "t", .curves = {curve}});
    const std::size_t start = text.rfind("<path d=\"");
    const std::string path = text.substr(start, text.find("fill", start) - start);
    EXPECT_EQ(occurrences(path, "M"), 3);
    EXPECT_EQ(occurrences(path, "L"), 1);
    EXPECT_EQ(occurrences(path, "h1"), 2);  // points by themselves
}

TEST(Chart, CurvesOfManyPointsBearNoMarkers) {
    Curve curve{.name = "many"};
    for (int k = 0; k < 1000; ++k) {
        curve.x.push_back(k);
        curve.y.push_back(k);
    }
    EXPECT_EQ(occurrences(svg(LineChart{.title = "t", .curves = {curve}}), "<circle"), 0);
    curve.line = false;
    EXPECT_EQ(occurrences(svg(LineChart{.title = "t", .curves = {curve}}), "h0M"), 999);
}

TEST(Chart, StacksThePartsOfABar) {
    const BarChart chart{
        .title = "time", .x_label = "s", .parts = {"p", "q"}, .bars = {{.name = "a<b", .lengths = {1, 2}}}};
    const std::string text = svg(chart);
    EXPECT_EQ(occurrences(text, "<rect"), 2 + 2);  // two in the legend
    EXPECT_EQ(occurrences(text, "a<b"), 0);
    EXPECT_GT(occurrences(text, "a&lt;b"), 0);
}

}  // namespace
}  // namespace stria::charts
