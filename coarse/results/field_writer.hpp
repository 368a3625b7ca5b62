// Fields for ParaView: one file per written increment (VTKHDF 1.0, or VTU) and an index of them all that makes them a
// series.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <optional>
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

enum class FieldFormat { VtkHdf, Vtu };

/// output.format of the case; throws CaseError for another name.
FieldFormat field_format(const std::string& name);

/// Whole or not at all.
void write_vtkhdf(const std::filesystem::path& path, const FieldData& data);
void write_vtu(const std::filesystem::path& path, const FieldData& data);

class FieldWriter {
public:
    struct Step {
        std::int64_t increment;
        double time;
    };

    /// `written`: the steps of a run that is resumed (its files are there already).
    FieldWriter(std::filesystem::path directory, FieldFormat format, std::vector<Step> written = {});

    /// Writes fields/step_00040.hdf (.vtu) and then fields.hdf.series (fields.pvd). Time: the increment unless told.
    void write(std::int64_t increment, const FieldData& data, std::optional<double> time = {});

    /// What a checkpoint remembers.
    [[nodiscard]] const std::vector<Step>& steps() const { return steps_; }

private:
    [[nodiscard]] std::string file_name(std::int64_t increment) const;
    void write_index() const;

    std::filesystem::path directory_;
    FieldFormat format_;
    std::vector<Step> steps_;
};

}  // namespace stria::coarse
