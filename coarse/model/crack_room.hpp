// What a crack needs of the mesh for its results to mean something.
#pragma once

#include <string>
#include <utility>

#include "coarse/model/loads/loads_of_case.hpp"
#include "common/case/case.hpp"
#include "common/enrichment/enriched_mesh.hpp"
#include "common/error.hpp"
#include "common/fem/mesh.hpp"

namespace stria::coarse {

/// A tip is nearer to the boundary than an element is long. Of a case that is wrong input; a crack that has grown so
/// far has met the boundary, and `met` says so.
class TipAtBoundary : public CaseError {
public:
    TipAtBoundary(const std::string& of_case, std::string of_growth) : CaseError(of_case), met(std::move(of_growth)) {}
    std::string met;
};

/// Throws CaseError, naming the crack and the point, where one is so far outside the body that its rounding moves the
/// crack inside.
void require_near(const Mesh& mesh, const std::vector<CrackSection>& cracks);

/// Throws CaseError, naming the crack, where one is shorter than an element at its tip, TipAtBoundary where a tip lies
/// nearer to the boundary than an element is long: no ring about the tip could tell K or J. `refined`: an element of
/// the mesh becomes so many along an edge; they must not be lost in the rounding of the body's coordinates either.
void require_room(const Mesh& mesh, const EnrichedMesh& enriched, int refined);

/// Throws CrackOffMesh where a node that is loaded or held is as near to a tip.
void require_room_beside_loads(const Mesh& mesh, const EnrichedMesh& enriched, const LoadsOfCase& loads, int refined);

/// Throws CaseError, naming the crack, where one of so many has no tip in the body: it cuts the body in two.
void require_tips(const EnrichedMesh& enriched, int cracks);

}  // namespace stria::coarse
