// The page of a run: its numbers are those of the tables, it needs nothing else, and it stays small.
#include "app/report/report.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <sstream>

#include "app/report/cycle_figures.hpp"
#include "app/report/record/face_states.hpp"
#include "app/report/report_page.hpp"
#include "common/error.hpp"
#include "tests/support/counted_words.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria::report {
namespace {

using test::count;

/// A crack that grows by 0.01 mm in each cycle of four increments, with faces at the extremes of each.
void write_long_run(const test::TemporaryFolder& folder, int cycles, int stations) {
    std::ofstream history(folder / "history.csv"), table(folder / "cycles.csv"), faces(folder / "faces.csv");
    history << "increment,cycle,load_factor,load,tip,x,y,a,K_I,K_II,J,CMOD,opening,newton_iterations,contact_length,"
               "plastic_zone,dissipation,external_work,stored_energy,released_energy,balance_error,"
               "frictional_dissipation\n";
    table << "cycle,tip,a,da,dN,K_max,K_min,K_op,K_cl,U,dK_eff,forward_zone,cyclic_zone,newton_iterations,"
             "fine_points,fine_unknowns,wall_s,forward_zone_axis,cyclic_zone_axis,K_op_contact,K_op_offset,"
             "K_op_tension,N\n";
    faces << "increment,crack,s,x,y,opening,slip,pressure,shear,status\n";
    for (int cycle = 1, increment = 0; cycle <= cycles; ++cycle) {
        const double a = 10.0 + 0.01 * cycle, K = 300.0 + 0.1 * cycle / 3.0, K_op = K * (0.3 + 0.1 / cycle);
        for (int k = 0; k < 20; ++k) {
            ++increment;
            const double load = 1000.0 / 3.0 * std::cos(0.3 * k);
            history << fmt::format("{},{},{},{},0,{},{},{},{},1e-7,0.4,{},{},4,0.1,0.2,{},{},{},0,{},0\n", increment,
                                   cycle, load / 7, load, a, a * a / 100, a, K, load / 1e5 / 3, load / 1e6 / 3, a / 3,
                                   a / 7, a / 9, a / 1e7);
            if (k % 10 != 9) continue;
            for (int station = 0; station < stations; ++station)
                faces << fmt::format("{0},0,{1},{1},0,{2},0,{3},0,1\n", increment, station * a / stations,
                                     (stations - station) * 1e-5 / 3, k == 9 ? station / 3.0 : 0.0);
        }
        table << fmt::format("{},0,{},0.01,3,{},30,{},{},{},{},0.3,0.1,80,100,50,0.5,0.2,0.1,{},,,{}\n", cycle, a, K,
                             K_op, K_op, (K - K_op) / (K - 30), K - K_op, K_op, 3.0 * cycle);
    }
}

/// The table behind the link of that name, as a file would hold it.
std::string table_in(const std::string& page, const std::string& name) {
    const std::string begin = "download=\"" + name + "\" href=\"data:text/csv;charset=utf-8,";
    const std::size_t start = page.find(begin);
    if (start == std::string::npos) return "";
    const std::size_t from = start + begin.size();
    std::string text;
    for (std::size_t k = from; page[k] != '"'; ++k) {
        if (page[k] != '%') {
            text += page[k];
            continue;
        }
        text += static_cast<char>(std::stoi(page.substr(k + 1, 2), nullptr, 16));
        k += 2;
    }
    return text;
}

std::vector<std::string> split(const std::string& text, char at) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, at);) parts.push_back(part);
    return parts;
}

/// The cells of some columns, row by row.
std::string columns_of(const std::string& csv, const std::vector<std::string>& names) {
    const std::vector<std::string> lines = split(csv, '\n'), head = split(lines.front(), ',');
    std::string text;
    for (const std::string& line : lines) {
        const std::vector<std::string> cells = split(line, ',');
        for (const std::string& name : names)
            text += cells[static_cast<std::size_t>(std::ranges::find(head, name) - head.begin())] + ';';
        text += '\n';
    }
    return text;
}

TEST(Report, NumbersAreThoseOfTheTablesToTheLastDigit) {
    const test::TemporaryFolder folder;
    write_long_run(folder, 7, 5);
    const std::string page = page_of(read_run(folder / ""));
    const std::string cycles = test::text_of(folder / "cycles.csv"), history = test::text_of(folder / "history.csv");
    const auto expect_same = [&](const std::string& table, const std::string& file,
                                 const std::vector<std::string>& columns) {
        ASSERT_NE(table_in(page, table), "") << table;
        EXPECT_EQ(columns_of(table_in(page, table), columns), columns_of(file, columns)) << table;
    };
    expect_same("a-N-tip-0.csv", cycles, {"N", "a"});
    expect_same("opening-loads-tip-0.csv", cycles, {"a", "K_max", "K_op", "K_op_contact", "K_op_offset"});
    expect_same("zones-tip-0.csv", cycles, {"forward_zone", "cyclic_zone_axis"});
    expect_same("work.csv", history, {"increment", "external_work", "balance_error"});
    EXPECT_EQ(count(columns_of(table_in(page, "way-tip-0.csv"), {"x", "y"}), "\n"), 8);  // one place a cycle
    expect_same("iterations.csv", history, {"increment", "newton_iterations"});
    expect_same("faces-0.csv", test::text_of(folder / "faces.csv"), {"increment", "s", "opening", "pressure"});
}

/// Of a run with these rows: cycle, tip, a, da, dN, K_max, K_min and dK_eff.
charts::Sheet rates_of(const std::string& rows, std::size_t tip = 0) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "history.csv") << "increment,cycle,load_factor,tip,a\n";
    std::ofstream(folder / "cycles.csv") << "cycle,tip,a,da,dN,K_max,K_min,dK_eff\n" << rows;
    return growth_rates(read_run(folder / ""), tip);
}

