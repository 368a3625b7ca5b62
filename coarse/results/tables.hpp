// Rows of the tables a run leaves: history.csv, cycles.csv and faces.csv, columns as in docs/notation.md.
// A number that is not finite is a missing value: its cell stays empty.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "common/io/csv.hpp"

namespace stria::coarse {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// One converged increment and tip; without tips, one increment.
struct HistoryRow {
    std::int64_t increment = 0, cycle = 0;
    double load_factor = missing;
    double load = missing;          // N/mm
    double displacement = missing;  // mm
    std::optional<std::int64_t> tip;
    double x = missing, y = missing;        // mm
    double a = missing;                     // mm
    double K_I = missing, K_II = missing;   // MPa sqrt(mm)
    double J = missing;                     // N/mm
    double CMOD = missing, CTOD = missing;  // mm
    std::int64_t newton_iterations = 0;
    double contact_length = missing;          // mm
    double plastic_zone = missing;            // mm
    double dissipation = missing;             // N, per mm of thickness, total so far
    double plastic_zone_axis = missing;       // mm
    double T_stress = missing;                // MPa
    double J_spread = missing;                // over the rings, relative
    double K_spread = missing;                // likewise
    double external_work = missing;           // N, per mm of thickness, total so far
    double stored_energy = missing;           // N
    double released_energy = missing;         // N, total so far
    double balance_error = missing;           // N
    double frictional_dissipation = missing;  // N, its share of the dissipation
    double opening = missing;                 // mm, at closure.distance behind the tip
};

/// One cycle and tip.
struct CycleRow {
    std::int64_t cycle = 0;
    std::optional<std::int64_t> tip;
    double a = missing, da = missing;                                         // mm
    double dN = missing;                                                      // cycles
    double K_max = missing, K_min = missing, K_op = missing, K_cl = missing;  // MPa sqrt(mm), nominal
    double U = missing;
    double dK_eff = missing;                               // MPa sqrt(mm)
    double J_max = missing;                                // N/mm
    double CTOD_range = missing;                           // mm
    double forward_zone = missing, cyclic_zone = missing;  // mm
    std::int64_t newton_iterations = 0, fine_points = 0, fine_unknowns = 0;
    double wall_s = missing;
    double forward_zone_axis = missing, cyclic_zone_axis = missing;                // mm
    double K_op_contact = missing, K_op_offset = missing, K_op_tension = missing;  // MPa sqrt(mm)
    double opening_range = missing;                                                // mm
    double N = missing;                                                            // cycles so far, the sum of dN
    double K_initial = missing;                                                    // MPa sqrt(mm)
};

/// One cycle, tip and distance behind it.
struct ClosureRow {
    std::int64_t cycle = 0, tip = 0;
    double distance = missing;                                                            // mm
    double K_op = missing, K_cl = missing, K_slip = missing, K_slip_unloading = missing;  // MPa sqrt(mm), nominal
};

/// One station of the crack faces at one increment.
struct FaceRow {
    std::int64_t increment = 0, crack = 0;
    double s = missing, x = missing, y = missing;  // mm
    double opening = missing, slip = missing;      // mm
    double pressure = missing, shear = missing;    // MPa
    std::int64_t status = 0;                       // 0 open, 1 stick or frictionless contact, 2 slip
};

std::vector<std::string> history_columns();
std::vector<std::string> cycle_columns();
std::vector<std::string> closure_columns();
std::vector<std::string> face_columns();

std::vector<Cell> cells_of(const HistoryRow& row);
std::vector<Cell> cells_of(const CycleRow& row);
std::vector<Cell> cells_of(const ClosureRow& row);
std::vector<Cell> cells_of(const FaceRow& row);

}  // namespace stria::coarse
