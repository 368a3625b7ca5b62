#include "coarse/results/run_recorder.hpp"

#include <algorithm>
#include <cmath>

#include "coarse/results/zone_fields.hpp"
#include "common/io/whole_file.hpp"
#include "common/stopwatch.hpp"

namespace stria::coarse {

namespace {

/// After its first `rows` rows, or anew.
CsvWriter table(const std::filesystem::path& path, const std::vector<std::string>& columns, bool go_on,
                std::uint64_t rows) {
    return go_on ? CsvWriter(path, columns, rows) : CsvWriter(path, columns);
}

}  // namespace

RunRecorder::RunRecorder(const Scene& scene, std::filesystem::path directory,
                         std::function<coupling::ZoneState()> zone_state, const RecorderState* from)
    : scene_(scene), zone_state_(std::move(zone_state)), loaded_(loaded_boundary(scene.mesh, scene.input.boundaries)),
      history_(table(directory / "history.csv", history_columns(), from, from ? from->history_rows : 0)),
      cycles_(table(directory / "cycles.csv", cycle_columns(), from, from ? from->cycle_rows : 0)),
      faces_(table(directory / "faces.csv", face_columns(), from, from ? from->face_rows : 0)),
      fields_(directory, field_format(scene.input.output.format),
              from ? from->fields : std::vector<FieldWriter::Step>()) {
    if (!scene.input.closure.profile.empty())
        closure_.emplace(table(directory / "closure.csv", closure_columns(), from, from ? from->closure_rows : 0));
    if (from == nullptr) return;
    cycle_iterations_ = from->cycle_iterations;
    cycle_start_s_ = -from->cycle_s;
}

RecorderState RunRecorder::state() const {
    for (const CsvWriter* writer : {&history_, &cycles_, &faces_, closure_ ? &*closure_ : nullptr})
        if (writer != nullptr) sync_file(writer->path());
    return {.history_rows = history_.rows(),
            .cycle_rows = cycles_.rows(),
            .face_rows = faces_.rows(),
            .closure_rows = closure_ ? closure_->rows() : 0,
            .fields = fields_.steps(),
            .cycle_iterations = cycle_iterations_,
            .cycle_s = seconds() - cycle_start_s_};
}

void RunRecorder::record(const Increment& increment, const Structure& structure, const ClosureMeter& closure) {
    const Stopwatch watch(output_s_);
    zone_ = increment.zone;
    present_ = &structure.scene();
    record_history(increment, structure);
    cycle_iterations_ += increment.newton.count();
    if (due(scene_.input.output.faces, increment.step)) {
        const Eigen::VectorXd& u = increment.equilibrium->near_displacement();
        for (const coupling::FaceSample& sample : face_samples(structure, u, increment.zone)) {
            faces_.row(cells_of(face_row(increment.number, sample)));
        }
    }
    if (due(scene_.input.output.fields, increment.step)) {
        std::optional<coupling::ZoneState> zone;
        if (!structure.in_zone().none()) zone = zone_state_();
        FieldData fields = make_fields(structure, increment.equilibrium->structure_displacement(),
                                       zone ? &*zone : nullptr, increment.zone.faces);
        fields.whole_arrays = {{"load_factor", 1, {increment.load_factor}},
                               {"cycle", 1, {double(increment.step.cycle)}}};
        fields_.write(increment.number, fields);
    }
    if (increment.step.ends_cycle) record_cycle(increment, closure);
    if (increment.step.ends_cycle || increment.step.cycle == 0) begin_cycle();
}

void RunRecorder::record_history(const Increment& increment, const Structure&) {
    HistoryRow row;
    row.increment = increment.number;
    row.cycle = increment.step.cycle;
    row.load_factor = increment.load_factor;
    row.load = load(increment);
    row.displacement = loaded_ ? increment.machine.displacement : missing;
    row.newton_iterations = increment.newton.count();
    row.dissipation = increment.work.dissipated;
    row.external_work = increment.work.external;
    row.stored_energy = increment.work.stored;
    row.released_energy = increment.work.released;
    row.balance_error = increment.work.error();
    row.frictional_dissipation = increment.work.by_friction;
    last_.clear();
    if (increment.tips.empty()) last_.push_back(row);
    for (std::size_t t = 0; t < increment.tips.size(); ++t) {
        const TipResult& tip = increment.tips[t];
        row.tip = static_cast<std::int64_t>(t);
        row.x = present_->enriched.tips[t].position.x();
        row.y = present_->enriched.tips[t].position.y();
        row.a = tip.a;
        row.K_I = tip.K_I;
        row.K_II = tip.K_II;
        row.J = tip.J;
        row.CMOD = tip.CMOD;
        row.CTOD = tip.CTOD;
        row.contact_length = tip.contact_length;
        row.plastic_zone = tip.plastic_zone;
        row.plastic_zone_axis = tip.plastic_zone_axis;
        row.T_stress = tip.T_stress;
        row.J_spread = tip.J_spread;
        row.K_spread = tip.K_spread;
        last_.push_back(row);
    }
    for (const HistoryRow& written : last_) history_.row(cells_of(written));
}

void RunRecorder::record_cycle(const Increment& increment, const ClosureMeter& closure) {
    for (std::size_t t = 0; t < increment.cycles.size(); ++t) {
        const CycleResult& cycle = increment.cycles[t];
        CycleRow row;
        row.cycle = increment.step.cycle;
        row.tip = static_cast<std::int64_t>(t);
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
        row.forward_zone = cycle.forward;
        row.cyclic_zone = cycle.cyclic;
        row.newton_iterations = cycle_iterations_;
        row.fine_points = increment.zone.points;
        row.fine_unknowns = increment.zone.unknowns;
        row.wall_s = seconds() - cycle_start_s_;
        row.forward_zone_axis = cycle.forward_axis;
        row.cyclic_zone_axis = cycle.cyclic_axis;
        row.K_op_contact = cycle.contact.front().K_op;
        row.K_op_offset = cycle.offset.K_op;
        row.K_op_tension = cycle.tension.K_op;
        cycles_.row(cells_of(row));
        if (!closure_) continue;
        for (std::size_t k = 0; k < cycle.contact.size(); ++k) {
            const OpeningLoads& loads = cycle.contact[k];
            closure_->row(cells_of(
                ClosureRow{row.cycle, *row.tip, closure.distances(static_cast<int>(t))[k], loads.K_op, loads.K_cl}));
        }
    }
}

void RunRecorder::begin_cycle() {
    cycle_iterations_ = 0;
    cycle_start_s_ = seconds();
}

double RunRecorder::seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

bool RunRecorder::due(Written wish, const LoadStep& step) const {
    const bool extreme = step.at_maximum || step.at_minimum || step.at_zero;
    switch (wish) {
    case Written::All:
        return true;
    case Written::None:
        return false;
    case Written::Cycles:
        return extreme;
    case Written::Extremes:
        break;
    }
    return extreme && step.cycle == cycle_count(scene_.input.load);
}

double RunRecorder::load(const Increment& increment) const {
    if (!loaded_) return missing;
    if (!loaded_->resultant.isZero(0.0)) return increment.load_factor * loaded_->resultant.dot(loaded_->direction);
    return increment.machine.force;
}

}  // namespace stria::coarse
