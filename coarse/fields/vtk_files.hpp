// An unstructured grid with its fields, and the two file formats of it that ParaView reads.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace stria::coarse {

/// Cell types in VTK's numbering.
enum class CellType : std::uint8_t { Vertex = 1, Line = 3, Triangle = 5, Polygon = 7, Quad = 9 };

struct FieldArray {
    std::string name;
    int components = 1;
    std::vector<double> values;  // components fastest
};

/// An unstructured grid with its fields. Cut elements come as cells of their own, points doubled across the crack.
struct FieldData {
    std::vector<Eigen::Vector3d> points;     // mm
    std::vector<std::int64_t> connectivity;  // points of cell 0, of cell 1, ...
    std::vector<std::int64_t> offsets{0};    // cell k: connectivity[offsets[k]] up to offsets[k + 1]
    std::vector<CellType> types;
    std::vector<FieldArray> point_arrays;
    std::vector<FieldArray> cell_arrays;
    std::vector<FieldArray> whole_arrays;  // of the grid as a whole: cycle, crack length

    void add_cell(CellType type, const std::vector<std::int64_t>& cell_points);
};

/// VTKHDF 1.0, and VTU. The file is written whole or not at all: throws FileFailure.
void write_vtkhdf(const std::filesystem::path& path, const FieldData& data);
void write_vtu(const std::filesystem::path& path, const FieldData& data);

}  // namespace stria::coarse
