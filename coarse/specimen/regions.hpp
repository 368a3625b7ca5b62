// Which material an element is of, and the node lines that keep elements on one side of a region's outline.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "common/case/case.hpp"
#include "common/fem/mesh.hpp"

namespace stria::coarse {

/// Coordinates along x and y, mm, at which a structured mesh is to have lines of nodes.
using MeshLines = std::array<std::vector<double>, 2>;

/// Ascending.
void keep_each_once(MeshLines& lines);

/// Those of the axis-parallel edges of all outlines, ascending, each once.
[[nodiscard]] MeshLines lines_of(const std::vector<RegionSection>& regions);

/// Per element 0, or k where the k-th region holds its centre or is a group with it; empty without regions. Throws
/// CaseError where two regions hold it, and for a region without an element.
[[nodiscard]] std::vector<int> materials_of_elements(const Mesh& mesh, const std::vector<RegionSection>& regions);

/// One sentence per region whose outline runs through elements: they are of one material all the same.
[[nodiscard]] std::vector<std::string> region_warnings(const Mesh& mesh, const std::vector<RegionSection>& regions);

}  // namespace stria::coarse
