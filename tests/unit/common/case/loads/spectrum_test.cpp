// Load spectra from CSV files, good and bad ones.
#include "common/case/loads/spectrum.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "common/error.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria {
namespace {

class Spectrum : public testing::Test {
protected:
    std::vector<LoadBlock> read(const std::string& text, bool repeats = false) {
        std::ofstream(folder / "s.csv") << text;
        return read_spectrum(folder / "s.csv", {}, repeats).blocks;
    }
    std::string complaint(const std::string& text) {
        const std::string said = test::refusal_of([&] { read(text); });
        return said.substr(said.rfind('/') + 1);
    }
    test::TemporaryFolder folder;
};

TEST_F(Spectrum, ListsCycles) {
    const std::vector<LoadBlock> expected{{1, 10.0, -2.5}, {1, 20.0, 0.0}};
    EXPECT_EQ(read("max,min\n10,-2.5\n20,0\n"), expected);
    EXPECT_EQ(read("min, cycles, max\r\n1, 3, 4\r\n\r\n"), (std::vector<LoadBlock>{{3, 4.0, 1.0}}));
}

TEST_F(Spectrum, MayComeFromASpreadsheet) {
    EXPECT_EQ(read("\xEF\xBB\xBF\"max\",\"min\"\r\n\"+0.8\",-0.1\r\n"), (std::vector<LoadBlock>{{1, 0.8, -0.1}}));
}

TEST_F(Spectrum, MayBeginWithEmptyLines) {
    EXPECT_EQ(read("\n \r\nmax,min\n\n4,1\n"), (std::vector<LoadBlock>{{1, 4.0, 1.0}}));
    EXPECT_EQ(read("\xEF\xBB\xBF\r\nmax,min\r\n4,1\r\n"), (std::vector<LoadBlock>{{1, 4.0, 1.0}}));
    EXPECT_EQ(complaint("\n\nmax,min\n10,-2\n\n1,2\n"), "s.csv:6: load.spectrum: must keep min < max");
    EXPECT_EQ(complaint("\n\nmax\n1\n"), "s.csv:3: load.spectrum: must name columns max and min, or turning_point");
    EXPECT_EQ(complaint("\nmax,max\n1,2\n"), "s.csv:2: load.spectrum: column \"max\" is given twice");
    EXPECT_EQ(complaint("\n\n"), "s.csv: load.spectrum: cannot be read");
}

TEST_F(Spectrum, OrTurningPoints) {
    EXPECT_EQ(read("turning_point\n-1\n3\n5\n5\n2\n4\n1\n9\n"), (std::vector<LoadBlock>{{1, 5.0, 2.0}, {1, 4.0, 1.0}}));
}

// Gone through again and again it has no ends: each turn counts, wherever the file begins.
TEST_F(Spectrum, ASequenceThatRepeatsFollowsOnItsOwnEnd) {
    const std::vector<LoadBlock> from_maximum{{1, 100.0, -50.0}, {1, 150.0, 40.0}, {1, 80.0, 10.0}};
    EXPECT_EQ(read("turning_point\n10\n100\n-50\n150\n40\n80\n", true), from_maximum);
    EXPECT_EQ(read("turning_point\n20\n100\n-50\n150\n40\n80\n10\n", true), from_maximum);
    EXPECT_EQ(read("turning_point\n10\n100\n-50\n150\n40\n80\n20\n", true), from_maximum);
    EXPECT_EQ(read("turning_point\n100\n-50\n150\n40\n80\n10\n", true), from_maximum);
    EXPECT_EQ(read("turning_point\n100\n-50\n150\n40\n80\n10\n90\n", true), from_maximum);
    EXPECT_EQ(read("turning_point\n60\n-50\n150\n40\n80\n10\n100\n", true),
              (std::vector<LoadBlock>{{1, 100.0, -50.0}, {1, 150.0, 40.0}, {1, 80.0, 10.0}}));
}

// What other programs write: a remark first, no names, semicolons.
TEST_F(Spectrum, SaysHowTheFirstLineIsWritten) {
    const std::string names = "must be max, min and cycles, or turning_point alone; the first line holds the names";
    EXPECT_EQ(complaint("# flight 7\nmax,min\n10,2\n"),
              "s.csv:1: load.spectrum: column \"# flight 7\" is not known, " + names);
    EXPECT_EQ(complaint("-10\n2.5e1\n"), "s.csv:1: load.spectrum: column \"-10\" is not known, " + names);
    EXPECT_EQ(complaint("max;min\n1,5;0,2\n"),
              "s.csv:1: load.spectrum: column \"max;min\" is not known, must be max, min and cycles, or turning_point "
              "alone; commas stand between cells, and points in numbers");
}

// Lines are those of the file, with the empty ones that are passed over.
TEST_F(Spectrum, SaysTheLineThatAnEditorShows) {
    EXPECT_EQ(complaint("max,min\n10,-2\n\n\n1,2\n"), "s.csv:5: load.spectrum: must keep min < max");
    EXPECT_EQ(complaint("max,min\n\n10,-2\n\n1\n"),
              "s.csv:5: load.spectrum: has not as many cells as the line of names");
    EXPECT_EQ(complaint("turning_point\r\n1\r\n \r\n2\r\nnan\r\n"), "s.csv:5: load.spectrum: must be a number");
}

TEST_F(Spectrum, HasEachColumnOnce) {
    EXPECT_EQ(complaint("max,min,max\n10,-2,30\n20,0,40\n"), "s.csv:1: load.spectrum: column \"max\" is given twice");
    EXPECT_EQ(complaint("turning_point, \"turning_point\"\n1,2\n0,3\n"),
              "s.csv:1: load.spectrum: column \"turning_point\" is given twice");
}

TEST_F(Spectrum, SaysWhatIsWrongAndWhere) {
    EXPECT_EQ(complaint("max,min\n10,-2\n1,2\n"), "s.csv:3: load.spectrum: must keep min < max");
    EXPECT_EQ(complaint("max,min\n10,x\n"), "s.csv:2: load.spectrum: max and min must be numbers");
    EXPECT_EQ(complaint("max,min\n10,2\n10\n"), "s.csv:3: load.spectrum: has not as many cells as the line of names");
    EXPECT_EQ(complaint("max,min,cycles\n10,2,1.5\n"), "s.csv:2: load.spectrum: cycles must be a whole number >= 1; "
                                                       "half cycles of a count go into a list of turning points");
    EXPECT_EQ(complaint("max\n1\n"), "s.csv:1: load.spectrum: must name columns max and min, or turning_point");
    EXPECT_EQ(complaint("max,min,cycle\n2,1,9\n"),
              "s.csv:1: load.spectrum: column \"cycle\" is not known, must be max, min and cycles, or turning_point "
              "alone");
    EXPECT_EQ(complaint("max,min\n1,1\n"), "s.csv:2: load.spectrum: must keep min < max");
    EXPECT_EQ(complaint("max,min\n"), "s.csv: load.spectrum: holds no cycle");
    EXPECT_EQ(complaint("turning_point\n1\n2\nx\n"), "s.csv:4: load.spectrum: must be a number");
    EXPECT_THROW(read_spectrum(folder / "none.csv"), CaseError);
}

}  // namespace
}  // namespace stria
