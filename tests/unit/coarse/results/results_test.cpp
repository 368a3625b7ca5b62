// Files a run leaves: tables, summary and fields, read back as their readers would.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <sstream>

#include "coarse/results/csv.hpp"
#include "coarse/results/field_writer.hpp"
#include "coarse/results/rows.hpp"
#include "coarse/results/summary.hpp"
#include "coarse/results/tables.hpp"
#include "common/error.hpp"
#include "common/io/file_failure.hpp"
#include "common/io/hdf5.hpp"
#include "common/io/whole_file.hpp"
#include "tests/support/small_disk.hpp"

namespace stria::coarse {
namespace {

/// A folder of its own for each test, removed with what is in it.
class Results : public testing::Test {
protected:
    void SetUp() override {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder = std::filesystem::path(testing::TempDir()) / (std::string("stria_results_") + test->name());
        std::filesystem::remove_all(folder);
        std::filesystem::create_directories(folder);
    }
    void TearDown() override { std::filesystem::remove_all(folder); }

    [[nodiscard]] std::string text_of(const std::string& name) const {
        std::ifstream file(folder / name, std::ios::binary);
        std::ostringstream text;
        text << file.rdbuf();
        return text.str();
    }

    std::filesystem::path folder;
};

std::string joined(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ",") + name;
    return text;
}

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

using CsvFile = Results;

TEST_F(CsvFile, WritesShortestNumbersAndEmptyCells) {
    CsvWriter csv(folder / "t.csv", {"n", "x", "name"});
    csv.row(std::vector<Cell>{std::int64_t{3}, 0.1, std::string("a \"b\", c")});
    csv.row(std::vector<Cell>{std::monostate{}, std::nan(""), std::string()});
    csv.row(std::vector<Cell>{std::int64_t{-1}, 1.0 / 3.0, std::string("end")});
    EXPECT_EQ(text_of("t.csv"),
              "n,x,name\n3,0.1,\"a \"\"b\"\", c\"\n,,\n-1,0.3333333333333333,end\n");  // before it closes
    EXPECT_EQ(csv.rows(), 3U);
    EXPECT_THROW(csv.row(std::vector<Cell>{1.0}), std::logic_error);
}

TEST_F(CsvFile, ContinuesAfterACheckpoint) {
    const std::vector<std::string> columns{"a", "b"};
    {
        CsvWriter csv(folder / "t.csv", columns);
        for (const double value : {1.0, 2.0, 3.0}) csv.row(std::vector<Cell>{value, -value});
    }
    CsvWriter csv(folder / "t.csv", columns, 2);
    csv.row(std::vector<Cell>{4.0, 5.5});
    EXPECT_EQ(text_of("t.csv"), "a,b\n1,-1\n2,-2\n4,5.5\n");
    EXPECT_THROW(CsvWriter(folder / "t.csv", columns, 9), std::runtime_error);
    EXPECT_THROW(CsvWriter(folder / "t.csv", {"a", "c"}, 1), std::runtime_error);
    EXPECT_EQ(text_of("t.csv"), "a,b\n1,-1\n2,-2\n4,5.5\n");
}

TEST_F(CsvFile, DropsALineThatACrashCutShort) {
    std::ofstream(folder / "t.csv") << "a\n1\n2";
    EXPECT_THROW(CsvWriter(folder / "t.csv", {"a"}, 2), std::runtime_error);
    const CsvWriter csv(folder / "t.csv", {"a"}, 1);
    EXPECT_EQ(text_of("t.csv"), "a\n1\n");
}

TEST_F(CsvFile, KeepsWholeRowsOnAFullDisk) {
    CsvWriter csv(folder / "t.csv", {"a"});
    const test::SmallDisk disk(10);
    csv.row(std::vector<Cell>{1.5});
    EXPECT_THROW(csv.row(std::vector<Cell>{0.123456789}), FileFailure);
    EXPECT_EQ(text_of("t.csv"), "a\n1.5\n");
}

TEST(Tables, HaveTheColumnsUsersKnow) {
    EXPECT_EQ(joined(history_columns()),
              "increment,cycle,load_factor,load,displacement,tip,x,y,a,K_I,K_II,J,CMOD,CTOD,newton_iterations,"
              "contact_length,plastic_zone,dissipation,plastic_zone_axis,T_stress,J_spread,K_spread,external_work,"
              "stored_energy,released_energy,balance_error,frictional_dissipation");
    EXPECT_EQ(joined(cycle_columns()),
              "cycle,tip,a,da,dN,K_max,K_min,K_op,K_cl,U,dK_eff,J_max,CTOD_range,forward_zone,cyclic_zone,"
              "newton_iterations,fine_points,fine_unknowns,wall_s,forward_zone_axis,cyclic_zone_axis,K_op_contact,"
              "K_op_offset,K_op_tension");
    EXPECT_EQ(joined(closure_columns()), "cycle,tip,distance,K_op,K_cl");
    EXPECT_EQ(joined(face_columns()), "increment,crack,s,x,y,opening,slip,pressure,shear,status");
}

TEST(Tables, PutValuesUnderTheirColumns) {
    HistoryRow row;
    row.K_I = 42.0;
    EXPECT_EQ(std::get<double>(cells_of(row)[9]), 42.0);
    EXPECT_TRUE(std::holds_alternative<std::monostate>(cells_of(row)[5]));  // no tip
    row.tip = 1;
    EXPECT_EQ(std::get<std::int64_t>(cells_of(row)[5]), 1);

    coupling::FaceSample sample;
    sample.pressure = 8.0;
    sample.status = 2;
    const std::vector<Cell> cells = cells_of(face_row(40, sample));
    EXPECT_EQ(std::get<std::int64_t>(cells[0]), 40);
    EXPECT_EQ(std::get<double>(cells[7]), 8.0);
    EXPECT_EQ(std::get<std::int64_t>(cells[9]), 2);
}

TEST(JsonText, IsOrderedEscapedAndFinite) {
    const Json value = Json::Object{{"z", 1},
                                    {"a", Json::Array{true, Json(), std::nan(""), 0.1}},
                                    {"t", "say \"hi\"\n\\\x01"},
                                    {"none", Json::Object{}}};
    EXPECT_EQ(value.text(), "{\n  \"z\": 1,\n  \"a\": [\n    true,\n    null,\n    null,\n    0.1\n  ],\n"
                            "  \"t\": \"say \\\"hi\\\"\\n\\\\\\u0001\",\n  \"none\": {}\n}\n");
}

TEST(JsonText, HoldsTheSummary) {
    Summary summary;
    summary.status = "done";
    summary.last.resize(2);
    summary.last[0].tip = 0;
    const std::string text = to_json(summary).text();
    for (const char* key :
         {"status", "version", "mode", "ranks", "coarse_unknowns", "interface_unknowns", "fine_unknowns", "fine_points",
          "timing", "setup", "coarse_factor", "fine_constitutive", "fine_contact", "fine_factor", "exchange", "output",
          "total", "newton_iterations", "tips"}) {
        EXPECT_NE(text.find('"' + std::string(key) + "\":"), std::string::npos) << key;
    }
}

using WholeFile = Results;

TEST_F(WholeFile, KeepsTheOldOneWhenWritingFails) {
    write_whole_text(folder / "f", "old");
    EXPECT_THROW(write_whole(folder / "f",
                             [](const auto& temporary) {
                                 std::ofstream(temporary) << "half";
                                 throw NumericalFailure("stop");
                             }),
                 NumericalFailure);
    EXPECT_EQ(text_of("f"), "old");
    EXPECT_FALSE(std::filesystem::exists(folder / "f.part"));
    EXPECT_THROW(write_whole_text(folder / "no" / "f", "x"), FileFailure);
}

using Hdf5File = Results;

TEST_F(Hdf5File, ReturnsWhatWasWritten) {
    const std::vector<double> numbers{1.5, -2.0, 1e300, 0.1, 5.0, 6.0};
    hdf5::write_file(folder / "f.h5", [&](hdf5::Group& root) {
        hdf5::Group group = root.create_group("g");
        group.write<double>("numbers", numbers, {3, 2});
        group.write<std::int32_t>("empty", std::vector<std::int32_t>{});
        group.write<std::uint64_t>("large", std::vector{std::numeric_limits<std::uint64_t>::max()});
        group.write<std::int8_t>("small", std::vector<std::int8_t>{-1, 0, 1});
        group.write_attribute<std::int64_t>("two", std::vector<std::int64_t>{1, 2});
        group.write_text("text", "hello");
        group.write_text("nothing", "");
        EXPECT_THROW(group.write<double>("wrong", numbers, {4, 2}), std::runtime_error);
    });
    const hdf5::Group group = hdf5::read_file(folder / "f.h5").group("g");  // keeps the file open
    EXPECT_EQ(group.read<double>("numbers"), numbers);
    EXPECT_EQ(group.shape("numbers"), (std::vector<std::size_t>{3, 2}));
    EXPECT_TRUE(group.read<std::int32_t>("empty").empty());
    EXPECT_EQ(group.read<std::uint64_t>("large").front(), std::numeric_limits<std::uint64_t>::max());
    EXPECT_EQ(group.read<std::int8_t>("small"), (std::vector<std::int8_t>{-1, 0, 1}));
    EXPECT_EQ(group.read_attribute<std::int64_t>("two"), (std::vector<std::int64_t>{1, 2}));
    EXPECT_EQ(group.read_text("text"), "hello");
    EXPECT_EQ(group.read_text("nothing"), "");
    EXPECT_TRUE(group.contains("numbers"));
    EXPECT_FALSE(group.contains("absent"));
    EXPECT_THROW(static_cast<void>(group.read<double>("absent")), std::runtime_error);
    EXPECT_THROW(hdf5::read_file(folder / "absent.h5"), std::runtime_error);
}

using Fields = Results;

TEST_F(Fields, AreVtkHdfFilesInASeries) {
    FieldWriter writer(folder, FieldFormat::VtkHdf);
    writer.write(40, two_cells());
    writer.write(60, two_cells(), 1.5);
    EXPECT_EQ(text_of("fields.hdf.series"),
              "{\n  \"file-series-version\": \"1.0\",\n  \"files\": [\n"
              "    {\n      \"name\": \"fields/step_00040.hdf\",\n      \"time\": 40\n    },\n"
              "    {\n      \"name\": \"fields/step_00060.hdf\",\n      \"time\": 1.5\n    }\n  ]\n}\n");
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
    writer.write(20, two_cells());  // computed again
    ASSERT_EQ(writer.steps().size(), 2U);
    EXPECT_EQ(writer.steps().back().increment, 20);
}

TEST_F(Fields, OfStepsThatAreNoneOfTheSeriesGo) {
    FieldWriter(folder, FieldFormat::VtkHdf).write(10, two_cells());
    FieldWriter writer(folder, FieldFormat::VtkHdf, {{20, 20.0}});
    EXPECT_FALSE(std::filesystem::exists(folder / "fields/step_00010.hdf"));
    EXPECT_EQ(text_of("fields.hdf.series").find("step_00010"), std::string::npos);
}

TEST_F(Fields, AreVtuFilesInACollection) {
    FieldWriter writer(folder, FieldFormat::Vtu);
    writer.write(5, two_cells());
    EXPECT_NE(text_of("fields.pvd").find("<DataSet timestep=\"5\" part=\"0\" file=\"fields/step_00005.vtu\"/>"),
              std::string::npos);
    const std::string text = text_of("fields/step_00005.vtu");
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
    EXPECT_THROW(static_cast<void>(field_format("vtk")), CaseError);
}

}  // namespace
}  // namespace stria::coarse
