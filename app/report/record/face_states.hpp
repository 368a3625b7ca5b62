// The crack faces at a few of the increments at which a run has written them.
#pragma once

#include <string>
#include <vector>

#include "app/report/record/run_record.hpp"

namespace stria::report {

/// One value per station, from the crack's first point on.
struct FaceState {
    double increment = 0;
    std::vector<double> s;                // mm
    std::vector<double> opening, slip;    // mm
    std::vector<double> pressure, shear;  // MPa
};

/// As many increments as a slider has room for: those of whole cycles, the last one among them, evenly over the run.
std::vector<double> chosen_increments(const RunRecord& run, const std::vector<double>& written, std::size_t most);

/// All increments of faces.csv; empty without one.
std::vector<double> written_increments(const RunRecord& run);

/// Of these increments, in their order; stations are thinned evenly to `most_stations`, the last one stays.
std::vector<FaceState> face_states(const RunRecord& run, int crack, const std::vector<double>& increments,
                                   std::size_t most_stations);

}  // namespace stria::report
