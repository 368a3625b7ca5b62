// The fields of a small body that a crack parts.
#pragma once

#include "coarse/fields/vtk_files.hpp"

namespace stria::test {

/// Two squares of 1 mm, one above the other; they part at y = 1 by 0.002 mm.
inline coarse::FieldData opened_pair(double strain) {
    coarse::FieldData data;
    for (const double y : {0.0, 1.0, 1.0, 2.0})
        for (const double x : {0.0, 1.0}) data.points.emplace_back(x, y, 0.0);
    coarse::FieldArray displacement{"displacement", 3, {}};
    for (int point = 0; point < 8; ++point)
        displacement.values.insert(displacement.values.end(), {0.0, point < 4 ? -0.001 : 0.001, 0.0});
    data.add_cell(coarse::CellType::Quad, {0, 1, 3, 2});
    data.add_cell(coarse::CellType::Quad, {4, 5, 7, 6});
    data.point_arrays = {displacement};
    data.cell_arrays = {{"accumulated_plastic_strain", 1, {strain, 0.0}}, {"zone", 1, {1.0, 0.0}}};
    data.whole_arrays = {{"load_factor", 1, {50.0}}, {"cycle", 1, {7.0}}};
    return data;
}

}  // namespace stria::test
