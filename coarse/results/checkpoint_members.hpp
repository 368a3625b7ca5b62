// What a checkpoint holds, member by member (common/io/archive.hpp). The structured bindings do not compile where one
// is missing.
#pragma once

#include "coarse/analysis/analysis_state.hpp"
#include "coarse/results/case_mark.hpp"
#include "coarse/results/growth_members.hpp"
#include "coarse/results/load_members.hpp"
#include "coarse/results/run_recorder.hpp"
#include "coupling/transport/zone_snapshot_members.hpp"

namespace stria::coarse {

void members(auto& archive, Is<FieldWriter::Step> auto& m) {
    auto& [increment, time] = m;
    archive("increment", increment);
    archive("time", time);
}

void members(auto& archive, Is<RecorderState> auto& m) {
    auto& [history_rows, cycle_rows, face_rows, closure_rows, load_rows, fields, cycle_iterations, cycle_s, N] = m;
    archive("history_rows", history_rows);
    archive("cycle_rows", cycle_rows);
    archive("face_rows", face_rows);
    archive("closure_rows", closure_rows);
    archive("load_rows", load_rows);
    archive("fields", fields);
    archive("cycle_iterations", cycle_iterations);
    archive("cycle_s", cycle_s);
    archive("N", N);
}

void members(auto& archive, Is<OpeningLoads> auto& m) {
    auto& [K_op, K_cl, lost] = m;
    archive("K_op", K_op);
    archive("K_cl", K_cl);
    archive("lost", lost);
}

void members(auto& archive, Is<Extremes> auto& m) {
    auto& [most, least] = m;
    archive("most", most);
    archive("least", least);
}

void members(auto& archive, Is<CycleResult> auto& m) {
    auto& [a, da, K_max, K_min, J_max, CTOD, opening_behind, forward, cyclic, forward_axis, cyclic_axis, contact,
           tension, offset, K_slip, K_slip_unloading, opening, dN, K_initial] = m;
    archive("a", a);
    archive("da", da);
    archive("K_max", K_max);
    archive("K_min", K_min);
    archive("J_max", J_max);
    archive("CTOD", CTOD);
    archive("opening_behind", opening_behind);
    archive("forward", forward);
    archive("cyclic", cyclic);
    archive("forward_axis", forward_axis);
    archive("cyclic_axis", cyclic_axis);
    archive("contact", contact);
    archive("tension", tension);
    archive("offset", offset);
    archive("K_slip", K_slip);
    archive("K_slip_unloading", K_slip_unloading);
    archive("opening", opening);
    archive("dN", dN);
    archive("K_initial", K_initial);
}

void members(auto& archive, Is<TipResult> auto& m) {
    auto& [a, x, y, way, K_I, K_II, K_I_of_wake, K_II_of_wake, T_stress, J, J_spread, K_spread, rings_flow, CTOD, CMOD,
           opening, contact_length, plastic_zone, plastic_zone_axis, K_initial, K_II_initial, K_I_of_cases,
           K_II_of_cases] = m;
    archive("a", a);
    archive("x", x);
    archive("y", y);
    archive("way", way);
    archive("K_I", K_I);
    archive("K_II", K_II);
    archive("K_I_of_wake", K_I_of_wake);
    archive("K_II_of_wake", K_II_of_wake);
    archive("T_stress", T_stress);
    archive("J", J);
    archive("J_spread", J_spread);
    archive("K_spread", K_spread);
    archive("rings_flow", rings_flow);
    archive("CTOD", CTOD);
    archive("opening", opening);
    archive("CMOD", CMOD);
    archive("contact_length", contact_length);
    archive("plastic_zone", plastic_zone);
    archive("plastic_zone_axis", plastic_zone_axis);
    archive("K_initial", K_initial);
    archive("K_II_initial", K_II_initial);
    archive("K_I_of_cases", K_I_of_cases);
    archive("K_II_of_cases", K_II_of_cases);
}

void members(auto& archive, Is<SignalOfCycle> auto& m) {
    auto& [found, rising, rest, changed, was_open] = m;
    archive("found", found);
    archive("rising", rising);
    archive("rest", rest);
    archive("changed", changed);
    archive("was_open", was_open);
}

void members(auto& archive, Is<CycleMemory::Path> auto& m) {
    auto& [load, mouth] = m;
    archive("load", load);
    archive("mouth", mouth);
}

void members(auto& archive, Is<CycleMemory::Tip> auto& m) {
    auto& [cycle, has_fallen, rest, signal, down, up] = m;
    archive("cycle", cycle);
    archive("has_fallen", has_fallen);
    archive("rest", rest);
    archive("signal", signal);
    archive("down", down);
    archive("up", up);
}

void members(auto& archive, Is<CycleMemory::Station> auto& m) {
    auto& [x, y, way, unit_K, K, K_due, CTOD, opening, CMOD, load_factor, zone, zone_axis, rose] = m;
    archive("x", x);
    archive("y", y);
    archive("way", way);
    archive("unit_K", unit_K);
    archive("K", K);
    archive("K_due", K_due);
    archive("CTOD", CTOD);
    archive("opening", opening);
    archive("CMOD", CMOD);
    archive("load_factor", load_factor);
    archive("zone", zone);
    archive("zone_axis", zone_axis);
    archive("rose", rose);
}

void members(auto& archive, Is<CycleMemory> auto& m) {
    auto& [cycle, last_target, tips, last, x, y, way, rises_on] = m;
    archive("cycle", cycle);
    archive("last_target", last_target);
    archive("tips", tips);
    archive("last", last);
    archive("x", x);
    archive("y", y);
    archive("way", way);
    archive("rises_on", rises_on);
}

void members(auto& archive, Is<EquilibriumState> auto& m) {
    auto& [load_factor, cases, displacement, increments, load_increments, whole, whole_increments] = m;
    archive("load_factor", load_factor);
    archive("cases", cases);
    archive("displacement", displacement);
    archive("increments", increments);
    archive("load_increments", load_increments);
    archive("whole", whole);
    archive("whole_increments", whole_increments);
}

void members(auto& archive, Is<AnalysisState::Polyline> auto& m) {
    auto& [x, y, grown_at_start] = m;
    archive("x", x);
    archive("y", y);
    archive("grown_at_start", grown_at_start);
}

void members(auto& archive, Is<WorkBalance> auto& m) {
    auto& [external, largest, by_cases, stored, dissipated, by_friction, released, at_start, load_factor,
           load_displacement, imposed_force, cases, case_displacements, case_forces] = m;
    archive("external", external);
    archive("largest", largest);
    archive("by_cases", by_cases);
    archive("stored", stored);
    archive("dissipated", dissipated);
    archive("by_friction", by_friction);
    archive("released", released);
    archive("at_start", at_start);
    archive("load_factor", load_factor);
    archive("load_displacement", load_displacement);
    archive("imposed_force", imposed_force);
    archive("cases", cases);
    archive("case_displacements", case_displacements);
    archive("case_forces", case_forces);
}

void members(auto& archive, Is<ClosureMemory::Crossings> auto& m) {
    auto& [loads, rates] = m;
    archive("loads", loads);
    archive("rates", rates);
}

void members(auto& archive, Is<ClosureMemory> auto& m) {
    auto& [signal, nearest, largest, opened, closed] = m;
    archive("signal", signal);
    as_bytes(archive, "nearest", nearest);
    archive("largest", largest);
    archive("opened", opened);
    archive("closed", closed);
}

void members(auto& archive, Is<UnitDisplacement> auto& m) {
    auto& [mean, largest, of_cases, initial] = m;
    archive("mean", mean);
    archive("largest", largest);
    archive("of_cases", of_cases);
    archive("initial", initial);
}

void members(auto& archive, Is<StillElements> auto& m) {
    auto& [far, middle, behind] = m;
    archive("far", far);
    archive("middle", middle);
    archive("behind", behind);
}

void members(auto& archive, Is<AnalysisState> auto& m) {
    auto& [cracks, splits, settled, in_zone, still, still_of_nominal, displacement, load_factor, largest_force, closure,
           cycle, last_cycle, nominal, unit_displacement, counts, growth, said_of_mesh, due_growth, release, load, work,
           equilibrium, zone] = m;
    auto& [increments, newton_iterations, zone_extensions, yield_warnings, release_cuts, flowing_rings,
           overlapping_faces, mesh_splits] = counts;
    archive("cracks", cracks);
    archive("splits", splits);
    archive("settled", settled);
    archive("in_zone", in_zone);
    archive("still", still);
    archive("still_of_nominal", still_of_nominal);
    archive("displacement", displacement);
    archive("load_factor", load_factor);
    archive("largest_force", largest_force);
    archive("closure", closure);
    archive("cycle", cycle);
    archive("last_cycle", last_cycle);
    archive("nominal", nominal);
    archive("unit_displacement", unit_displacement);
    archive("increment", increments);
    archive("newton_iterations", newton_iterations);
    archive("extensions", zone_extensions);
    archive("warnings", yield_warnings);
    archive("release_cuts", release_cuts);
    archive("flowing_rings", flowing_rings);
    archive("overlapping_faces", overlapping_faces);
    archive("mesh_splits", mesh_splits);
    archive("growth", growth);
    archive("said_of_mesh", said_of_mesh);
    archive("due_growth", due_growth);
    archive("release", release);
    archive("load", load);
    archive("work", work);
    archive("equilibrium", equilibrium);
    archive("zone", zone);
}

void members(auto& archive, Is<CaseMark> auto& m) {
    auto& [text, blocks, scale, repeat, legs_before, mesh] = m;
    archive("text", text);
    archive("blocks", blocks);
    archive("scale", scale);
    archive("repeat", repeat);
    archive("legs_before", legs_before);
    archive("mesh", mesh);
}

}  // namespace stria::coarse
