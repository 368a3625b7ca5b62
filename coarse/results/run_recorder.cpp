#include "coarse/results/run_recorder.hpp"

#include <algorithm>

#include "coarse/fields/zone_fields.hpp"
#include "coarse/load/growth_schedule.hpp"
#include "coarse/load/load_history.hpp"
#include "coarse/results/result_files.hpp"
#include "coarse/results/rows.hpp"
#include "common/io/whole_file.hpp"
#include "common/stopwatch.hpp"

namespace stria::coarse {

namespace {

/// After the rows that it had where the run is resumed, or anew.
CsvWriter table(const std::filesystem::path& path, const std::vector<std::string>& columns, const RecorderState* from,
                std::uint64_t RecorderState::*rows) {
    return from != nullptr ? CsvWriter(path, columns, from->*rows) : CsvWriter(path, columns);
}

}  // namespace

RunRecorder::RunRecorder(const Scene& scene, std::filesystem::path directory,
                         std::function<coupling::ZoneState()> zone_state, const RecorderState* from)
    : output_(scene.input.output), last_cycle_(cycle_count(scene.input.load)), growth_(scene.input.growth),
      zone_state_(std::move(zone_state)), loaded_(loaded_boundary(scene.mesh, scene.input, scene.loads)),
      history_(table(directory / result_files::history, history_columns(), from, &RecorderState::history_rows)),
      cycles_(table(directory / result_files::cycles, cycle_columns(), from, &RecorderState::cycle_rows)),
      faces_(table(directory / result_files::faces, face_columns(), from, &RecorderState::face_rows)),
      fields_(directory, scene.input.output.format, from ? from->fields : std::vector<FieldWriter::Step>()) {
    if (!scene.input.closure.profile.empty())
        closure_.emplace(
            table(directory / result_files::closure, closure_columns(), from, &RecorderState::closure_rows));
    if (!scene.loads.cases.empty())
        loads_.emplace(
            table(directory / result_files::loads, load_columns(scene.input), from, &RecorderState::load_rows));
    if (!scene.input.load_cases.empty())  // its rows are those of cycles.csv
        load_cases_.emplace(table(directory / result_files::load_cases, load_case_columns(scene.input), from,
                                  &RecorderState::cycle_rows));
    if (from == nullptr) return;
    cycle_iterations_ = from->cycle_iterations;
    N_ = from->N;
    cycle_start_s_ = -from->cycle_s;
}

RecorderState RunRecorder::state() const {
    for (const CsvWriter* writer : {&history_, &cycles_, &faces_, closure_ ? &*closure_ : nullptr,
                                    loads_ ? &*loads_ : nullptr, load_cases_ ? &*load_cases_ : nullptr})
        if (writer != nullptr) sync_file(writer->path());
    return {.history_rows = history_.rows(),
            .cycle_rows = cycles_.rows(),
            .face_rows = faces_.rows(),
            .closure_rows = closure_ ? closure_->rows() : 0,
            .load_rows = loads_ ? loads_->rows() : 0,
            .fields = fields_.steps(),
            .cycle_iterations = cycle_iterations_,
            .cycle_s = seconds() - cycle_start_s_,
            .N = N_};
}

void RunRecorder::record(const Increment& increment, const Structure& structure, const ClosureMeter& closure) {
    const Stopwatch watch(output_s_);
    zone_ = increment.zone;
    if (output_.history == Written::All || increment.step.at_extreme() || increment.step.reversal)
        record_history(increment, structure.scene());
    cycle_iterations_ += increment.newton.count();
    if (due(output_.faces, increment)) record_faces(increment, structure);
    if (due(output_.fields, increment)) record_fields(increment, structure);
    if (increment.step.ends_cycle) record_cycle(increment, closure, structure.scene().input);
    if (increment.step.ends_cycle || increment.step.cycle == 0) begin_cycle();
}

void RunRecorder::record_end(const Increment& last, const Structure& structure) {
    if (in_last_cycle(last)) return;  // its extremes are written
    const Stopwatch watch(output_s_);
    if (output_.faces == Written::Extremes) record_faces(last, structure);
    if (output_.fields == Written::Extremes) record_fields(last, structure);
}

void RunRecorder::record_faces(const Increment& increment, const Structure& structure) {
    const Eigen::VectorXd& u = increment.equilibrium->near_displacement();
    for (const coupling::FaceSample& sample : face_samples(structure, u, increment.zone))
        faces_.row(cells_of(face_row(increment.number, sample)));
}

void RunRecorder::record_fields(const Increment& increment, const Structure& structure) {
    std::optional<coupling::ZoneState> zone;
    if (!structure.in_zone().none()) zone = zone_state_();
    FieldData fields = make_fields(structure, increment.equilibrium->structure_displacement(), zone ? &*zone : nullptr,
                                   increment.zone.faces);
    fields.whole_arrays = {{"load_factor", 1, {increment.load_factor}},
                           {"cycle", 1, {double(increment.step.cycle)}},
                           {"increment", 1, {double(increment.number)}}};
    fields_.write(increment.number, fields, increment.step.moment);
}

void RunRecorder::record_history(const Increment& increment, const Scene& present) {
    const double displacement = loaded_ && loaded_->has_direction() ? increment.machine.displacement : missing;
    last_ = history_rows(increment, present.enriched.tips, load(increment), displacement);
    for (const HistoryRow& row : last_) history_.row(cells_of(row));
    last_K_initial_.clear();
    for (const TipResult& tip : increment.nominal) last_K_initial_.push_back(tip.K_initial);
    if (loads_) loads_->row(load_cells(present.input, increment));
}

void RunRecorder::record_cycle(const Increment& increment, const ClosureMeter& closure, const Case& input) {
    // One of its cycles passes for all tips.
    if (!increment.cycles.empty()) N_ += increment.cycles.front().dN;
    for (int t = 0; t < std::ssize(increment.cycles); ++t) {
        CycleRow row = cycle_row(increment, t);
        row.N = N_;
        row.newton_iterations = cycle_iterations_;
        row.wall_s = seconds() - cycle_start_s_;
        cycles_.row(cells_of(row));
        if (load_cases_) load_cases_->row(load_case_cells(input, increment, t));
        if (!closure_) continue;
        for (const ClosureRow& opening : closure_rows(increment, t, closure)) closure_->row(cells_of(opening));
    }
}

void RunRecorder::begin_cycle() {
    cycle_iterations_ = 0;
    cycle_start_s_ = seconds();
}

double RunRecorder::seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

// Of the load history, or that in which growth finds a crack as long as asked. Other ends of growth come unforeseen.
bool RunRecorder::in_last_cycle(const Increment& increment) const {
    if (increment.step.cycle == last_cycle_) return true;
    return growth_ && increment.step.cycle % growth_->every == 0 &&
           std::ranges::any_of(increment.tips,
                               [&](const TipResult& tip) { return is_as_long_as_asked(*growth_, tip.a); });
}

bool RunRecorder::due(Written wish, const Increment& increment) const {
    const bool extreme = increment.step.at_extreme();
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
    return extreme && in_last_cycle(increment);
}

double RunRecorder::load(const Increment& increment) const {
    if (!loaded_ || !loaded_->has_direction()) return missing;
    double load = increment.machine.force + increment.load_factor * loaded_->resultant.dot(loaded_->direction);
    const LoadFactors factors(increment.load_factor, increment.step.target.cases);
    for (std::size_t k = 0; k < loaded_->in_cases.size(); ++k)
        load += factors.of_case(static_cast<Eigen::Index>(k)) * loaded_->in_cases[k].dot(loaded_->direction);
    return load;
}

}  // namespace stria::coarse
