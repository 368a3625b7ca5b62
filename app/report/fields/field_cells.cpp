#include "app/report/fields/field_cells.hpp"

#include <algorithm>

#include "common/index.hpp"
#include "common/io/hdf5.hpp"

namespace stria::report {

namespace {

std::vector<FieldPoint> plane_points(const std::vector<double>& coordinates) {
    std::vector<FieldPoint> points;
    for (std::size_t k = 0; k + 2 < coordinates.size(); k += 3) points.push_back({coordinates[k], coordinates[k + 1]});
    return points;
}

}  // namespace

FieldCells read_field_cells(const std::filesystem::path& path) {
    const hdf5::Group root = hdf5::read_file(path).group("VTKHDF");
    FieldCells field;
    field.load_factor = root.group("FieldData").read<double>("load_factor").front();
    field.cycle = root.group("FieldData").read<double>("cycle").front();
    field.points = plane_points(root.read<double>("Points"));
    field.displacement = plane_points(root.group("PointData").read<double>("displacement"));
    field.strain = root.group("CellData").read<double>("accumulated_plastic_strain");
    field.zone = root.group("CellData").read<double>("zone");
    const auto offsets = root.read<std::int64_t>("Offsets"), connectivity = root.read<std::int64_t>("Connectivity");
    for (std::size_t cell = 0; cell + 1 < offsets.size(); ++cell) {
        field.cells.emplace_back();
        for (std::size_t k = at(offsets[cell]); k < at(offsets[cell + 1]); ++k)
            field.cells.back().push_back(static_cast<int>(connectivity[k]));
    }
    return field;
}

std::vector<std::filesystem::path> last_fields(const std::filesystem::path& folder, std::size_t count) {
    std::vector<std::filesystem::path> files;
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(folder, none))
        if (entry.path().extension() == ".hdf") files.push_back(entry.path());
    std::ranges::sort(files);
    if (files.size() > count) files.erase(files.begin(), files.end() - static_cast<std::ptrdiff_t>(count));
    return files;
}

}  // namespace stria::report
