// Fields as ParaView reads them.
#include "coarse/fields/field_writer.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "common/error.hpp"
#include "common/io/hdf5.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria::coarse {
namespace {

/// A triangle and a quadrilateral with one array of each kind.
FieldData two_cells() {
    FieldData data;
    data.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}};
    data.add_cell(CellType::Quad, {0, 1, 2, 3});
    data.add_cell(CellType::Triangle, {1, 4, 2});
    data.point_arrays = {{"displacement", 3, std::vector<double>(15, 0.25)}, {"p", 1, {1, 2, 3, 4, 5}}};
    data.cell_arrays = {{"zone", 1, {0, 1}}};
    data.whole_arrays = {{"cycle", 1, {7}}};
    return data;
}

class Fields : public testing::Test {
protected:
    const test::TemporaryFolder temporary;
    const std::filesystem::path folder = temporary / "";
};

TEST_F(Fields, AreVtkHdfFilesInASeries) {
    FieldWriter writer(folder, FieldFormat::VtkHdf);
    writer.write(40, two_cells(), 1.0);
    writer.write(60, two_cells(), 1.5);
    writer.write(61, two_cells(), 1.5);  // the same moment
    EXPECT_EQ(test::text_of(folder / "fields.hdf.series"),
              "{\n  \"file-series-version\": \"1.0\",\n  \"files\": [\n"
              "    {\n      \"name\": \"fields/step_00040.hdf\",\n      \"time\": 1.0\n    },\n"
              "    {\n      \"name\": \"fields/step_00060.hdf\",\n      \"time\": 1.5\n    },\n"
              "    {\n      \"name\": \"fields/step_00061.hdf\",\n      \"time\": 1.500001\n    }\n  ]\n}\n");
    const hdf5::Group root = hdf5::read_file(folder / "fields/step_00040.hdf").group("VTKHDF");
    EXPECT_EQ(root.read_attribute<std::int64_t>("Version"), (std::vector<std::int64_t>{1, 0}));
    EXPECT_EQ(root.read_text("Type"), "UnstructuredGrid");
    EXPECT_EQ(root.read<std::int64_t>("NumberOfPoints"), std::vector<std::int64_t>{5});
    EXPECT_EQ(root.read<std::int64_t>("NumberOfCells"), std::vector<std::int64_t>{2});
    EXPECT_EQ(root.read<std::int64_t>("NumberOfConnectivityIds"), std::vector<std::int64_t>{7});
    EXPECT_EQ(root.shape("Points"), (std::vector<std::size_t>{5, 3}));
    EXPECT_EQ(root.read<std::int64_t>("Offsets"), (std::vector<std::int64_t>{0, 4, 7}));
    EXPECT_EQ(root.read<std::uint8_t>("Types"), (std::vector<std::uint8_t>{9, 5}));
    EXPECT_EQ(root.group("PointData").shape("displacement"), (std::vector<std::size_t>{5, 3}));
    EXPECT_EQ(root.group("CellData").read<double>("zone"), (std::vector<double>{0, 1}));
    EXPECT_EQ(root.group("FieldData").read<double>("cycle"), std::vector<double>{7});
}

TEST_F(Fields, ContinueAResumedSeries) {
    FieldWriter writer(folder, FieldFormat::VtkHdf, {{10, 10.0}, {20, 20.0}});
    writer.write(20, two_cells(), 20.0);  // computed again
    ASSERT_EQ(writer.steps().size(), 2U);
    EXPECT_EQ(writer.steps().back().increment, 20);
}

TEST_F(Fields, OfStepsThatAreNoneOfTheSeriesGo) {
    FieldWriter(folder, FieldFormat::VtkHdf).write(10, two_cells(), 10.0);
    FieldWriter writer(folder, FieldFormat::VtkHdf, {{20, 20.0}});
    EXPECT_FALSE(std::filesystem::exists(folder / "fields/step_00010.hdf"));
    EXPECT_EQ(test::text_of(folder / "fields.hdf.series").find("step_00010"), std::string::npos);
}

// ParaView would open the index of one that names files which are no more.
TEST_F(Fields, OfARunBeforeLeaveNoIndex) {
    FieldWriter(folder, FieldFormat::VtkHdf).write(10, two_cells(), 10.0);
    FieldWriter(folder, FieldFormat::Vtu).write(20, two_cells(), 20.0);
    EXPECT_FALSE(std::filesystem::exists(folder / "fields.hdf.series"));
    EXPECT_TRUE(std::filesystem::exists(folder / "fields.pvd"));
    const FieldWriter writes_none(folder, FieldFormat::Vtu);
    EXPECT_FALSE(std::filesystem::exists(folder / "fields.pvd"));
}

TEST_F(Fields, AreVtuFilesInACollection) {
    FieldWriter writer(folder, FieldFormat::Vtu);
    writer.write(5, two_cells(), 5.0);
    EXPECT_NE(test::text_of(folder / "fields.pvd")
                  .find("<DataSet timestep=\"5\" part=\"0\" file=\"fields/step_00005.vtu\"/>"),
              std::string::npos);
    const std::string text = test::text_of(folder / "fields/step_00005.vtu");
    const std::size_t blocks =
        text.find("<AppendedData encoding=\"raw\">\n_") + std::strlen("<AppendedData encoding=\"raw\">\n_");
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, text.data() + blocks, sizeof bytes);
    EXPECT_EQ(bytes, sizeof(double));  // the first block: cycle
    double cycle = 0.0;
    std::memcpy(&cycle, text.data() + blocks + sizeof bytes, sizeof cycle);
    EXPECT_EQ(cycle, 7.0);
}

TEST_F(Fields, RefuseArraysOfTheWrongLength) {
    FieldData data = two_cells();
    data.cell_arrays.front().values.pop_back();
    EXPECT_THROW(write_vtkhdf(folder / "f.hdf", data), std::logic_error);
}

}  // namespace
}  // namespace stria::coarse
