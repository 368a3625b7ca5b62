// What the coarse side of a run has done, and how long it took: one record for all of its parts.
#pragma once

#include "coupling/work_counts.hpp"

namespace stria::coarse {

/// Counts that a run which is resumed goes on from.
struct RunCounts {
    int increments = 0;
    int newton_iterations = 0;
    int zone_extensions = 0;
    int yield_warnings =
        0;                  // increments with coarse elements beyond yield that were left elastic (fine.guard = "warn")
    int release_cuts = 0;   // halvings of what holds the faces that growth has opened
    int flowing_rings = 0;  // increments in which some tip had no ring outside what has flowed
    int overlapping_faces = 0;  // increments in which faces without contact overlapped in the zone
    int mesh_splits = 0;        // how often elements were split, as small ones followed the tips
};

struct CoarseEffort {
    RunCounts counts;
    coupling::WorkCounts work;  // of the structure

    // Wall time, s. Condensing is a part of the set-up, of growth and of zone extensions.
    double setup_s = 0.0;
    double run_s = 0.0;
    double growth_s = 0.0;
    double condensing_s = 0.0;
    double exchange_s = 0.0;  // waiting for the zone and talking to it
};

inline RunCounts& operator+=(RunCounts& sum, const RunCounts& more) {
    sum.increments += more.increments;
    sum.newton_iterations += more.newton_iterations;
    sum.zone_extensions += more.zone_extensions;
    sum.yield_warnings += more.yield_warnings;
    sum.release_cuts += more.release_cuts;
    sum.flowing_rings += more.flowing_rings;
    sum.overlapping_faces += more.overlapping_faces;
    sum.mesh_splits += more.mesh_splits;
    return sum;
}

inline CoarseEffort& operator+=(CoarseEffort& sum, const CoarseEffort& more) {
    sum.counts += more.counts;
    sum.work += more.work;
    sum.setup_s += more.setup_s;
    sum.run_s += more.run_s;
    sum.growth_s += more.growth_s;
    sum.condensing_s += more.condensing_s;
    sum.exchange_s += more.exchange_s;
    return sum;
}

}  // namespace stria::coarse
