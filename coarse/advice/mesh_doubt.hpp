// What may be said of a tip and the mesh about it.
#pragma once

#include <string>

namespace stria::coarse {

enum class MeshDoubtKind {
    Bend,           // too near for K
    Room,           // no ring tells K and J
    Metal,          // likewise, beside another one
    Neighbour,      // another crack is near to functions of the tip's element
    Functions,      // other tips' elements decide that functions stand
    LargeElements,  // larger than fine.refine asks for
    LeftFunctions,  // hold the faces where nothing flows
    Zone,           // spans too few elements
    Distance,       // of closure spans too few elements
    Reach,          // of closure, is that of a larger zone
    LifeInStrain,   // by opening loads
    LifeInStress,   // likewise
    Growth,         // crosses whole elements
    Step,           // of growth, against the zone
    Count
};

struct MeshDoubt {
    MeshDoubtKind kind = MeshDoubtKind::Count;
    std::string sentence = {};
    int degree = 1;  // one that has become graver is said once more
};

}  // namespace stria::coarse
