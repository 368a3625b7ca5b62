#include "coarse/advice/work_estimate.hpp"

#include <algorithm>
#include <cmath>

#include "coarse/elements/near_elements.hpp"
#include "coarse/enrichment/tip_reach.hpp"
#include "coarse/structure/proportion.hpp"
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
// A step of growth, and an element that is factored anew in it.
constexpr double for_growth = 8e-3, for_factored_element = 18e-6;
// An unknown near the tips in an increment: its displacement and rings, and beside a zone the guard. Nothing where all
// follows from the load factor 1 (proportion.hpp): what is left without a zone is a row.
constexpr double for_near_unknown = 0.5e-6, for_near_unknown_of_body = 0.2e-6, for_row_of_body = 0.04e-3;
constexpr double for_factor = 0.9e-6;    // an unknown of the zone in an iteration, of fronts below which points flow
constexpr double least_factored = 0.25;  // of them: faces move, and some flow is in many fronts
// Chosen increments of a cycle that presses faces together: until its half cycles are measured, and then: 49 to 81.
constexpr double compressed_at_first = 32.0, compressed_then = 60.0, until_measured = 4.0;
// Iterations of an increment: 3 to 4 in shipped cases, and of trials for the opening loads of each tip.
constexpr double iterations = 3.4, iterations_for_tip = 0.6;
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
struct Yielding {
    ElementSet ever, usually;  // at some end of a half cycle, or in the first of them alone
};

Yielding yields(const NominalSolution& nominal) {
    const Scene& scene = nominal.structure->scene();
    Yielding found{ElementSet(scene.mesh->elements.size()), ElementSet(scene.mesh->elements.size())};
    const double limit = scene.materials.weakest_yield_stress();
    if (!std::isfinite(limit)) return found;
    const CaseHistories histories(scene.input);
    const UnitResponse unit = unit_response(nominal);
    const double scale = target_of_unit(scene.input.load, unit.K_I, 0.0);
    const bool is_moved = scene.input.load.control == Control::Displacement;
    const std::vector<Leg>& legs = histories.legs();
    const auto look = [&](std::size_t leg, double way, ElementSet& yielding) {
        const int increment = std::max(1, static_cast<int>(way * scene.input.load.first_steps() / 2));
        const double value = value_on_way(scene.input, histories, unit.displacement, leg, way);
        const Eigen::VectorXd of_cases =
            histories.at({.leg = leg, .way = way, .increment = increment, .share = 1.0, .scale = scale});
        double factor = scale * value;
        if (is_moved) factor = legs[leg].leads ? 0.0 : unit.displacement.load_factor_at(value, of_cases);
        const Eigen::VectorXd u = nominal.structure->expand({}, {factor, of_cases}, 1.0);
        for (const int element : elements_beyond(limit, *nominal.structure, u)) yielding.insert(element);
    };
    for (std::size_t leg = 0; leg < std::min(legs.size(), most_legs); ++leg)
        for (const double way : {0.5, 1.0}) look(leg, way, found.usually);
    found.ever = found.usually;
    for (const double sign : {1.0, -1.0}) {
        const auto largest = std::ranges::max_element(legs, {}, [&](const Leg& leg) { return sign * leg.to; });
        if (largest != legs.end()) look(static_cast<std::size_t>(largest - legs.begin()), 1.0, found.ever);
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

/// What a step of growth factors: elements of the core, and of the others where they are chosen anew.
double elements_of_growth(const Scene& scene, const ElementSet& zone, double increment) {
    const StillElements still = still_elements(scene, zone);
    const double of_still = still.far.count() + still.middle.count(), core = zone.size() - zone.count() - of_still;
    return core + of_still * increment / std::max(room_ahead(scene, zone), increment);
}

/// s, of an increment beside its iterations.
double seconds_of_row(const Scene& scene, const ElementSet& zone) {
    if (zone.none() && has_one_load(scene)) return for_row_of_body;
    const double near_unknowns = 2.0 * (zone.size() - zone.count() - far_elements(scene, zone).count());
    return zone.none() ? for_row_of_body + for_near_unknown_of_body * near_unknowns
                       : for_row + for_near_unknown * near_unknowns;
}

/// K half way of the growth over K now, of the tip where it grows most: no more than twice, for a life ends soon there.
std::vector<double> K_half_way(const Scene& scene, const std::vector<double>& K, double way) {
    constexpr double most = 2.0;
    if (way <= 0.0 || !needs_fine(scene.input)) return K;
    std::vector<double> half_way = K_after(scene, 0.5 * way);
    if (half_way.size() != K.size()) return K;
    for (std::size_t t = 0; t < K.size(); ++t) half_way[t] = std::min(half_way[t], most * K[t]);
    return half_way;
}

/// What flows about a tip grows with the square of its radius, and elements with their distance.
double flow_half_way(const std::vector<double>& K, const std::vector<double>& half_way) {
    double more = 1.0;
    for (std::size_t t = 0; t < K.size(); ++t)
        if (K[t] > 0.0) more = std::max(more, std::pow(half_way[t] / K[t], 2));
    return more;
}

double tips_that_touch(const Scene& scene) {
    return static_cast<double>(std::ranges::count_if(
        scene.enriched.tips, [&](const Tip& tip) { return may_touch(scene.input.cracks[at(tip.crack)]); }));
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
    const auto [yielding, usually] = yields(nominal);
    ElementSet zone = select_zone(scene, K);
    zone |= yielding;

    WorkEstimate work;
    const ZoneSize now = size_of_zone(scene, zone);
    work.points = now.points;
    const double per_element = 4.0 * std::pow(subcells_elsewhere(input.fine), 2);
    work.yielding = per_element * yielding.count();
    work.growths = growths_of(scene, nominal.tips, increment);
    double cycles = cycle_count(input.load);
    if (input.growth) cycles = std::min(cycles, (work.growths + 1.0) * input.growth->every);
    work.increments = increments_of(input, CaseHistories(input).legs(), cycles);
    const double way = work.growths * increment;
    const std::vector<double> half_way = K_half_way(scene, K, way);
    work.at_end = zone.none() ? now : size_after(scene, zone, K, half_way, way);

    WorkEstimate mean = work;
    mean.points = 0.5 * (now.points + work.at_end.points);
    mean.yielding = std::min(mean.points, per_element * usually.count() * flow_half_way(K, half_way));
    const double unknowns = now.elements + work.at_end.elements;  // an element has a node
    const double iteration = seconds_of_iteration(mean, unknowns, returns_exactly(input.material, input.model.plane));
    const double of_increment = iterations + iterations_for_tip * tips_that_touch(scene);
    work.seconds =
        2.0 * seconds_of_body(scene) + work.increments * (seconds_of_row(scene, zone) + of_increment * iteration);
    if (work.growths > 0.0)
        work.seconds += work.growths * (for_growth + for_factored_element * elements_of_growth(scene, zone, increment) +
                                        for_unknown * unknowns + of_release * iteration);
    const bool has_two_factors =
        way > std::max(room_ahead(scene, zone), increment) || (way > 0.0 && far_elements(scene, zone).none());
    work.bytes = bytes_of_program + bytes_of_body(scene) + (has_two_factors ? bytes_of_factor * work.at_end.all : 0.0) +
                 bytes_of_element * (work.at_end.all - now.all) + bytes_of_zone_element * work.at_end.elements +
                 bytes_of_point * work.at_end.points;
    return work;
}

}  // namespace stria::coarse
