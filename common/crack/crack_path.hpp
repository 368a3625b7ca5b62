// A crack polyline resolved on a mesh: where it crosses element edges, and its piece inside each element.
#pragma once

#include <vector>

#include "common/crack/crack_piece.hpp"
#include "common/error.hpp"
#include "common/fem/body_mesh.hpp"

namespace stria {

/// It is the mesh, its loads or its supports that cannot hold a crack, and not the body: another mesh may.
class CrackOffMesh : public CaseError {
public:
    using CaseError::CaseError;
};

/// What resolving a crack leaves: its pieces in order, and which of its two ends are tips (strictly inside the body).
struct CrackPath {
    std::vector<Vec2> points;  // of the polyline, those beside nodes and edges put onto them
    std::vector<CrackPiece> pieces;
    bool tip_at_start = false;
    bool tip_at_end = false;
    double length = 0.0;  // of the polyline, mm

    /// Arc length of the end that is no tip, where the crack meets the boundary, mm; NaN: it has two tips.
    [[nodiscard]] double mouth() const;
};

/// Whether a crossing exists is decided by exact predicates. Throws CaseError where the crack misses the body, leaves
/// it between its ends or turns by more than a right angle, CrackOffMesh where it enters an element twice, or leaves an
/// element edge between its nodes after running along it.
CrackPath resolve_crack(const BodyMesh& mesh, int crack, const std::vector<Vec2>& points);

}  // namespace stria
