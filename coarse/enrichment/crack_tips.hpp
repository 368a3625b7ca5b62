// The ends of a crack inside the body, with the frames that they carry.
#pragma once

#include <vector>

#include "common/crack/crack_path.hpp"
#include "common/crack/tip.hpp"
#include "common/fem/mesh.hpp"

namespace stria::coarse {

/// The tip at the start of a path, then that at its end, if they are. `s`: where its last piece ends.
[[nodiscard]] std::vector<Tip> tips_of(const Mesh& mesh, const CrackPath& path);

/// The piece of its own path that ends at a tip or, where the faces end on an element edge, beside it.
[[nodiscard]] const CrackPiece& last_piece(const CrackPath& path, const Tip& tip);

/// Throws CrackOffMesh where a crack does not lie behind its tip as far as the functions of the tip's element act:
/// theta would run on to more than 3/2 pi.
void require_behind(const Mesh& mesh, const CrackPath& path, const Tip& tip);

}  // namespace stria::coarse
