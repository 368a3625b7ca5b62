// The members of all that a checkpoint holds (common/members.hpp).
#pragma once

#include "coarse/analysis/analysis_state.hpp"
#include "coarse/results/case_mark.hpp"
#include "coarse/results/run_recorder.hpp"
#include "coupling/transport/zone_snapshot_members.hpp"

namespace stria {

STRIA_MEMBERS(LoadBlock, cycles, max, min)

}  // namespace stria

namespace stria::coarse {

// The load, and how far it has come.
STRIA_MEMBERS(LoadFactors, main, cases)
STRIA_MEMBERS(TakenIncrement, cycle, from, to, cases_from, cases_to)
STRIA_MEMBERS(OpeningPath, way, opening)
STRIA_MEMBERS(IncrementSchedule::Legs, increments, alike, unmeasured, taken, knows_pressing)
STRIA_MEMBERS(TwoAsOne, from, to, opening)
STRIA_MEMBERS(SensesOfK, with_load, against_load)
STRIA_MEMBERS(IncrementSchedule::State, rising, falling, path, pairs, meetings, presses, senses, tells, missed)
STRIA_MEMBERS(LoadPosition, leg, increments, leg_start, reached, way, cases, fraction, consecutive_cuts, cuts, taken,
              misled, schedule)

// The growth of the cracks.
STRIA_MEMBERS(PeriodMemory, sum, cycles, grown, before, at_growth)
STRIA_MEMBERS(RateAtLength, length, rate)
STRIA_MEMBERS(CountedGrowth, grown, from, to, doubt)
STRIA_MEMBERS(LifeMemory, uncounted, rate_at_turn, doubt, last)
STRIA_MEMBERS(TipRatesMemory, period, life, at_turn, owed, last)
STRIA_MEMBERS(GrowthPoint, a, per_mm, closure)
STRIA_MEMBERS(ForwardZone, ahead, anywhere)
STRIA_MEMBERS(GrowthIncrementMemory, increment, points, zones)
STRIA_MEMBERS(FaceTractions, crack, s, pressure, shear, in_wake)
STRIA_MEMBERS(ReachedExtremes, maximum, minimum, tips, tips_at_minimum, faces, faces_at_minimum)
STRIA_MEMBERS(LengthAndK, a, K)
STRIA_MEMBERS(ReachedK, of_break, K_I)
STRIA_MEMBERS(ModesOfTip, K_I, K_II)
STRIA_MEMBERS(TurningModes, minimum, cycles)
STRIA_MEMBERS(OpeningSwingMemory::Tip, cycles, ratios, said)
STRIA_MEMBERS(OpeningSwingMemory, level, tips)
STRIA_MEMBERS(GrowthMemory, ended, increment, rates, K_reached, before, extremes, turning, turns_late, swing)
STRIA_MEMBERS(DueGrowth, due, cycle, moment)
STRIA_MEMBERS(FaceRelease, cycle, moment, held, part, cuts)

// The rest of an analysis, and what belongs to it on the disk.
STRIA_MEMBERS(FieldWriter::Step, increment, time)
STRIA_MEMBERS(RecorderState, history_rows, cycle_rows, face_rows, closure_rows, load_rows, fields, cycle_iterations,
              cycle_s, N)
STRIA_MEMBERS(OpeningLoads, K_op, K_cl, lost)
STRIA_MEMBERS(Extremes, most, least)
STRIA_MEMBERS(CycleResult, a, da, K_max, K_min, J_max, CTOD, opening_behind, forward, cyclic, forward_axis, cyclic_axis,
              contact, tension, offset, K_slip, K_slip_unloading, opening, dN, K_initial)
STRIA_MEMBERS(TipResult, a, x, y, way, K_I, K_II, K_I_of_wake, K_II_of_wake, T_stress, J, J_spread, K_spread,
              rings_flow, CTOD, CMOD, opening, contact_length, plastic_zone, plastic_zone_axis, K_initial, K_II_initial,
              K_I_of_cases, K_II_of_cases)
STRIA_MEMBERS(SignalOfCycle, found, rising, rest, changed, was_open)
STRIA_MEMBERS(MouthPath, load_factor, force, opening)
STRIA_MEMBERS(CycleMemory::Tip, cycle, has_fallen, rest, signal, down, up)
STRIA_MEMBERS(CycleMemory::Station, x, y, way, unit_K, K, K_due, CTOD, opening, CMOD, load_factor, force, zone,
              zone_axis, rose)
STRIA_MEMBERS(CycleMemory, cycle, last_target, tips, last, x, y, way, rises_on)
STRIA_MEMBERS(EquilibriumState, load_factor, cases, displacement, increments, load_increments, whole, whole_increments)
STRIA_MEMBERS(AnalysisState::Polyline, x, y, grown_at_start)
STRIA_MEMBERS(WorkBalance, external, largest, by_cases, stored, dissipated, by_friction, released, at_start,
              load_factor, load_displacement, imposed_force, cases, case_displacements, case_forces)
STRIA_MEMBERS(ClosureMemory::Crossings, loads, rates)
STRIA_MEMBERS(ClosureMemory, signal, nearest, largest, opened, closed)
STRIA_MEMBERS(UnitDisplacement, mean, largest, of_cases, initial)
STRIA_MEMBERS(StillElements, far, middle, behind)
STRIA_MEMBERS(AnalysisState, cracks, splits, settled, in_zone, still, still_of_nominal, displacement, load_factor,
              largest_force, closure, cycle, last_cycle, nominal, unit_displacement, counts, growth, said_of_mesh,
              due_growth, release, load, work, equilibrium, zone)
STRIA_MEMBERS(CaseMark, text, blocks, scale, repeat, legs_before, mesh)

}  // namespace stria::coarse
