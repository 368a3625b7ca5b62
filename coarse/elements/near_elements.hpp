// Which coarse elements are near and which are far. An increment visits near ones only. Of the far ones it needs a
// proof that they stay elastic (far_stress_bound.hpp), so its cost does not depend on the size of the body. Where
// cracks grow, most of the near ones are in the middle, between the far ones and a core about the tips and the zone.
// Far elements and those in the middle are condensed once and serve one structure after another (body_part.hpp).
#pragma once

#include "coarse/elements/coarse_elements.hpp"

namespace stria::coarse {

/// Coarse elements that have to be near: a ring about a tip crosses or encloses them, or they touch the zone, or a
/// crack changes their functions. Domain integrals and openings are taken there, stresses are large there, and points
/// with little weight lie there.
ElementSet near_elements(const Scene& scene, const ElementSet& in_zone);

/// The far elements. `known`: those of the structure before (none: empty). They stay for as long as none of them has to
/// be near; otherwise they are chosen anew, with room ahead of the tips where cracks grow: the more, the more are far.
/// Where no element has to be near, none is far; nor of a body without a zone where the full matrix on their rim takes
/// more than they spare.
ElementSet far_elements(const Scene& scene, const ElementSet& in_zone, const ElementSet& known = {});

/// How far tips may go until they are chosen anew, mm, where cracks grow.
double room_ahead(const Scene& scene, const ElementSet& in_zone);

/// The same, and which of the near elements are in the middle: none where cracks do not grow, few would be, or the full
/// matrix on their rim takes more than they spare. They stay for as long as all of them are near, the far ones stay,
/// and none has to be in the core: where a crack changes its functions, or it touches the zone. Otherwise they are
/// chosen anew, with room ahead of the tips.
StillElements still_elements(const Scene& scene, const ElementSet& in_zone, const StillElements& known = {});

/// Which elements are behind, of the whole body without a zone: where cracks grow, all that is neither far nor in the
/// middle and lies away from the tips, the wakes with their jumps included. They serve until one of their functions
/// changes. `soon`: elements that the next steps of growth will split.
ElementSet elements_behind(const Scene& scene, const StillElements& still, const ElementSet& soon);

}  // namespace stria::coarse
