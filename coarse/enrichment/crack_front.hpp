// Where the jump of a crack ends that no tip function closes.
#pragma once

#include <set>
#include <span>

#include "common/crack/crack_path.hpp"
#include "common/fem/body_mesh.hpp"

namespace stria::coarse {

/// Moves each tip of a path along the crack's last direction to the boundary of an element nearby, as a crack in
/// conventional elements ends at a node: to where its faces seem to end nearest to the tip, about half an element off
/// at most. The way back where both are as near. A crack inside a single element reaches both of its edges. Arc lengths
/// stay those from the crack's first point: a front before it has a negative one.
[[nodiscard]] CrackPath with_fronts_on_edges(const BodyMesh& mesh, CrackPath path);

/// By how much faces that open behind the end of these pieces, on an element edge, seem to end earlier, mm: by K of an
/// elastic crack, beside one that leaves its last element across from where it came in (docs/method.md, section 2).
/// Negative where they seem to end later.
[[nodiscard]] double lag(const Mesh& mesh, std::span<const CrackPiece> pieces);

/// Nodes of the edge that a path with fronts on edges ends on, or the node: nothing jumps there.
[[nodiscard]] std::set<int> front_nodes(const Mesh& mesh, const CrackPath& path, bool start);

}  // namespace stria::coarse
