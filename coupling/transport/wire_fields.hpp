// The fields of every message in the order in which they cross. Sender and receiver walk through the same list, so
// their orders cannot differ, and the structured bindings do not compile where a field is missing.
#pragma once

#include <type_traits>

#include "coupling/transport/protocol.hpp"

namespace stria::coupling {

template <class M, class T>
concept Is = std::is_same_v<std::remove_const_t<M>, T>;

void fields(auto& wire, Is<Hello> auto& m) {
    auto& [protocol, case_digest] = m;
    wire(protocol, case_digest);
}

void fields(auto& wire, Is<Failure> auto& m) {
    auto& [kind, text] = m;
    wire(kind, text);
}

void fields(auto& wire, Is<Commit> auto& m) {
    auto& [reversal, bends, next, brief, no_faces, releases] = m;
    wire(reversal, bends, next, brief, no_faces, releases);
}

void fields(auto& wire, Is<Ring> auto& m) {
    auto& [tip, number, inner_radius, outer_radius, element] = m;
    wire(tip, number, inner_radius, outer_radius, element);
}

void fields(auto& wire, Is<Term> auto& m) {
    auto& [kind, owner, function, shift] = m;
    wire(kind, owner, function, shift);
}

void fields(auto& wire, Is<CrackPiece> auto& m) {
    auto& [crack, element, neighbour, points, s, entry, exit] = m;
    wire(crack, element, neighbour, points, s, entry, exit);
}

void fields(auto& wire, Is<Tip> auto& m) {
    auto& [crack, position, direction, s, upper, beyond, material] = m;
    wire(crack, position, direction, s, upper, beyond, material);
}

void fields(auto& wire, Is<TiedNode> auto& m) {
    auto& [node, ends, side, jump_tied] = m;
    wire(node, ends, side, jump_tied);
}

void fields(auto& wire, Is<EnrichedMesh> auto& m) {
    auto& [nodes, elements, node_ids, element_ids, material, pieces, tips, left_tips, mouths, grown_at_start,
           tip_exponent, tip_functions, terms, element_side, branch, tied, first_unknown, first_gathered, unknowns] = m;
    wire(nodes, elements, node_ids, element_ids, material, pieces, tips, left_tips, mouths, grown_at_start,
         tip_exponent, tip_functions, terms, element_side, branch, tied, first_unknown, first_gathered, unknowns);
}

void fields(auto& wire, Is<TipMoves> auto& m) {
    auto& [tips, moves] = m;
    wire(tips, moves);
}

void fields(auto& wire, Is<MovedIncrements> auto& m) {
    auto& [moves, displacement] = m;
    wire(moves, displacement);
}

void fields(auto& wire, Is<Patch> auto& m) {
    auto& [mesh, boundary, unit_load, case_loads, displacement, rings, opening_at, contact_at, ahead, slip_at, anew,
           shared, moved, part_of] = m;
    wire(mesh, boundary, unit_load, case_loads, displacement, rings, opening_at, contact_at, ahead, slip_at, anew,
         shared, moved, part_of);
}

void fields(auto& wire, Is<PatchDisplacement> auto& m) {
    auto& [wanted, iteration, predictor, put_aside, load_factor, cases, further, step, held, settled_below,
           keeps_factor, last_below, check_rest, elastic, opens_faces, boundary] = m;
    wire(wanted, iteration, predictor.factor, predictor.back, predictor.goes_on, predictor.apart, put_aside,
         load_factor, cases, further, step, held, settled_below, keeps_factor, last_below, check_rest, elastic,
         opens_faces, boundary);
}

void fields(auto& wire, Is<NearestContact> auto& m) {
    auto& [behind, pressure, excess, closed, sliding] = m;
    wire(behind, pressure, excess, closed, sliding);
}

void fields(auto& wire, Is<Digest> auto& m) {
    auto& [yielding_points, largest_plastic_increment, status, multiplier, status_changes, contact, opening,
           force_ahead, nearest] = m;
    wire(yielding_points, largest_plastic_increment, status, multiplier, status_changes, contact, opening, force_ahead,
         nearest);
}

// Half of a symmetric tangent stands for the whole.
void fields(auto& wire, Is<CondensedTangent> auto& m) {
    auto& [matrix, symmetry] = m;
    wire(symmetry);
    if (symmetry == Symmetry::Symmetric)
        wire.lower_half(matrix);
    else
        wire(matrix);
}

void fields(auto& wire, Is<PatchResponse> auto& m) {
    auto& [force, tangent, same_tangent, may_keep_factor, keeps_factor, due, unit_load, interior_residual,
           interior_force, contact_residual, interior_correction, interior_displacement, along, along_before,
           provisional, woken, opens_faces, digest] = m;
    wire(force, tangent, same_tangent, may_keep_factor, keeps_factor, due, unit_load, interior_residual, interior_force,
         contact_residual, interior_correction, interior_displacement, along, along_before, provisional, woken,
         opens_faces, digest);
}

void fields(auto& wire, Is<FaceSample> auto& m) {
    auto& [crack, s, x, y, opening, slip, pressure, shear, status, in_wake] = m;
    wire(crack, s, x, y, opening, slip, pressure, shear, status, in_wake);
}

void fields(auto& wire, Is<DomainIntegral> auto& m) {
    auto& [J, interaction_I, interaction_II, interaction_T, area, rotation, turned_I, turned_II, turned_T, wake_I,
           wake_II] = m;
    wire(J, interaction_I, interaction_II, interaction_T, area, rotation, turned_I, turned_II, turned_T, wake_I,
         wake_II);
}

void fields(auto& wire, Is<RingReport> auto& m) {
    auto& [tip, number, sums] = m;
    wire(tip, number, sums);
}

void fields(auto& wire, Is<FlowShell> auto& m) {
    auto& [begin, end, reach, axis] = m;
    wire(begin, end, reach, axis);
}

void fields(auto& wire, Is<TipReport> auto& m) {
    auto& [CTOD, opening, flow, flow_ever] = m;
    wire(CTOD, opening, flow, flow_ever);
}

void fields(auto& wire, Is<EnergyReport> auto& m) {
    auto& [stored, released, friction, contact, load_path, case_paths] = m;
    wire(stored, released, friction, contact, load_path, case_paths);
}

void fields(auto& wire, Is<WorkCounts> auto& m) {
    for (const NamedWorkCount& count : named_work_counts) wire(m.*count.value);
}

void fields(auto& wire, Is<StepReport> auto& m) {
    auto& [tips, rings, faces, contact_length, mouth_opening, dissipation, energy, points, unknowns, multipliers, work,
           constitutive_s, contact_s, factor_s] = m;
    wire(tips, rings, faces, contact_length, mouth_opening, dissipation, energy, points, unknowns, multipliers, work,
         constitutive_s, contact_s, factor_s);
}

void fields(auto& wire, Is<FrozenTip> auto& m) {
    auto& [mesh, displacement, crack] = m;
    wire(mesh, displacement, crack);
}

void fields(auto& wire, Is<MultiplierSnapshot> auto& m) {
    auto& [crack, place, pressure, shear, status, widened, slid, until_met, changes, resting, rest_pressure, rest_shear,
           increments, shear_increments] = m;
    wire(crack, place, pressure, shear, status, widened, slid, until_met, changes, resting, rest_pressure, rest_shear,
         increments, shear_increments);
}

void fields(auto& wire, Is<ZoneSnapshot> auto& m) {
    auto& [ranks, element, rank, points, recent_flow, unknowns, resting, flow, stand, weighed_cost, columns, history,
           half_cycle_ended, displacement, rest_displacement, increments, held, multipliers, frozen_tips] = m;
    wire(ranks, element, rank, points, recent_flow, unknowns, resting, flow, stand, weighed_cost, columns, history,
         half_cycle_ended, displacement, rest_displacement, increments, held, multipliers, frozen_tips);
}

void fields(auto& wire, Is<Restore> auto& m) {
    auto& [patch, snapshot] = m;
    wire(patch, snapshot);
}

void fields(auto& wire, Is<ZoneState> auto& m) {
    auto& [displacement, element, side, x, y, weight, stress, plastic_strain, accumulated, frozen_tips] = m;
    wire(displacement, element, side, x, y, weight, stress, plastic_strain, accumulated, frozen_tips);
}

}  // namespace stria::coupling
