// summary.json: what a run was, how large, how long, and where its tips ended.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "coarse/results/run_status.hpp"
#include "coarse/results/tables.hpp"
#include "coarse/structure/coarse_effort.hpp"
#include "common/io/json.hpp"

namespace stria::coarse {

/// Seconds per phase. mesh + setup + exchange + coarse_solve + output make the total; the others are parts of those.
struct Timing {
    double mesh = 0, setup = 0, coarse_factor = 0, growth = 0, fine_constitutive = 0, fine_contact = 0, fine_factor = 0;
    double exchange = 0, coarse_solve = 0, output = 0, checkpoint = 0, total = 0;
};

struct Summary {
    RunStatus status = RunStatus::Done;
    std::string version;
    std::string mode;  // "mpi", "inprocess", "monolithic"
    int ranks = 1;
    std::string mesh_file;  // checksum of what was in mesh.file, empty without one
    std::int64_t coarse_unknowns = 0, interface_unknowns = 0, fine_unknowns = 0, fine_points = 0;
    std::int64_t multipliers = 0;  // of contact
    std::int64_t step_cuts = 0;    // halved increments, growth included
    RunCounts counts;
    double N = 0.0;              // cycles, with all that the computed ones stand for
    std::optional<double> life;  // N, where growth has ended the run, and not by arrest
    coupling::WorkCounts work;   // of both components
    std::vector<std::int64_t> points_of_ranks, multipliers_of_ranks;  // of each fine rank
    Timing timing;
    std::vector<HistoryRow> last;          // last row of each tip
    std::vector<double> K_initial;         // there, of the initial stress alone, MPa sqrt(mm)
    std::vector<double> closure_distance;  // behind each tip, mm; shorter where none is looked at
    std::vector<std::string> warnings;     // of the mesh
};

Json to_json(const Summary& summary);

}  // namespace stria::coarse
