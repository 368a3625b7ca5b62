// The members of every message in the order in which they cross (common/members.hpp). Sender and receiver walk through
// the same list, so their orders cannot differ.
#pragma once

#include "common/members.hpp"
#include "coupling/transport/protocol.hpp"

namespace stria::coupling {

STRIA_MEMBERS(Hello, protocol, case_digest)
STRIA_MEMBERS(Failure, kind, text)
STRIA_MEMBERS(Commit, reversal, bends, next_over_this, brief, no_faces, releases)
STRIA_MEMBERS(Ring, tip, number, inner_radius, outer_radius, element)
STRIA_MEMBERS(Term, kind, owner, function, shift)
STRIA_MEMBERS(CrackPiece, crack, element, neighbour, points, s, entry, exit)
STRIA_MEMBERS(Tip, crack, position, direction, s, upper, beyond, material)
STRIA_MEMBERS(TiedNode, node, ends, side, jump_tied)
STRIA_MEMBERS(EnrichedMesh, nodes, elements, node_ids, element_ids, material, pieces, tips, left_tips, mouths,
              grown_at_start, tip_exponent, tip_functions, terms, element_side, branch, tied, first_unknown,
              first_gathered, unknowns)
STRIA_MEMBERS(TipMoves, tips, moves)
STRIA_MEMBERS(MovedIncrements, moves, displacement)
STRIA_MEMBERS(Patch, mesh, boundary, unit_load, case_loads, displacement, rings, opening_at, contact_at, ahead, slip_at,
              anew, shared, moved, part_of)
STRIA_MEMBERS(Predictor, factor, back, goes_on, apart)
STRIA_MEMBERS(PatchDisplacement, wanted, iteration, predictor, put_aside, load_factor, cases, further, step, held,
              settled_below, keeps_factor, last_below, check_rest, elastic, opens_faces, boundary)
STRIA_MEMBERS(NearestContact, behind, pressure, excess, closed, sliding)
STRIA_MEMBERS(Digest, yielding_points, largest_plastic_increment, status, multiplier, status_changes, contact, opening,
              force_ahead, nearest)

// Half of a symmetric tangent stands for the whole.
void members(auto& wire, Is<CondensedTangent> auto& tangent) {
    auto& [matrix, symmetry] = tangent;
    wire("symmetry", symmetry);
    if (symmetry == Symmetry::Symmetric)
        wire.lower_half(matrix);
    else
        wire("matrix", matrix);
}

STRIA_MEMBERS(PatchResponse, force, tangent, same_tangent, may_keep_factor, keeps_factor, due, unit_load,
              interior_residual, interior_force, contact_residual, interior_correction, interior_displacement, along,
              along_before, provisional, woken, opens_faces, digest)
STRIA_MEMBERS(FaceSample, crack, s, x, y, opening, slip, pressure, shear, status, in_wake)
STRIA_MEMBERS(RingReport, tip, number, sums)
STRIA_MEMBERS(FlowShell, begin, end, reach, axis)
STRIA_MEMBERS(TipReport, CTOD, opening, flow, flow_ever)
STRIA_MEMBERS(EnergyReport, stored, released, friction, contact, load_path, case_paths)
STRIA_MEMBERS(StepReport, tips, rings, faces, contact_length, mouth_opening, dissipation, energy, points, unknowns,
              multipliers, work, constitutive_s, contact_s, factor_s)
STRIA_MEMBERS(FrozenTip, mesh, displacement, crack)
STRIA_MEMBERS(MultiplierSnapshot, crack, place, pressure, shear, status, widened, slid, until_met, settled_slip,
              changes, resting, rest_pressure, rest_shear, increments, shear_increments)
STRIA_MEMBERS(ZoneSnapshot, ranks, element, rank, points, recent_flow, unknowns, resting, flow, stand, weighed_cost,
              columns, history, half_cycle_ended, displacement, rest_displacement, increments, held, multipliers,
              frozen_tips)
STRIA_MEMBERS(Restore, patch, snapshot)
STRIA_MEMBERS(ZoneState, displacement, element, side, x, y, weight, stress, plastic_strain, accumulated, frozen_tips)

}  // namespace stria::coupling
