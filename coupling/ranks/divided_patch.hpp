// The zone's patch divided among the fine ranks: the patch of each, and the seams on which they meet.
#pragma once

#include <map>
#include <vector>

#include "coupling/messages.hpp"

namespace stria::coupling {

/// What one rank has of the zone.
struct RankPart {
    int rank = 0;
    std::vector<int> elements;  // of the zone's mesh, ascending
    std::vector<int> unknowns;  // per unknown of the part's mesh: unknown of the zone's mesh
    std::vector<int> shared;    // per unknown of the part's boundary: place in Seams::kept; seams first, then Gamma,
                                // both ascending
};

/// Unknowns at which parts end. On Gamma they meet the structure; on seams only each other.
struct Seams {
    std::vector<int> kept;     // both: unknowns of the zone's mesh, ascending
    std::vector<int> gamma;    // places in `kept`, in the order of Patch::boundary
    std::vector<int> between;  // places in `kept`: the seams
};

struct DividedPatch {
    std::vector<RankPart> parts;  // of ranks that have elements, by rank
    std::vector<Patch> patches;   // of each part
    Seams seams;
};

/// `owner`: rank per element, by id. `displacement`: committed, of all unknowns of the patch's mesh, mm. The loads of
/// kept unknowns are with no part. `before`: parts until now; a rank that had none begins anew.
DividedPatch divide(const Patch& patch, const std::map<int, int>& owner, const Eigen::VectorXd& displacement,
                    const std::vector<RankPart>& before);

}  // namespace stria::coupling
