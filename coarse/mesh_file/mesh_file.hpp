// A body as it lies in a mesh file: Gmsh's .msh, or the .inp of Abaqus and CalculiX.
#pragma once

#include <string>

#include "common/fem/mesh.hpp"

namespace stria::coarse {

/// Boundary edges of no group.
constexpr const char* unnamed_edges = "unnamed";

/// Quadrilaterals stay as they are; where there are triangles, each face is split into as many quadrilaterals as it has
/// corners. Groups of edges and node sets become boundaries, groups of faces `groups`. Throws CaseError, "mesh.file:
/// part.msh:12: ...", where the file cannot be read or is no body, with the node or element that is wrong.
Mesh read_mesh_file(const std::string& path);

/// What was read, in sentences for `stria check`.
std::vector<std::string> describe_mesh_file(const std::string& path);

}  // namespace stria::coarse
