#include "coarse/fields/vtk_files.hpp"

#include <bit>
#include <fmt/format.h>
#include <span>

#include "common/error.hpp"
#include "common/index.hpp"
#include "common/io/hdf5.hpp"
#include "common/io/whole_file.hpp"

namespace stria::coarse {
namespace {

static_assert(sizeof(Eigen::Vector3d) == 3 * sizeof(double) && std::endian::native == std::endian::little);

void validate(const FieldData& data) {
    require(data.offsets.size() == data.types.size() + 1, "fields: one offset more than cells");
    require(data.offsets.front() == 0, "fields: offsets start at 0");
    require(data.offsets.back() == static_cast<std::int64_t>(data.connectivity.size()),
            "fields: offsets end at the last");
    const auto fits = [](const FieldArray& array, std::size_t count) {
        return array.components > 0 && array.values.size() == count * at(array.components);
    };
    for (const FieldArray& array : data.point_arrays)
        require(fits(array, data.points.size()), "fields: one value per point");
    for (const FieldArray& array : data.cell_arrays)
        require(fits(array, data.types.size()), "fields: one value per cell");
}

std::span<const double> coordinates(const FieldData& data) {
    return {data.points.empty() ? nullptr : data.points.front().data(), 3 * data.points.size()};
}

std::vector<std::uint8_t> type_numbers(const FieldData& data) {
    std::vector<std::uint8_t> numbers;
    for (const CellType type : data.types) numbers.push_back(static_cast<std::uint8_t>(type));
    return numbers;
}

void write_arrays(hdf5::Group& parent, const std::string& name, const std::vector<FieldArray>& arrays) {
    hdf5::Group group = parent.create_group(name);
    for (const FieldArray& array : arrays) {
        const auto components = at(array.components);
        const std::size_t tuples = array.values.size() / components;
        const auto shape = components == 1 ? std::vector{tuples} : std::vector{tuples, components};
        group.write<double>(array.name, array.values, shape);
    }
}

/// VTK's XML with the numbers appended raw, each block after its length in bytes.
class VtuText {
public:
    template <class T>
    void array(const std::string& type, const std::string& name, int components, std::span<const T> values) {
        header_ += fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" NumberOfTuples=\"{}\" "
                               "format=\"appended\" offset=\"{}\"/>\n",
                               type, name, components, values.size() / at(components), blocks_.size());
        const std::uint64_t bytes = values.size_bytes();
        append(&bytes, sizeof bytes);
        append(values.data(), values.size_bytes());
    }

    void arrays(const std::vector<FieldArray>& list) {
        for (const FieldArray& field : list) array<double>("Float64", field.name, field.components, field.values);
    }

    void line(const std::string& text) { header_ += text + '\n'; }

    [[nodiscard]] std::string text() const {
        return "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
               "byte_order=\"LittleEndian\" "
               "header_type=\"UInt64\">\n" +
               header_ + "<AppendedData encoding=\"raw\">\n_" + blocks_ + "\n</AppendedData>\n</VTKFile>\n";
    }

private:
    void append(const void* data, std::size_t bytes) {
        if (bytes > 0) blocks_.append(static_cast<const char*>(data), bytes);
    }

    std::string header_;
    std::string blocks_;
};

}  // namespace

void FieldData::add_cell(CellType type, const std::vector<std::int64_t>& cell_points) {
    connectivity.insert(connectivity.end(), cell_points.begin(), cell_points.end());
    offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
    types.push_back(type);
}

void write_vtkhdf(const std::filesystem::path& path, const FieldData& data) {
    validate(data);
    hdf5::write_file(path, [&](hdf5::Group& file) {
        hdf5::Group root = file.create_group("VTKHDF");
        const auto one_partition = [&](const std::string& name, std::size_t count) {
            root.write<std::int64_t>(name, std::vector{static_cast<std::int64_t>(count)});
        };
        root.write_attribute<std::int64_t>("Version", std::vector<std::int64_t>{1, 0});
        root.write_text("Type", "UnstructuredGrid");
        one_partition("NumberOfPoints", data.points.size());
        one_partition("NumberOfCells", data.types.size());
        one_partition("NumberOfConnectivityIds", data.connectivity.size());
        root.write<double>("Points", coordinates(data), {data.points.size(), 3});
        root.write<std::int64_t>("Connectivity", data.connectivity);
        root.write<std::int64_t>("Offsets", data.offsets);
        root.write<std::uint8_t>("Types", type_numbers(data));
        write_arrays(root, "PointData", data.point_arrays);
        write_arrays(root, "CellData", data.cell_arrays);
        write_arrays(root, "FieldData", data.whole_arrays);
    });
}

void write_vtu(const std::filesystem::path& path, const FieldData& data) {
    validate(data);
    VtuText vtu;
    vtu.line("<UnstructuredGrid>\n<FieldData>");
    vtu.arrays(data.whole_arrays);
    vtu.line(fmt::format("</FieldData>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<Points>",
                         data.points.size(), data.types.size()));
    vtu.array<double>("Float64", "Points", 3, coordinates(data));
    vtu.line("</Points>\n<Cells>");
    vtu.array<std::int64_t>("Int64", "connectivity", 1, data.connectivity);
    vtu.array<std::int64_t>("Int64", "offsets", 1, std::span(data.offsets).subspan(1));  // VTU leaves out the first 0
    vtu.array<std::uint8_t>("UInt8", "types", 1, type_numbers(data));
    vtu.line("</Cells>\n<PointData>");
    vtu.arrays(data.point_arrays);
    vtu.line("</PointData>\n<CellData>");
    vtu.arrays(data.cell_arrays);
    vtu.line("</CellData>\n</Piece>\n</UnstructuredGrid>");
    write_whole_text(path, vtu.text());
}

}  // namespace stria::coarse
