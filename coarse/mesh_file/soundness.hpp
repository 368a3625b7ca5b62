// Whether the faces of a mesh file make one body.
#pragma once

#include <string>

#include "coarse/mesh_file/faces.hpp"

namespace stria::coarse {

/// Faces join at whole edges, two at each, and all of them hang together by edges; no two nodes are in one place.
/// Throws CaseError that begins with `name` and names the nodes and elements of the file.
void require_soundness(const Faces& faces, const std::string& name);

}  // namespace stria::coarse
