#include "coarse/results/tables.hpp"

#include <array>
#include <string_view>

namespace stria::coarse {
namespace {

/// A column's name beside the value under it, so that the two cannot get out of step.
template <class Row> struct Column {
    std::string_view name;
    std::variant<std::int64_t Row::*, double Row::*, std::optional<std::int64_t> Row::*> value;
};

constexpr std::array history_table{
    Column<HistoryRow>{"increment", &HistoryRow::increment},
    Column<HistoryRow>{"cycle", &HistoryRow::cycle},
    Column<HistoryRow>{"load_factor", &HistoryRow::load_factor},
    Column<HistoryRow>{"load", &HistoryRow::load},
    Column<HistoryRow>{"displacement", &HistoryRow::displacement},
    Column<HistoryRow>{"tip", &HistoryRow::tip},
    Column<HistoryRow>{"x", &HistoryRow::x},
    Column<HistoryRow>{"y", &HistoryRow::y},
    Column<HistoryRow>{"a", &HistoryRow::a},
    Column<HistoryRow>{"K_I", &HistoryRow::K_I},
    Column<HistoryRow>{"K_II", &HistoryRow::K_II},
    Column<HistoryRow>{"J", &HistoryRow::J},
    Column<HistoryRow>{"CMOD", &HistoryRow::CMOD},
    Column<HistoryRow>{"CTOD", &HistoryRow::CTOD},
    Column<HistoryRow>{"newton_iterations", &HistoryRow::newton_iterations},
    Column<HistoryRow>{"contact_length", &HistoryRow::contact_length},
    Column<HistoryRow>{"plastic_zone", &HistoryRow::plastic_zone},
    Column<HistoryRow>{"dissipation", &HistoryRow::dissipation},
    Column<HistoryRow>{"plastic_zone_axis", &HistoryRow::plastic_zone_axis},
    Column<HistoryRow>{"T_stress", &HistoryRow::T_stress},
    Column<HistoryRow>{"J_spread", &HistoryRow::J_spread},
    Column<HistoryRow>{"K_spread", &HistoryRow::K_spread},
    Column<HistoryRow>{"external_work", &HistoryRow::external_work},
    Column<HistoryRow>{"stored_energy", &HistoryRow::stored_energy},
    Column<HistoryRow>{"released_energy", &HistoryRow::released_energy},
    Column<HistoryRow>{"balance_error", &HistoryRow::balance_error},
    Column<HistoryRow>{"frictional_dissipation", &HistoryRow::frictional_dissipation},
    Column<HistoryRow>{"opening", &HistoryRow::opening},
};

constexpr std::array cycle_table{
    Column<CycleRow>{"cycle", &CycleRow::cycle},
    Column<CycleRow>{"tip", &CycleRow::tip},
    Column<CycleRow>{"a", &CycleRow::a},
    Column<CycleRow>{"da", &CycleRow::da},
    Column<CycleRow>{"dN", &CycleRow::dN},
    Column<CycleRow>{"K_max", &CycleRow::K_max},
    Column<CycleRow>{"K_min", &CycleRow::K_min},
    Column<CycleRow>{"K_op", &CycleRow::K_op},
    Column<CycleRow>{"K_cl", &CycleRow::K_cl},
    Column<CycleRow>{"U", &CycleRow::U},
    Column<CycleRow>{"dK_eff", &CycleRow::dK_eff},
    Column<CycleRow>{"J_max", &CycleRow::J_max},
    Column<CycleRow>{"CTOD_range", &CycleRow::CTOD_range},
    Column<CycleRow>{"forward_zone", &CycleRow::forward_zone},
    Column<CycleRow>{"cyclic_zone", &CycleRow::cyclic_zone},
    Column<CycleRow>{"newton_iterations", &CycleRow::newton_iterations},
    Column<CycleRow>{"fine_points", &CycleRow::fine_points},
    Column<CycleRow>{"fine_unknowns", &CycleRow::fine_unknowns},
    Column<CycleRow>{"wall_s", &CycleRow::wall_s},
    Column<CycleRow>{"forward_zone_axis", &CycleRow::forward_zone_axis},
    Column<CycleRow>{"cyclic_zone_axis", &CycleRow::cyclic_zone_axis},
    Column<CycleRow>{"K_op_contact", &CycleRow::K_op_contact},
    Column<CycleRow>{"K_op_offset", &CycleRow::K_op_offset},
    Column<CycleRow>{"K_op_tension", &CycleRow::K_op_tension},
    Column<CycleRow>{"opening_range", &CycleRow::opening_range},
    Column<CycleRow>{"N", &CycleRow::N},
    Column<CycleRow>{"K_initial", &CycleRow::K_initial},
};

constexpr std::array closure_table{
    Column<ClosureRow>{"cycle", &ClosureRow::cycle},
    Column<ClosureRow>{"tip", &ClosureRow::tip},
    Column<ClosureRow>{"distance", &ClosureRow::distance},
    Column<ClosureRow>{"K_op", &ClosureRow::K_op},
    Column<ClosureRow>{"K_cl", &ClosureRow::K_cl},
    Column<ClosureRow>{"K_slip", &ClosureRow::K_slip},
    Column<ClosureRow>{"K_slip_unloading", &ClosureRow::K_slip_unloading},
};

constexpr std::array face_table{
    Column<FaceRow>{"increment", &FaceRow::increment},
    Column<FaceRow>{"crack", &FaceRow::crack},
    Column<FaceRow>{"s", &FaceRow::s},
    Column<FaceRow>{"x", &FaceRow::x},
    Column<FaceRow>{"y", &FaceRow::y},
    Column<FaceRow>{"opening", &FaceRow::opening},
    Column<FaceRow>{"slip", &FaceRow::slip},
    Column<FaceRow>{"pressure", &FaceRow::pressure},
    Column<FaceRow>{"shear", &FaceRow::shear},
    Column<FaceRow>{"status", &FaceRow::status},
};

Cell cell_of(std::int64_t value) { return value; }
Cell cell_of(double value) { return value; }
Cell cell_of(const std::optional<std::int64_t>& value) { return value ? Cell(*value) : Cell(); }

template <class Table> std::vector<std::string> names_of(const Table& table) {
    std::vector<std::string> names;
    for (const auto& column : table) names.emplace_back(column.name);
    return names;
}

template <class Table, class Row> std::vector<Cell> cells_in(const Table& table, const Row& row) {
    std::vector<Cell> cells;
    cells.reserve(table.size());
    for (const auto& column : table) {
        cells.push_back(std::visit([&](auto member) { return cell_of(row.*member); }, column.value));
    }
    return cells;
}

}  // namespace

std::vector<std::string> history_columns() { return names_of(history_table); }
std::vector<std::string> cycle_columns() { return names_of(cycle_table); }
std::vector<std::string> closure_columns() { return names_of(closure_table); }
std::vector<std::string> face_columns() { return names_of(face_table); }

std::vector<Cell> cells_of(const HistoryRow& row) { return cells_in(history_table, row); }
std::vector<Cell> cells_of(const CycleRow& row) { return cells_in(cycle_table, row); }
std::vector<Cell> cells_of(const ClosureRow& row) { return cells_in(closure_table, row); }
std::vector<Cell> cells_of(const FaceRow& row) { return cells_in(face_table, row); }

}  // namespace stria::coarse
