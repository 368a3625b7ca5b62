#include "coarse/results/tables.hpp"

#include <string_view>

#include "common/members.hpp"

namespace stria::coarse {

// The members of a row are the columns of its table.
STRIA_MEMBERS(HistoryRow, increment, cycle, load_factor, load, displacement, tip, x, y, a, K_I, K_II, J, CMOD, CTOD,
              newton_iterations, contact_length, plastic_zone, dissipation, plastic_zone_axis, T_stress, J_spread,
              K_spread, external_work, stored_energy, released_energy, balance_error, frictional_dissipation, opening)
STRIA_MEMBERS(CycleRow, cycle, tip, a, da, dN, K_max, K_min, K_op, K_cl, U, dK_eff, J_max, CTOD_range, forward_zone,
              cyclic_zone, newton_iterations, fine_points, fine_unknowns, wall_s, forward_zone_axis, cyclic_zone_axis,
              K_op_contact, K_op_offset, K_op_tension, opening_range, N, K_initial)
STRIA_MEMBERS(ClosureRow, cycle, tip, distance, K_op, K_cl, K_slip, K_slip_unloading)
STRIA_MEMBERS(FaceRow, increment, crack, s, x, y, opening, slip, pressure, shear, status)

namespace {

template <class Row> std::vector<std::string> columns_of() {
    std::vector<std::string> names;
    const Row row;
    for_each_member(row, [&](std::string_view name, const auto&) { names.emplace_back(name); });
    return names;
}

Cell cell_of(std::int64_t value) { return value; }
Cell cell_of(double value) { return value; }
Cell cell_of(const std::optional<std::int64_t>& value) { return value ? Cell(*value) : Cell(); }

template <class Row> std::vector<Cell> cells_in(const Row& row) {
    std::vector<Cell> cells;
    for_each_member(row, [&](std::string_view, const auto& value) { cells.push_back(cell_of(value)); });
    return cells;
}

}  // namespace

std::vector<std::string> history_columns() { return columns_of<HistoryRow>(); }
std::vector<std::string> cycle_columns() { return columns_of<CycleRow>(); }
std::vector<std::string> closure_columns() { return columns_of<ClosureRow>(); }
std::vector<std::string> face_columns() { return columns_of<FaceRow>(); }

std::vector<Cell> cells_of(const HistoryRow& row) { return cells_in(row); }
std::vector<Cell> cells_of(const CycleRow& row) { return cells_in(row); }
std::vector<Cell> cells_of(const ClosureRow& row) { return cells_in(row); }
std::vector<Cell> cells_of(const FaceRow& row) { return cells_in(row); }

}  // namespace stria::coarse
