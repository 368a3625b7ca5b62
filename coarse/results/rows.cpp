#include "coarse/results/rows.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "common/index.hpp"

namespace stria::coarse {
namespace {

HistoryRow row_of_body(const Increment& increment, double load, double displacement) {
    HistoryRow row;
    row.increment = increment.number;
    row.cycle = increment.step.cycle;
    row.load_factor = increment.load_factor;
    row.load = load;
    row.displacement = displacement;
    row.newton_iterations = increment.newton.count();
    row.dissipation = increment.work.dissipated;
    row.external_work = increment.work.external;
    row.stored_energy = increment.work.stored;
    row.released_energy = increment.work.released;
    row.balance_error = increment.work.error();
    row.frictional_dissipation = increment.work.by_friction;
    return row;
}

void put_tip(HistoryRow& row, const TipResult& tip) {
    row.a = tip.a;
    row.K_I = tip.K_I;
    row.K_II = tip.K_II;
    row.J = tip.J;
    row.CMOD = tip.CMOD;
    row.CTOD = tip.CTOD;
    row.opening = tip.opening;
    row.contact_length = tip.contact_length;
    row.plastic_zone = tip.plastic_zone;
    row.plastic_zone_axis = tip.plastic_zone_axis;
    row.T_stress = tip.T_stress;
    row.J_spread = tip.J_spread;
    row.K_spread = tip.K_spread;
}

}  // namespace

std::vector<HistoryRow> history_rows(const Increment& increment, const std::vector<Tip>& tips, double load,
                                     double displacement) {
    const HistoryRow body = row_of_body(increment, load, displacement);
    if (increment.tips.empty()) return {body};
    std::vector<HistoryRow> rows(increment.tips.size(), body);
    for (std::size_t t = 0; t < rows.size(); ++t) {
        rows[t].tip = static_cast<std::int64_t>(t);
        rows[t].x = tips[t].position.x();
        rows[t].y = tips[t].position.y();
        put_tip(rows[t], increment.tips[t]);
    }
    return rows;
}

CycleRow cycle_row(const Increment& increment, int tip) {
    const CycleResult& cycle = increment.cycles[at(tip)];
    CycleRow row;
    row.cycle = increment.step.cycle;
    row.tip = tip;
    row.a = cycle.a;
    row.da = cycle.da;
    row.dN = cycle.dN;
    row.K_max = cycle.K_max;
    row.K_min = cycle.K_min;
    row.K_op = cycle.opening.K_op;
    row.K_cl = cycle.opening.K_cl;
    row.U = (row.K_max - row.K_op) / (row.K_max - row.K_min);
    row.dK_eff = row.K_max - row.K_op;
    row.J_max = cycle.J_max;
    row.CTOD_range = cycle.CTOD_range();
    row.opening_range = cycle.opening_range();
    row.forward_zone = cycle.forward;
    row.cyclic_zone = cycle.cyclic;
    row.fine_points = increment.zone.points;
    row.fine_unknowns = increment.zone.unknowns;
    row.forward_zone_axis = cycle.forward_axis;
    row.cyclic_zone_axis = cycle.cyclic_axis;
    row.K_op_contact = cycle.contact.front().K_op;
    row.K_op_offset = cycle.offset.K_op;
    row.K_op_tension = cycle.tension.K_op;
    row.K_initial = cycle.K_initial;
    return row;
}

std::vector<ClosureRow> closure_rows(const Increment& increment, int tip, const ClosureMeter& closure) {
    std::vector<ClosureRow> rows;
    const CycleResult& cycle = increment.cycles[at(tip)];
    for (std::size_t k = 0; k < cycle.contact.size(); ++k) {
        const auto slip = [&](const std::vector<double>& K) { return K.empty() ? missing : K[k]; };
        rows.push_back({increment.step.cycle, tip, closure.distances(tip)[k], cycle.contact[k].K_op,
                        cycle.contact[k].K_cl, slip(cycle.K_slip), slip(cycle.K_slip_unloading)});
    }
    return rows;
}

std::vector<std::string> load_columns(const Case& input) {
    std::vector<std::string> columns{"increment", "cycle", "load_factor"};
    for (const LoadCaseSection& load_case : input.load_cases) columns.push_back(load_case.name);
    int travelling = 0;
    for (const BoundarySection& boundary : input.boundaries)
        if (boundary.travelling) columns.push_back(fmt::format("position_{}", ++travelling));
    columns.emplace_back("work");
    for (const LoadCaseSection& load_case : input.load_cases) columns.push_back("work_" + load_case.name);
    for (int k = 1; k <= travelling; ++k) columns.push_back(fmt::format("work_position_{}", k));
    return columns;
}

/// Shares of the external work: of [load], of each load case, of each pressure that travels, in all of its positions.
void add_work(const Case& input, const WorkBalance& work, std::vector<Cell>& cells) {
    const Eigen::Index named = std::ssize(input.load_cases), positions = positions_of_travel(input.load);
    const Eigen::Index travelling = std::ranges::count_if(
        input.boundaries, [](const BoundarySection& boundary) { return boundary.travelling.has_value(); });
    Eigen::VectorXd shares = work.by_cases;
    if (shares.size() == 0) shares.setZero(named + travelling * positions);
    cells.emplace_back(work.external - shares.sum());
    for (Eigen::Index k = 0; k < named; ++k) cells.emplace_back(shares[k]);
    for (Eigen::Index k = 0; k < travelling; ++k)
        cells.emplace_back(shares.segment(named + k * positions, positions).sum());
}

std::vector<Cell> load_cells(const Case& input, const Increment& increment) {
    const LoadFactors factors(increment.load_factor, increment.step.target.cases);
    std::vector<Cell> cells{std::int64_t{increment.number}, std::int64_t{increment.step.cycle}, factors.main};
    Eigen::Index k = 0;
    for (; k < std::ssize(input.load_cases); ++k) cells.emplace_back(factors.of_case(k));
    const int positions = positions_of_travel(input.load);
    for (const BoundarySection& boundary : input.boundaries) {
        if (!boundary.travelling) continue;
        double sum = 0.0, moment = 0.0;
        for (int j = 0; j < positions; ++j, ++k) {
            const double factor = factors.of_case(k);
            sum += factor;
            moment += factor * std::lerp(boundary.travelling->from, boundary.travelling->to,
                                         static_cast<double>(j) / (positions - 1));
        }
        cells.emplace_back(moment / sum);
    }
    add_work(input, increment.work, cells);
    return cells;
}

std::vector<std::string> load_case_columns(const Case& input) {
    std::vector<std::string> columns{"cycle", "tip", "a", "K_I", "K_II"};
    for (const LoadCaseSection& load_case : input.load_cases)
        for (const char* mode : {"K_I_", "K_II_"}) columns.push_back(mode + load_case.name);
    return columns;
}

std::vector<Cell> load_case_cells(const Case& input, const Increment& increment, int tip) {
    const TipResult& alone = increment.nominal[at(tip)];
    std::vector<Cell> cells{std::int64_t{increment.step.cycle}, std::int64_t{tip}, alone.a, alone.K_I, alone.K_II};
    for (std::size_t k = 0; k < input.load_cases.size(); ++k) {
        cells.emplace_back(alone.K_I_of_cases[k]);
        cells.emplace_back(alone.K_II_of_cases[k]);
    }
    return cells;
}

FaceRow face_row(std::int64_t increment, const coupling::FaceSample& sample) {
    return {increment,      sample.crack, sample.s,        sample.x,     sample.y,
            sample.opening, sample.slip,  sample.pressure, sample.shear, sample.status};
}

}  // namespace stria::coarse
