// What an analysis remembers, and how it goes on from that.
#include "coarse/analysis/fatigue_analysis.hpp"
#include "common/error.hpp"

namespace stria::coarse {
namespace {

AnalysisState::Polyline polyline_of(const CrackSection& crack) {
    AnalysisState::Polyline line;
    for (const Vec2& point : crack.points) {
        line.x.push_back(point.x());
        line.y.push_back(point.y());
    }
    return line;
}

std::vector<Vec2> points_of(const AnalysisState::Polyline& line) {
    std::vector<Vec2> points;
    for (std::size_t k = 0; k < line.x.size(); ++k) points.emplace_back(line.x[k], line.y.at(k));
    return points;
}

}  // namespace

AnalysisState FatigueAnalysis::state() const {
    AnalysisState state;
    for (const CrackSection& crack : scene_->input.cracks) state.cracks.push_back(polyline_of(crack));
    state.in_zone = structure_->in_zone();
    state.far = far_;
    state.displacement = committed_behind_ ? equilibrium_->structure_displacement() : committed_;
    state.load_factor = load_factor_;
    state.largest_force = largest_force_;
    state.closed = closed_;
    state.cycle = cycle_meter_.memory();
    state.last_cycle = last_cycle_;
    state.nominal = nominal_;
    state.increment = increment_;
    state.newton_iterations = newton_iterations_;
    state.extensions = extensions_;
    state.warnings = warnings_;
    state.flowing_rings = flowing_rings_;
    state.growth_ended = growth_ended_;
    state.load = controller_.position();
    state.work = work_;
    state.equilibrium = equilibrium_->state();
    if (!state.in_zone.none()) state.zone = factory_.zone_snapshot();
    return state;
}

void FatigueAnalysis::restore(const AnalysisState& from) {
    Case input = scene_->input;
    for (std::size_t k = 0; k < input.cracks.size(); ++k) input.cracks[k].points = points_of(from.cracks.at(k));
    if (input != scene_->input) {
        if (input.growth && input.growth->retain == Retain::All)
            throw CaseError(
                "--resume: growth.retain = \"all\" keeps functions of old tips that a checkpoint does not hold");
        grown_ = std::make_unique<Scene>(make_scene(input, scene_->mesh));
        scene_ = grown_.get();
        nominal_displacement_ = {};
    }
    require(std::ssize(from.displacement) == scene_->enriched.unknowns &&
                from.in_zone.size() == std::ssize(scene_->mesh.elements),
            "a state is of the mesh of its scene");
    committed_ = from.displacement;
    load_factor_ = from.load_factor;
    largest_force_ = from.largest_force;
    closed_ = from.closed;
    cycle_meter_.resume(from.cycle);
    last_cycle_ = from.last_cycle;
    nominal_ = from.nominal;
    controller_.set_scale(target_of_unit(scene_->input.load, nominal_, grown()));
    increment_ = from.increment;
    newton_iterations_ = from.newton_iterations;
    extensions_ = from.extensions;
    warnings_ = from.warnings;
    flowing_rings_ = from.flowing_rings;
    growth_ended_ = from.growth_ended;
    build(from.in_zone, &from);
    equilibrium_->restore(from.equilibrium);
    controller_.resume(from.load);
    work_ = from.work;
}

}  // namespace stria::coarse
