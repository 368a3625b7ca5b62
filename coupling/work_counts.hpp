// What was done, and what was skipped because something proved that it need not be done: the counters of summary.json.
#pragma once

#include <cstdint>

#include "common/members.hpp"

namespace stria::coupling {

/// Sums since the run was started or resumed; those "at present" are sizes. Each part of the program counts its own,
/// the rest stays zero, so that those of several parts add up. The wire, the sums and summary.json go by the list of
/// members below.
struct WorkCounts {
    // Points and elements of the zone.
    std::int64_t points_evaluated = 0;         // return mappings
    std::int64_t points_proven_elastic = 0;    // return mappings saved: no energy of the increment to flow with
    std::int64_t points_at_rest = 0;           // those of condensed parts that stay elastic: not a product was formed
    std::int64_t elements_woken = 0;           // of such parts, because they could flow or touch
    std::int64_t elements_built = 0;           // points placed, or functions evaluated at them, at the start or anew
    std::int64_t tangents_computed = 0;        // of elements
    std::int64_t elastic_tangents_reused = 0;  // elements that kept their elastic matrix
    std::int64_t history_values = 0;           // at present: stored numbers of all points beyond stresses

    // Faces.
    std::int64_t interface_elements = 0;  // at present: pieces of the faces that may touch, cut by sub-quadrangles
    std::int64_t gaps_evaluated = 0;      // weighted gaps of multipliers
    std::int64_t gaps_proven_open = 0;    // too wide to close by what the zone has moved since the last commit

    // Condensing the zone.
    std::int64_t fronts_refactored = 0;
    std::int64_t fronts_general = 0;  // of those refactored: something below makes unsymmetric tangents
    std::int64_t fronts_kept = 0;     // below which no tangent had changed
    std::int64_t factors_reused = 0;  // iterations that factored no front

    // The structure.
    std::int64_t gamma_factored = 0;                // the condensed tangent on Gamma
    std::int64_t gamma_factors_reused = 0;          // corrections that took the last factor
    std::int64_t structure_solves_full = 0;         // displacement of the whole structure
    std::int64_t structure_solves_near = 0;         // of the near elements alone
    std::int64_t structure_factorisations = 0;      // near elements, or the core of them, condensed onto Gamma
    std::int64_t structure_factors_kept = 0;        // new geometries that took the factor as it was
    std::int64_t far_factorisations = 0;            // far elements condensed onto their rim
    std::int64_t middle_factorisations = 0;         // likewise those between them and the core
    std::int64_t behind_factorisations = 0;         // likewise those behind the tips, for nominal solutions
    std::int64_t structure_elements_assembled = 0;  // in all of these, and for nominal solutions
    std::int64_t structure_checks_full = 0;         // far elements looked at one by one for yield
    std::int64_t structure_checks_by_bound = 0;

    // Between the components.
    std::int64_t fine_ranks = 0;     // started
    std::int64_t ranks_idle = 0;     // of them without an element
    std::int64_t history_moves = 0;  // growth steps before which history moved from rank to rank
    std::int64_t messages = 0;
    std::int64_t bytes = 0;
    std::int64_t tangents_not_sent = 0;  // answers without a tangent: it was that of the answer before
    std::int64_t bytes_not_sent = 0;     // by those
    std::int64_t states_not_sent = 0;    // commits that asked for no state of all points
};

STRIA_MEMBERS(WorkCounts, points_evaluated, points_proven_elastic, points_at_rest, elements_woken, elements_built,
              tangents_computed, elastic_tangents_reused, history_values, interface_elements, gaps_evaluated,
              gaps_proven_open, fronts_refactored, fronts_general, fronts_kept, factors_reused, gamma_factored,
              gamma_factors_reused, structure_solves_full, structure_solves_near, structure_factorisations,
              structure_factors_kept, far_factorisations, middle_factorisations, behind_factorisations,
              structure_elements_assembled, structure_checks_full, structure_checks_by_bound, fine_ranks, ranks_idle,
              history_moves, messages, bytes, tangents_not_sent, bytes_not_sent, states_not_sent)

inline WorkCounts& operator+=(WorkCounts& sum, const WorkCounts& more) { return add_members(sum, more); }

inline WorkCounts operator+(WorkCounts one, const WorkCounts& other) { return one += other; }

}  // namespace stria::coupling
