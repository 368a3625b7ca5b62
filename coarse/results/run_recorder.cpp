#include "coarse/results/run_recorder.hpp"

#include <algorithm>
#include <cmath>

#include "coarse/crack_growth.hpp"
#include "coarse/results/zone_fields.hpp"
#include "common/stopwatch.hpp"

namespace stria::coarse {

RunRecorder::RunRecorder(const Scene& scene, std::filesystem::path directory,
                         std::function<coupling::ZoneState()> zone_state)
    : scene_(scene), zone_state_(std::move(zone_state)), loaded_(loaded_boundary(scene.mesh, scene.input.boundaries)),
      history_(directory / "history.csv", history_columns()), cycles_(directory / "cycles.csv", cycle_columns()),
      faces_(directory / "faces.csv", face_columns()), fields_(directory, field_format(scene.input.output.format)),
      cycle_(scene.enriched.tips.size()) {}

void RunRecorder::record(const Increment& increment, const Structure& structure,
                         const std::vector<TipResult>& nominal) {
    const Stopwatch watch(output_s_);
    zone_ = increment.zone;
    nominal_ = nominal;
    present_ = &structure.scene();
    record_history(increment, structure);
    record_cycle(increment);
    if (due(scene_.input.output.faces, increment.step)) {
        for (const coupling::FaceSample& sample : face_samples(structure, increment.displacement, increment.zone)) {
            faces_.row(cells_of(face_row(increment.number, sample)));
        }
    }
    if (due(scene_.input.output.fields, increment.step)) {
        std::optional<coupling::ZoneState> zone;
        if (std::ranges::find(structure.in_zone(), static_cast<char>(1)) != structure.in_zone().end())
            zone = zone_state_();
        FieldData fields =
            make_fields(structure, increment.displacement, zone ? &*zone : nullptr, increment.zone.faces);
        fields.whole_arrays = {{"load_factor", 1, {increment.load_factor}},
                               {"cycle", 1, {double(increment.step.cycle)}}};
        fields_.write(increment.number, fields);
    }
    if (increment.step.ends_cycle) finish_cycle(increment);
    if (increment.step.cycle == 0 && increment.step.reversal) begin_cycle();  // the ramp is over
    last_target_ = increment.step.target.value;
}

void RunRecorder::record_history(const Increment& increment, const Structure&) {
    HistoryRow row;
    row.increment = increment.number;
    row.cycle = increment.step.cycle;
    row.load_factor = increment.load_factor;
    row.load = load(increment);
    row.displacement = displacement(increment);
    row.newton_iterations = increment.newton.count();
    row.dissipation = increment.zone.dissipation;
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

void RunRecorder::record_cycle(const Increment& increment) {
    cycle_iterations_ += increment.newton.count();
    for (const ContactChange& change : increment.contact_changes) {
        const auto t = static_cast<std::size_t>(change.tip);
        (change.closes ? cycle_[t].K_cl : cycle_[t].K_op) = nominal_[t].K_I * change.load_factor;
        cycle_[t].touched = true;
    }
    const bool loading = increment.step.target.value > last_target_;
    for (std::size_t t = 0; t < increment.tips.size(); ++t) {
        CycleSoFar& cycle = cycle_[t];
        const TipResult& tip = increment.tips[t];
        const double K = nominal_[t].K_I * increment.load_factor;
        cycle.was_open = cycle.was_open || increment.closed.empty() || increment.closed[t] == 0;
        cycle.K_max = std::max(cycle.K_max, K);
        cycle.K_min = std::min(cycle.K_min, K);
        cycle.J_max = std::max(cycle.J_max, tip.J);
        if (std::isfinite(tip.CTOD)) {
            cycle.CTOD_max = std::max(cycle.CTOD_max, tip.CTOD);
            cycle.CTOD_min = std::min(cycle.CTOD_min, tip.CTOD);
        }
        double& extent = loading ? cycle.forward : cycle.cyclic;
        double& axis = loading ? cycle.forward_axis : cycle.cyclic_axis;
        extent = std::max(extent, tip.plastic_zone);
        axis = std::max(axis, tip.plastic_zone_axis);
    }
}

void RunRecorder::finish_cycle(const Increment& increment) {
    const double now = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    for (std::size_t t = 0; t < increment.tips.size(); ++t) {
        const CycleSoFar& cycle = cycle_[t];
        CycleRow row;
        row.cycle = increment.step.cycle;
        row.tip = static_cast<std::int64_t>(t);
        row.a = increment.tips[t].a;
        row.da = increment.tips[t].a - cycle.a;
        row.K_max = cycle.K_max;
        row.K_min = cycle.K_min;
        // A crack that never closes is open down to the minimum; of one that never opens there is nothing to say.
        row.K_op = cycle.touched || !cycle.was_open ? cycle.K_op : cycle.K_min;
        row.K_cl = cycle.touched || !cycle.was_open ? cycle.K_cl : cycle.K_min;
        row.U = (row.K_max - row.K_op) / (row.K_max - row.K_min);
        row.dK_eff = row.K_max - row.K_op;
        row.dN = scene_.input.growth ? cycles_of_increment(*scene_.input.growth, row.K_max, row.K_min, row.K_op) : 1.0;
        row.J_max = cycle.J_max;
        if (cycle.CTOD_max >= cycle.CTOD_min) row.CTOD_range = cycle.CTOD_max - cycle.CTOD_min;
        row.forward_zone = cycle.forward;
        row.cyclic_zone = cycle.cyclic;
        row.forward_zone_axis = cycle.forward_axis;
        row.cyclic_zone_axis = cycle.cyclic_axis;
        row.newton_iterations = cycle_iterations_;
        row.fine_points = increment.zone.points;
        row.fine_unknowns = increment.zone.unknowns;
        row.wall_s = now - cycle_start_s_;
        cycles_.row(cells_of(row));
    }
    begin_cycle();
}

// A cycle runs from maximum to maximum: the one it starts from counts.
void RunRecorder::begin_cycle() {
    for (std::size_t t = 0; t < cycle_.size(); ++t) {
        cycle_[t] = {};
        const HistoryRow& row = last_[t];
        cycle_[t].K_max = cycle_[t].K_min = nominal_[t].K_I * row.load_factor;
        cycle_[t].J_max = row.J;
        cycle_[t].a = row.a;
        if (std::isfinite(row.CTOD)) cycle_[t].CTOD_max = cycle_[t].CTOD_min = row.CTOD;
    }
    cycle_iterations_ = 0;
    cycle_start_s_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
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
    int cycles = 0;
    for (const LoadBlock& block : scene_.input.load.blocks) cycles += block.cycles;
    return extreme && step.cycle == cycles;
}

double RunRecorder::load(const Increment& increment) const {
    if (!loaded_) return missing;
    if (!loaded_->resultant.isZero(0.0)) return increment.load_factor * loaded_->resultant.dot(loaded_->direction);
    double sum = 0.0;
    for (const int node : loaded_->nodes) {
        for (int c = 0; c < 2; ++c) {
            const int unknown = present_->enriched.unknown(node, 0, c);
            const auto found = std::ranges::lower_bound(present_->prescribed, unknown, {}, &PrescribedUnknown::unknown);
            if (found == present_->prescribed.end() || found->unknown != unknown) continue;
            sum += loaded_->direction[c] * increment.reactions[found - present_->prescribed.begin()];
        }
    }
    return sum;
}

double RunRecorder::displacement(const Increment& increment) const {
    return loaded_ ? present_->mean_displacement.dot(increment.displacement) : missing;
}

}  // namespace stria::coarse
