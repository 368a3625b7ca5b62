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

STRIA_MEMBERS(RunCounts, increments, newton_iterations, zone_extensions, yield_warnings, release_cuts, flowing_rings,
              overlapping_faces, mesh_splits)
STRIA_MEMBERS(CoarseEffort, counts, work, setup_s, run_s, growth_s, condensing_s, exchange_s)

inline RunCounts& operator+=(RunCounts& sum, const RunCounts& more) { return add_members(sum, more); }
inline CoarseEffort& operator+=(CoarseEffort& sum, const CoarseEffort& more) { return add_members(sum, more); }

}  // namespace stria::coarse
