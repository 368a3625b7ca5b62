// Meshes of Gmsh: formats 4.1 and 2.2, as text or binary (Gmsh reference manual, "MSH file format").
#pragma once

#include <string>

#include "coarse/mesh_file/part.hpp"

namespace stria::coarse {

/// Physical groups keep their names; one without a name is called by its tag. Throws CaseError that begins with `name`.
Part read_gmsh(std::string text, const std::string& name);

}  // namespace stria::coarse
