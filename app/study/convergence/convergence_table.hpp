// The results of a study along the sizes of its elements, and how far each is from converged.
#pragma once

#include <string>
#include <vector>

#include "app/study/convergence/grid_convergence.hpp"
#include "app/study/variants/table.hpp"

namespace stria::study {

struct ConvergenceRow {
    std::string result, unit;
    std::string along;   // the axis
    std::string others;  // the settings on the other axes; empty: none
    int sizes;
    GridConvergence found;
};

/// One row per result and combination of the other axes, along `fine.refine` and `mesh.size`, of runs that are done.
/// Nothing of results that are equal or zero to rounding on the two smallest, nor where fewer than two sizes are.
std::vector<ConvergenceRow> convergence_rows(const Report& report);

/// Header and cells of convergence.csv.
std::vector<std::string> convergence_columns();
std::vector<Cell> cells(const ConvergenceRow& row);

/// A paragraph and a table for the page; empty without rows.
std::string convergence_section(const std::vector<ConvergenceRow>& rows);

/// "life: 31650 cycles on the smallest elements, 29800 in the limit (order 1.02), uncertain by 7.3 %"
std::string sentence(const ConvergenceRow& row);

}  // namespace stria::study
