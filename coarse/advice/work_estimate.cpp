#include "coarse/advice/work_estimate.hpp"

#include <algorithm>
#include <cmath>

#include "coarse/elements/near_elements.hpp"
#include "coarse/enrichment/tip_reach.hpp"
#include "coarse/zone/structure_stresses.hpp"
#include "coarse/zone/zone_selection.hpp"
#include "common/case/case_questions.hpp"
#include "common/index.hpp"
#include "common/material/linear_hardening.hpp"
#include "common/memory.hpp"

namespace stria::coarse {
namespace {

// Seconds of a processor of 2026, measured on cases of which one or the other takes nearly all. A point that flows: the
// return in parts of plane stress or of hardening that is not linear, or the exact one.
constexpr double for_unknown = 12e-6, for_unknown_of_load = 0.5e-6, for_point = 0.13e-6, for_flow = 1.1e-6,
                 for_exact_flow = 0.4e-6, for_row = 0.3e-3, for_iteration = 0.3e-3;
constexpr double for_factor = 0.9e-6;    // an unknown of the zone in an iteration, of fronts below which points flow
constexpr double least_factored = 0.25;  // of them: faces move, and some flow is in many fronts
// Of the body's seconds, for a step of growth: of an elastic body, and where the far body serves beside a zone.
constexpr double of_set_up = 0.4, of_set_up_beside_zone = 0.2;
// Chosen increments of a cycle that presses faces together: until its half cycles are measured, and then: 49 to 81.
constexpr double compressed_at_first = 32.0, compressed_then = 60.0, until_measured = 4.0;
constexpr double iterations = 4.0;  // of an increment; 2 to 4 in shipped cases, 6.5 with trials for four opening loads
constexpr double of_release = 7.0;  // iterations that open the faces of a growth, from one equilibrium to the next
constexpr double evaluated = 0.4;   // of the points, in a mean iteration: others rest or are proven elastic

// Of the square and the cube of the unknowns on the rim of the far body: its tangent is a full matrix, and so is that
// of what is between it and the crack.
constexpr double bytes_for_rim = 20.0, seconds_for_rim = 25e-12;

// Each of the first half cycles is looked at half way, where what travels is, and at its end.
constexpr std::size_t most_legs = 4;

/// A value on the way of a leg. Where a displacement is controlled the first one begins where the boundary stands.
double value_on_way(const Case& input, const CaseHistories& histories, const UnitDisplacement& unit, std::size_t leg,
                    double way) {
    const Leg& there = histories.legs()[leg];
    const bool is_first = leg == (histories.leads() ? 1U : 0U);
    const bool is_moved = is_first && input.load.control == Control::Displacement;
    return std::lerp(is_moved ? unit.beside(histories.at_start()) : there.from, there.to, way);
}

/// Where the elastic body would yield.
ElementSet yields(const NominalSolution& nominal) {
    const Scene& scene = nominal.structure->scene();
    ElementSet found(scene.mesh->elements.size());
    const double limit = scene.materials.weakest_yield_stress();
    if (!std::isfinite(limit)) return found;
    const CaseHistories histories(scene.input);
    const UnitResponse unit = unit_response(nominal);
    const double scale = target_of_unit(scene.input.load, unit.K_I, 0.0);
    const bool is_moved = scene.input.load.control == Control::Displacement;
    const std::vector<Leg>& legs = histories.legs();
    const auto look = [&](std::size_t leg, double way) {
        const int increment = std::max(1, static_cast<int>(way * scene.input.load.first_steps() / 2));
        const double value = value_on_way(scene.input, histories, unit.displacement, leg, way);
        const Eigen::VectorXd of_cases =
            histories.at({.leg = leg, .way = way, .increment = increment, .share = 1.0, .scale = scale});
        double factor = scale * value;
        if (is_moved) factor = legs[leg].leads ? 0.0 : unit.displacement.load_factor_at(value, of_cases);
        const Eigen::VectorXd u = nominal.structure->expand({}, {factor, of_cases}, 1.0);
        for (const int element : elements_beyond(limit, *nominal.structure, u)) found.insert(element);
    };
    for (std::size_t leg = 0; leg < std::min(legs.size(), most_legs); ++leg)
        for (const double way : {0.5, 1.0}) look(leg, way);
    for (const double sign : {1.0, -1.0}) {
        const auto largest = std::ranges::max_element(legs, {}, [&](const Leg& leg) { return sign * leg.to; });
        if (largest != legs.end()) look(static_cast<std::size_t>(largest - legs.begin()), 1.0);
    }
    return found;
}

/// Steps of growth: no more than the history has room for, or a crack needs to become as long as it is to be, or to
/// meet the boundary straight on. Where it bends it may be elsewhere, mostly earlier.
double growths_of(const Scene& scene, const std::vector<TipResult>& tips, double increment) {
    if (!scene.input.growth) return 0.0;
    const GrowthSection& growth = *scene.input.growth;
    const double most = std::floor(cycle_count(scene.input.load) / growth.every);
    if (tips.empty()) return most;
    double way = 0.0;
    for (const Tip& tip : scene.enriched.tips) way = std::max(way, way_to_boundary(scene.mesh, tip));
    const double longest = std::ranges::max(tips, {}, &TipResult::a).a;
    if (growth.until) way = std::min(way, std::max(*growth.until - longest, 0.0));
    return std::min(most, std::ceil(way / increment));
}

/// Of so many cycles and the ramp.
double increments_of(const Case& input, const std::vector<Leg>& legs, double cycles) {
    const auto presses = [](const Leg& leg) { return leg.to < 0.0; };
    const bool compresses = some_touch(input.cracks) && std::ranges::any_of(legs, presses);
    const double first = input.load.first_steps();
    if (!input.load.steps.is_auto() || !compresses) return (cycles + 0.5) * first;
    const double at_first = std::min(cycles, until_measured);
    return 0.5 * first + at_first * compressed_at_first + (cycles - at_first) * compressed_then;
}

/// Points that flow take little then (docs/equations.md, exact return).
bool returns_exactly(const MaterialSection& material, PlaneState plane) {
    return plane == PlaneState::Strain && material.isotropic.law == HardeningLaw::Linear &&
           are_linear(material.kinematic);
}

/// In a mean iteration: what flows does not rest.
double share_that_moves(const WorkEstimate& work, double least) {
    return work.points == 0.0 ? 0.0 : std::max(least, work.yielding / work.points);
}

/// s; `unknowns`: of the zone.
double seconds_of_iteration(const WorkEstimate& work, double unknowns, bool exact) {
    if (work.points == 0.0) return 0.0;
    const double points = for_point * work.points + (exact ? for_exact_flow : for_flow) * work.yielding;
    return for_iteration + share_that_moves(work, evaluated) * points +
           share_that_moves(work, least_factored) * for_factor * unknowns;
}

/// Unknowns on the rim of the far body while nothing is a zone.
double rim_of_body(const Scene& scene) {
    const ElementSet far = far_elements(scene, ElementSet(scene.mesh->elements.size()));
    NodeSet of_far(scene.mesh->nodes.size()), of_both(scene.mesh->nodes.size());
    for (int e = 0; e < far.size(); ++e)
        for (const int node : scene.mesh->elements[at(e)])
            if (far.contains(e)) of_far.insert(node);
    for (int e = 0; e < far.size(); ++e)
        for (const int node : scene.mesh->elements[at(e)])
            if (!far.contains(e) && of_far.contains(node)) of_both.insert(node);
    return 2.0 * of_both.count();
}

}  // namespace

double seconds_of_body(const Scene& scene) {
    const double unit_loads = 2.0 + static_cast<double>(scene.loads.cases.size());
    return scene.enriched.unknowns * (for_unknown + for_unknown_of_load * unit_loads) +
           seconds_for_rim * std::pow(rim_of_body(scene), 3);
}

// A unit load has its forces and its displacement.
double bytes_of_body(const Scene& scene) {
    return bytes_of_element * static_cast<double>(scene.mesh->elements.size()) +
           16.0 * scene.enriched.unknowns * static_cast<double>(scene.loads.cases.size()) +
           bytes_for_rim * std::pow(rim_of_body(scene), 2) + bytes_of_cycle * cycle_count(scene.input.load);
}

WorkEstimate estimate_work(const Scene& scene, const NominalSolution& nominal, const std::vector<double>& K,
                           double increment) {
    const Case& input = scene.input;
    const double per_element = 4.0 * subcells_elsewhere(input.fine) * subcells_elsewhere(input.fine);
    const ElementSet yielding = yields(nominal);
    ElementSet zone = select_zone(scene, K);
    for (int e = 0; e < zone.size(); ++e)
        if (yielding.contains(e)) zone.insert(e);

    WorkEstimate work;
    work.points = per_element * zone.count();
    work.yielding = per_element * yielding.count();
    work.growths = growths_of(scene, nominal.tips, increment);
    double cycles = cycle_count(input.load);
    if (input.growth) cycles = std::min(cycles, (work.growths + 1.0) * input.growth->every);
    work.increments = increments_of(input, CaseHistories(input).legs(), cycles);
    const double unknowns = 2.0 * work.points / per_element;  // an element has a node
    const double iteration = seconds_of_iteration(work, unknowns, returns_exactly(input.material, input.model.plane));
    const double of_growth = zone.none() ? of_set_up : of_set_up_beside_zone;
    work.seconds = (2.0 + of_growth * work.growths) * seconds_of_body(scene) + work.increments * for_row +
                   work.growths * for_unknown * unknowns +
                   (work.increments * iterations + work.growths * of_release) * iteration;
    work.bytes = bytes_of_program + bytes_of_body(scene) + bytes_of_point * work.points;
    return work;
}

}  // namespace stria::coarse
