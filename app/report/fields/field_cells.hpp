// The cells of a field file, as a picture needs them.
#pragma once

#include <filesystem>
#include <vector>

namespace stria::report {

struct FieldPoint {
    double x, y;  // mm
};

struct FieldCells {
    double load_factor = 0.0, cycle = 0.0;
    std::vector<FieldPoint> points, displacement;  // one each per point, mm
    std::vector<std::vector<int>> cells;           // their points
    std::vector<double> strain;                    // accumulated plastic, one per cell
    std::vector<double> zone;                      // 1 where the fine scale has it, one per cell
};

/// A file that Stria wrote, fields/step_*.hdf. Throws std::runtime_error where it is none.
FieldCells read_field_cells(const std::filesystem::path& path);

/// The last files of a folder, in their order; none where there is no folder.
std::vector<std::filesystem::path> last_fields(const std::filesystem::path& folder, std::size_t count);

}  // namespace stria::report
