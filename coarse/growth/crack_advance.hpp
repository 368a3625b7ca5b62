// Where a crack grows: the direction of an advance, and the crack's line after it.
#pragma once

#include <vector>

#include "coarse/fracture/fracture_parameters.hpp"
#include "coarse/fracture/turned_tip.hpp"
#include "common/case/case.hpp"
#include "common/enrichment/enriched_mesh.hpp"

namespace stria::coarse {

/// The angle by which a crack turns: `angle`, or 0 as long as its way without a corner stays within 1e-4 of an element
/// of the arc that bends by `angle` over the last straight stretch, of one element at most, and the increment, mm each.
/// Nothing is lost: the next angle is measured from the same direction. Below 2e-4, which is no more than what K_II is
/// good to, a crack in short steps stays straight.
[[nodiscard]] double turn(double angle, double stretch, double increment, double element);

/// By which a tip turns as its crack becomes longer, radians, counter-clockwise; and the largest, of any sign.
[[nodiscard]] double turn_of(const Tip& tip, const std::vector<CrackSection>& longer);
[[nodiscard]] double largest_turn(const std::vector<Tip>& tips, const std::vector<CrackSection>& longer);

/// Along a crack from its last sharp turn to a tip, mm; infinite where it has none.
[[nodiscard]] double behind_sharp_turn(const CrackSection& crack, const Tip& tip);

/// Advances the end of a crack along a unit vector by `increment`, mm. On a straight crack its last point moves. Steps
/// add up, however short beside what the mesh moves a tip by: `tip` is where the mesh has it.
void advance(CrackSection& crack, const Tip& tip, const Vec2& direction, double increment);

/// Moves the bend that an advance has made at a tip of `mesh` back to a little before the edge over which the crack has
/// come into the tip's element: turned back over that edge, it would enter the element before it a second time. Its end
/// stays. False, and nothing is done: it went straight on, or the edge is farther than an element away, or the crack
/// has begun behind it.
[[nodiscard]] bool bend_before_edge(CrackSection& longer, const EnrichedMesh& mesh, const Tip& tip);

/// What bend_before_edge() makes of longer cracks: of each tip alone, and of all of them where there are several.
[[nodiscard]] std::vector<std::vector<CrackSection>> bent_before_edges(const std::vector<CrackSection>& longer,
                                                                       const EnrichedMesh& mesh);

/// Lets an advance that turns at a tip of `mesh` within an element edge, along which the crack runs, go straight on and
/// turn at the end of that edge. The way is as long as it was. False, and
/// nothing is done: it goes straight on anyway, or the crack runs along no edge.
[[nodiscard]] bool turn_at_end_of_edge(CrackSection& longer, const EnrichedMesh& mesh, const Tip& tip);

/// Does so where no functions stand and faces are open up to the end of that edge: what is open stays open.
void turn_where_faces_end(std::vector<CrackSection>& longer, const EnrichedMesh& mesh);

/// Longer cracks of which every tip does so that can; none where none can.
[[nodiscard]] std::vector<std::vector<CrackSection>> turned_at_ends_of_edges(std::vector<CrackSection> longer,
                                                                             const EnrichedMesh& mesh);

/// What tells each tip its direction: the nominal K, of faces without tractions; where faces touch, of this crack or
/// another one, the K of the solution that has been reached, which knows what they bear. Without
/// what the pressure of faces in metal that has flowed adds: a wake presses on itself, as stretched as it is. Not where
/// that K is next to nothing beside the `largest` nominal one of a cycle, as without a load; nor where no ring of the
/// tip lies outside what has flowed: then it is no elastic K. One per tip each.
[[nodiscard]] std::vector<TipResult> directing(std::vector<TipResult> nominal, const std::vector<TipResult>& reached,
                                               const std::vector<double>& largest);

/// The K of what loads a tip in the solution that has been reached: directing().
[[nodiscard]] TipResult loaded_by(TipResult reached);

/// How far a tip is to advance, and what tells it the direction.
struct TipAdvance {
    Tip tip;
    double K_I, K_II;  // directing(), MPa sqrt(mm)
    double by;         // mm
    double element;    // edge of the tip's element, mm
};

/// The cracks with each tip advanced along its growth direction. Who would turn by next to no advance stays.
[[nodiscard]] std::vector<CrackSection> longer_cracks(std::vector<CrackSection> cracks, GrowthDirection direction,
                                                      const std::vector<TipAdvance>& advances);

}  // namespace stria::coarse
