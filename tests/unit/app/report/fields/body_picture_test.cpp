#include "app/report/fields/body_picture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "app/report/fields/field_cells.hpp"
#include "coarse/fields/vtk_files.hpp"
#include "tests/support/counted_words.hpp"
#include "tests/support/opened_pair.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria::report {
namespace {

using test::count;
using test::opened_pair;

/// A plate of 10 mm by 2 mm, one element.
void write_plate(const test::TemporaryFolder& folder) {
    coarse::FieldData data;
    for (const double y : {0.0, 2.0})
        for (const double x : {0.0, 10.0}) data.points.emplace_back(x, y, 0.0);
    data.add_cell(coarse::CellType::Quad, {0, 1, 3, 2});
    data.point_arrays = {{"displacement", 3, std::vector<double>(12)}};
    data.cell_arrays = {{"accumulated_plastic_strain", 1, {0.0}}, {"zone", 1, {0.0}}};
    data.whole_arrays = {{"load_factor", 1, {1.0}}, {"cycle", 1, {1.0}}};
    std::filesystem::create_directories(folder / "fields");
    coarse::write_vtkhdf(folder / "fields/step_00003.hdf", data);
}

/// The corners of the crack as the picture draws it: places of a page, x and y, both in pixels.
std::vector<FieldPoint> drawn_crack(const test::TemporaryFolder& folder, const CrackSection& crack) {
    write_plate(folder);
    RunRecord run = read_run(folder / "");
    run.input.emplace().cracks = {crack};
    const std::string picture = body_picture(run).charts.at(0), begin = "<path class=\"c1\" d=\"";
    const std::size_t from = picture.find(begin) + begin.size();
    std::string path = picture.substr(from, picture.find('"', from) - from);
    std::ranges::replace_if(
        path, [](char letter) { return letter == 'M' || letter == 'L'; }, ' ');
    std::istringstream numbers(path);
    std::vector<FieldPoint> corners;
    for (FieldPoint corner{}; numbers >> corner.x >> corner.y;) corners.push_back(corner);
    return corners;
}

// A line that went to the given first point before the new faces would turn back there.
TEST(BodyPicture, ANotchStaysWhereItWasMachinedWhereItsFirstPointGrows) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "history.csv")
        << "increment,cycle,load_factor,tip,a,x,y\n"
           "1,1,1,0,2,2,1\n1,1,1,1,2,6,1\n2,1,0,0,2.25,1.6,1.3\n2,1,0,1,2.25,6,1\n3,2,1,0,2.25,1.6,1.3\n"
           "3,2,1,1,2.25,6,1\n4,2,0,0,2.5,1.2,1.6\n4,2,0,1,2.5,6,1\n";  // it goes on behind the last faces
    std::ofstream(folder / "faces.csv") << "increment,crack,s,x,y,opening\n1,0,0.5,2.5,1,0.1\n"
                                           "3,0,0.25,1.8,1.15,0.1\n3,0,1,2.5,1,0.1\n3,0,4,5.5,1,0.1\n";
    const CrackSection given{.points = {{2.0, 1.0}, {6.0, 1.0}}, .contact = {}, .notch = 1.0};
    const std::vector<FieldPoint> crack = drawn_crack(folder, given);
    ASSERT_EQ(crack.size(), 4);
    EXPECT_TRUE(std::ranges::is_sorted(crack, {}, &FieldPoint::x));
    const double scale = (crack[3].x - crack[2].x) / 3.0;
    EXPECT_NEAR((crack[1].x - crack[0].x) / scale, 0.2, 0.01);  // from the new faces to where the notch begins
    EXPECT_NEAR((crack[1].y - crack[0].y) / scale, 0.15, 0.01);
}

TEST(BodyPicture, ANotchBeginsAtItsMouthAndTurnsAtItsBends) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "history.csv") << "increment,cycle,load_factor,tip,a,x,y\n3,1,1,0,6,6,1\n";
    std::ofstream(folder / "faces.csv")
        << "increment,crack,s,x,y,opening\n3,0,0.5,0.5,0.5,0.1\n3,0,2.5,2.5,1,0.1\n3,0,5,5,1,0.1\n";
    const CrackSection given{.points = {{0.0, 0.5}, {1.5, 0.5}, {1.5, 1.0}, {6.0, 1.0}}, .contact = {}, .notch = 2.25};
    const std::vector<FieldPoint> crack = drawn_crack(folder, given);
    ASSERT_EQ(crack.size(), 6);
    EXPECT_EQ(crack[2].x, crack[3].x);
    EXPECT_EQ(crack[3].y, crack[5].y);
}

TEST(BodyPicture, DrawsTheBodyWithItsCrackAndItsZone) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "history.csv") << "increment,cycle,load_factor,tip,a\n1,7,50,0,1\n";
    std::ofstream(folder / "faces.csv") << "increment,crack,s,x,y\n1,0,0.25,0.25,1\n1,0,0.75,0.75,1\n";
    EXPECT_TRUE(body_picture(read_run(folder / "")).charts.empty());  // no fields
    std::filesystem::create_directories(folder / "fields");
    coarse::write_vtkhdf(folder / "fields/step_00002.hdf", opened_pair(0.0));
    const std::string picture = body_picture(read_run(folder / "")).charts.at(0);
    EXPECT_EQ(count(picture, "<path class=\"l0\""), 1);  // one body, though the crack parts it
    EXPECT_EQ(count(picture, "<path class=\"l2\""), 1);
    EXPECT_EQ(count(picture, "<path class=\"c1\""), 1);
    const std::size_t body = picture.find("<path class=\"l0\"");
    EXPECT_EQ(count(picture.substr(body, picture.find('>', body) - body), "M"), 1);
}

}  // namespace
}  // namespace stria::report
