// Meshes of Abaqus and CalculiX: the keywords of an .inp file that make a plane mesh.
#pragma once

#include <string>

#include "coarse/mesh_file/part.hpp"

namespace stria::coarse {

/// *NODE, *ELEMENT (CPS3, CPS4, CPE3, CPE4 and their variants; T2D2, T3D2, B21 for edges), *NSET, *ELSET and *SURFACE.
/// Keywords of analyses are passed over; what would make another mesh is refused. Throws CaseError that begins with
/// `name` and the line.
Part read_abaqus(std::string text, const std::string& name);

}  // namespace stria::coarse