TEST(Report, GrowthRatesAreSecantsAtTheMeanOfTheirRanges) {
    const charts::Sheet rates = rates_of("1,0,10,0,0,300,-30,200\n1,1,5,0,0,9,9,9\n2,0,10.5,0.5,1000,310,10,220\n");
    EXPECT_EQ(rates["a"], (std::vector<double>{10.25}));
    EXPECT_EQ(rates["dadN"], (std::vector<double>{0.0005}));
    EXPECT_EQ(rates["dK"], (std::vector<double>{300.0}));  // what lies in compression does not count
    EXPECT_EQ(rates["dK_eff"], (std::vector<double>{210.0}));
}

// Behind a turn, or under a load that varies.
TEST(Report, GrowthRatesAreOfAllThatIsCounted) {
    const charts::Sheet rates = rates_of("1,0,10,0,0,290,0,190\n2,0,10,0,0,300,0,200\n3,0,10.5,0.5,0,400,0,400\n"
                                         "4,0,11,0.5,1000,310,0,220\n5,0,11,0,0,320,0,230\n");
    EXPECT_EQ(rates["a"], (std::vector<double>{10.5}));
    EXPECT_EQ(rates["dadN"], (std::vector<double>{0.001}));
    EXPECT_EQ(rates["dK_eff"], (std::vector<double>{210.0}));
}

// The length of their crack is the mean of both.
TEST(Report, GrowthRatesAreThoseOfEachTip) {
    const std::string rows = "1,0,4,0,0,300,0,200\n1,1,4,0,0,200,0,100\n"
                             "2,0,4.25,0.5,1000,310,0,220\n2,1,4.25,0,1000,210,0,110\n";
    EXPECT_EQ(rates_of(rows, 0)["dadN"], (std::vector<double>{0.0005}));
    EXPECT_EQ(rates_of(rows, 1)["dadN"], (std::vector<double>{0.0}));
}

TEST(Report, OfAThousandCyclesIsBelowTwoMegabytes) {
    const test::TemporaryFolder folder;
    write_long_run(folder, 1000, 60);
    write_report(folder / "");
    const std::string page = test::text_of(folder / "report.html");
    EXPECT_LT(page.size(), 2'000'000);
    EXPECT_EQ(count(columns_of(table_in(page, "a-N-tip-0.csv"), {"N"}), "\n"), 1001);
}

TEST(Report, NeedsNothingButItself) {
    const test::TemporaryFolder folder;
    write_long_run(folder, 5, 5);
    const std::string page = page_of(read_run(folder / ""));
    EXPECT_EQ(count(page, "http"), count(page, "xmlns=\"http://www.w3.org/2000/svg\""));
    EXPECT_EQ(count(page, "href="), count(page, "href=\"data:text/csv"));
    for (const char* part : {"src=", "<link", "@import", "url(", "nan", "inf"}) EXPECT_EQ(count(page, part), 0) << part;
}

TEST(Report, OneFrameOfEachChartIsShownAndTheSliderReachesAll) {
    const test::TemporaryFolder folder;
    write_long_run(folder, 5, 5);
    const std::string page = page_of(read_run(folder / ""));
    EXPECT_EQ(count(page, "min=\"0\" max=\"9\""), 1);
    // The faces, those behind the tip, their pressure and the name of the increment; the last state in which they touch
    // is the ninth.
    EXPECT_EQ(count(page, "class=\"frame shown\" data-k=\"8\""), 4);
    EXPECT_EQ(count(page, "class=\"frame shown\""), 4);
    EXPECT_EQ(count(page, "data-k=\"0\""), 4);
}

TEST(Report, SlidersShowWholeCyclesEvenlyAndTheLast) {
    const test::TemporaryFolder folder;
    write_long_run(folder, 100, 2);
    const RunRecord run = read_run(folder / "");
    const std::vector<double> written = written_increments(run);
    ASSERT_EQ(written.size(), 200);
    const std::vector<double> chosen = chosen_increments(run, written, 20);
    ASSERT_EQ(chosen.size(), 20);
    EXPECT_EQ(chosen.back(), 2000);
    for (std::size_t k = 0; k < chosen.size(); k += 2) EXPECT_EQ(chosen[k + 1], chosen[k] + 10);
    EXPECT_EQ(chosen[2] - chosen[0], 200);
}

TEST(Report, SaysFirstWhatTheReaderHasToKnow) {
    const test::TemporaryFolder folder;
    write_long_run(folder, 2, 2);
    EXPECT_EQ(warnings_of(read_run(folder / "")).front(),
              "The run has not ended, or was cut off: results up to increment 40.");
    std::ofstream(folder / "summary.json")
        << R"({"status": "failed", "flowing_rings": 3, "yield_warnings": 0, "warnings": ["tip 0: a <sentence>"]})";
    const std::vector<std::string> warnings = warnings_of(read_run(folder / ""));
    ASSERT_EQ(warnings.size(), 3);
    EXPECT_EQ(warnings[0], "The run has failed: results up to increment 40.");
    EXPECT_EQ(warnings[1], "tip 0: a <sentence>");
    EXPECT_EQ(warnings[2].substr(0, 12), "3 increments");
    const std::string page = page_of(read_run(folder / ""));
    EXPECT_LT(page.find("a &lt;sentence&gt;"), page.find("<svg"));
}

TEST(Report, AFolderWithoutARunIsASentence) {
    const test::TemporaryFolder folder;
    EXPECT_THROW(write_report(folder / ""), CaseError);
    std::ofstream(folder / "history.csv") << "increment,J\n1,2\n";
    EXPECT_THROW(write_report(folder / ""), CaseError);
}

}  // namespace
}  // namespace stria::report
