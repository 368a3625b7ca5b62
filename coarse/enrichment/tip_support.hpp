// Which nodes carry the functions of a tip.
#pragma once

#include <set>
#include <vector>

#include "coarse/enrichment/tip_enrichment.hpp"
#include "common/crack/crack_path.hpp"
#include "common/crack/crack_piece.hpp"
#include "common/crack/tip.hpp"
#include "common/fem/body_mesh.hpp"

namespace stria::coarse {

/// Nodes whose shape functions do not vanish on the element or elements that hold the tip at the end of a piece, and
/// its corners: with one that hangs, the ends of its edge.
[[nodiscard]] std::set<int> tip_nodes(const Mesh& mesh, const CrackPiece& piece);

/// Adds the ends of the edges on which some of the nodes hang.
void add_ends_of_edges(const Mesh& mesh, std::set<int>& nodes);

/// Adds those of all elements whose centre lies within a radius (mm) of a place: whole elements, for there the
/// functions are complete.
void add_disk(const BodyMesh& mesh, const Vec2& place, double radius, std::set<int>& nodes);

/// What functions a crack wants on its way, for others to keep off: an element sees those of one crack.
struct NodesOfCrack {
    struct AboutTip {
        Vec2 tip;
        std::set<int> nodes;
    };
    std::set<int> beside;         // of the elements that the crack runs through
    std::vector<AboutTip> about;  // of all elements about those of its tips
};
[[nodiscard]] NodesOfCrack nodes_of_crack(const BodyMesh& mesh, const CrackPath& path);

/// Of what other cracks want: what a tip leaves to them. About their tips that is what is nearer to these.
[[nodiscard]] std::set<int> left_to_others(const Mesh& mesh, const std::vector<NodesOfCrack>& cracks, const Tip& tip);

/// About a tip, mm.
struct RoomOfDisk {
    std::set<int> of_others;  // left_to_others()
    double in_body;           // room_in_body()
    double other_end;         // half_way_to_other_end()
    double other_cracks;      // half_way_to_other_cracks()
    double diagonal;          // of the tip's element
};

/// Of the disk on which a support of fixed radius has its functions, mm. Throws CaseError, naming the tip's place,
/// where the radius that the case asks for reaches farther than the tip.
[[nodiscard]] double disk_radius(const TipEnrichment& enrichment, const Tip& tip, const RoomOfDisk& room);

/// What carries a tip's functions.
struct TipNodes {
    std::set<int> nodes;
    bool share;  // all have one pair of unknowns a function: TipSupport::Gathered, where a disk has room
};
[[nodiscard]] TipNodes support_of_tip(const BodyMesh& mesh, const TipEnrichment& enrichment, const Tip& tip,
                                      const CrackPiece& piece, const RoomOfDisk& room);

}  // namespace stria::coarse
