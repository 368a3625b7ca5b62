// What a case would take of a processor, said before it is taken: for who has written a load or a size ten times too
// large.
#pragma once

#include "coarse/fracture/nominal_solution.hpp"
#include "coarse/zone/zone_size.hpp"

namespace stria::coarse {

/// For the elastic body alone with its unit loads: that much `stria check` takes too. s of a processor; bytes.
[[nodiscard]] double seconds_of_body(const Scene& scene);
[[nodiscard]] double bytes_of_body(const Scene& scene);

struct WorkEstimate {
    double points = 0.0;      // of the zone, and of what else the elastic body would yield in
    double yielding = 0.0;    // of them, in elements that yield in the elastic body at some end of a half cycle
    double increments = 0.0;  // without halved ones
    double growths = 0.0;
    ZoneSize at_end;       // once the cracks have grown; `points` are those of the start
    double seconds = 0.0;  // of a processor
    double bytes = 0.0;
};

/// Measured figures (bench/error_of_estimate.py), to a factor of two where they were made and of about three elsewhere;
/// increments that have to be halved come on top. Of long histories the first half cycles count, and the largest one.
/// Zones are those half way of the growth, where the elastic body is solved once more.
/// `K`: the largest of the history, one per tip, MPa sqrt(mm).
/// `nominal`: of the whole body of the scene. `increment`: of growth, mm.
[[nodiscard]] WorkEstimate estimate_work(const Scene& scene, const NominalSolution& nominal,
                                         const std::vector<double>& K, double increment);

}  // namespace stria::coarse
