// What was done, and what was skipped because something proved that it need not be done: the counters of summary.json.
#pragma once

#include <array>
#include <cstdint>

namespace stria::coupling {

/// Sums since the run was started or resumed; those "at present" are sizes. Each part of the program counts its own,
/// the rest stays zero, so that those of several parts add up. A new counter is a line here and one in
/// `named_work_counts`: the wire, the sums and summary.json go by that list.
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

struct NamedWorkCount {
    const char* name;
    std::int64_t WorkCounts::*value;
};

inline constexpr std::array named_work_counts{
    NamedWorkCount{"points_evaluated", &WorkCounts::points_evaluated},
    NamedWorkCount{"points_proven_elastic", &WorkCounts::points_proven_elastic},
    NamedWorkCount{"points_at_rest", &WorkCounts::points_at_rest},
    NamedWorkCount{"elements_woken", &WorkCounts::elements_woken},
    NamedWorkCount{"elements_built", &WorkCounts::elements_built},
    NamedWorkCount{"tangents_computed", &WorkCounts::tangents_computed},
    NamedWorkCount{"elastic_tangents_reused", &WorkCounts::elastic_tangents_reused},
    NamedWorkCount{"history_values", &WorkCounts::history_values},
    NamedWorkCount{"interface_elements", &WorkCounts::interface_elements},
    NamedWorkCount{"gaps_evaluated", &WorkCounts::gaps_evaluated},
    NamedWorkCount{"gaps_proven_open", &WorkCounts::gaps_proven_open},
    NamedWorkCount{"fronts_refactored", &WorkCounts::fronts_refactored},
    NamedWorkCount{"fronts_general", &WorkCounts::fronts_general},
    NamedWorkCount{"fronts_kept", &WorkCounts::fronts_kept},
    NamedWorkCount{"factors_reused", &WorkCounts::factors_reused},
    NamedWorkCount{"gamma_factored", &WorkCounts::gamma_factored},
    NamedWorkCount{"gamma_factors_reused", &WorkCounts::gamma_factors_reused},
    NamedWorkCount{"structure_solves_full", &WorkCounts::structure_solves_full},
    NamedWorkCount{"structure_solves_near", &WorkCounts::structure_solves_near},
    NamedWorkCount{"structure_factorisations", &WorkCounts::structure_factorisations},
    NamedWorkCount{"structure_factors_kept", &WorkCounts::structure_factors_kept},
    NamedWorkCount{"far_factorisations", &WorkCounts::far_factorisations},
    NamedWorkCount{"middle_factorisations", &WorkCounts::middle_factorisations},
    NamedWorkCount{"behind_factorisations", &WorkCounts::behind_factorisations},
    NamedWorkCount{"structure_elements_assembled", &WorkCounts::structure_elements_assembled},
    NamedWorkCount{"structure_checks_full", &WorkCounts::structure_checks_full},
    NamedWorkCount{"structure_checks_by_bound", &WorkCounts::structure_checks_by_bound},
    NamedWorkCount{"fine_ranks", &WorkCounts::fine_ranks},
    NamedWorkCount{"ranks_idle", &WorkCounts::ranks_idle},
    NamedWorkCount{"history_moves", &WorkCounts::history_moves},
    NamedWorkCount{"messages", &WorkCounts::messages},
    NamedWorkCount{"bytes", &WorkCounts::bytes},
    NamedWorkCount{"tangents_not_sent", &WorkCounts::tangents_not_sent},
    NamedWorkCount{"bytes_not_sent", &WorkCounts::bytes_not_sent},
    NamedWorkCount{"states_not_sent", &WorkCounts::states_not_sent},
};
static_assert(sizeof(WorkCounts) == named_work_counts.size() * sizeof(std::int64_t), "a counter has no name");

inline WorkCounts& operator+=(WorkCounts& sum, const WorkCounts& more) {
    for (const NamedWorkCount& count : named_work_counts) sum.*count.value += more.*count.value;
    return sum;
}

inline WorkCounts operator+(WorkCounts one, const WorkCounts& other) { return one += other; }

}  // namespace stria::coupling
