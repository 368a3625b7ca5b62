// The shipped edge-cracked plate on coarser meshes, run in process; what a run leaves as values.
#pragma once

#include <algorithm>
#include <bit>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "coarse/analysis/fatigue_analysis.hpp"
#include "coarse/equilibrium/condensed/condensed_factory.hpp"
#include "coarse/specimen/specimen.hpp"
#include "coarse/zone/refined_scene.hpp"
#include "common/case/schema/case_file.hpp"
#include "common/linear/blas.hpp"
#include "fine/zone/fine_model.hpp"
#include "tests/support/folders.hpp"
#include "tests/support/refined_squares.hpp"

namespace stria::test {

inline const std::string shipped_sent = std::string(source_folder) + "/cases/sent-compression/case.toml";

/// Elements of `size` at the tip, growing from there on; a run takes about a second with 0.4 mm.
inline std::string mesh_at_tip(double size) {
    const std::string h = std::to_string(size), outer = std::to_string(2.0 * size);
    return "mesh.grading=[{at=[[20.0,100.0]],size=" + h + ",outer_size=" + outer + ",radius=3.0,growth=0.25}]";
}

inline Case sent_case(std::vector<std::string> overrides) { return read_case(shipped_sent, std::move(overrides)); }

/// An increment with its displacement of the whole mesh, zero inside the zone.
struct Followed : coarse::Increment {
    Eigen::VectorXd displacement;
};

struct RunHistory {
    std::vector<Followed> increments;
    std::vector<std::pair<coarse::LoadStep, coarse::NewtonReport>> attempts;
    std::vector<coarse::TipResult> nominal;  // elastic, for the load factor 1
    std::vector<std::string> notes;          // lines for the log
    int cuts = 0, extensions = 0, yield_warnings = 0, mesh_splits = 0;
    std::int64_t full_checks = 0, checks_by_bound = 0;
    bool life_is_over = false;

    [[nodiscard]] const Followed& at_load(double factor) const& {  // for the first time
        for (const Followed& increment : increments) {
            if (increment.load_factor == factor) return increment;
        }
        throw std::out_of_range("no increment at this load");
    }
    /// The first of them at the largest load.
    [[nodiscard]] const Followed& at_maximum() const& {
        return *std::ranges::max_element(increments, {}, &Followed::load_factor);
    }
    [[nodiscard]] const Followed& at_minimum() const& {
        return *std::ranges::min_element(increments, {}, &Followed::load_factor);
    }
    // Copies, where the history ends with the statement: loops over a part of one read freed memory.
    [[nodiscard]] Followed at_load(double factor) && { return std::as_const(*this).at_load(factor); }
    [[nodiscard]] Followed at_maximum() && { return std::as_const(*this).at_maximum(); }
    [[nodiscard]] Followed at_minimum() && { return std::as_const(*this).at_minimum(); }
};

/// As small along the line from one point to another as the case wants it about its tip (fine.refine).
inline coarse::Scene refined_along(const Case& input, const Vec2& from, const Vec2& to, double radius) {
    const int levels = std::countr_zero(static_cast<unsigned>(input.fine.refine));
    const Mesh body = coarse::make_mesh(input.mesh, input.cracks, input.regions);
    return coarse::make_scene(input, BodyMesh(refined(body, {{from, to, radius, levels, input.fine.growth}}).mesh));
}

/// With the faces of each increment.
inline RunHistory run_analysis(coarse::EquilibriumFactory& factory, coarse::Scene scene) {
    use_one_thread();
    scene.input.output.faces = Written::All;
    RunHistory history;
    coarse::Listener listener;
    listener.accepted = [&](const coarse::Increment& increment, const coarse::Structure&) {
        history.increments.push_back({increment, increment.equilibrium->structure_displacement()});
        history.increments.back().equilibrium = nullptr;
    };
    listener.attempted = [&](const coarse::LoadStep& step, const coarse::NewtonReport& report) {
        history.attempts.emplace_back(step, report);
    };
    listener.note = [&](const std::string& text) { history.notes.push_back(text); };
    coarse::FatigueAnalysis analysis(scene, factory, listener);
    analysis.run();
    history.life_is_over = analysis.life_is_over();
    history.nominal = analysis.nominal();
    history.cuts = analysis.cuts();
    const coarse::CoarseEffort effort = analysis.effort();
    history.extensions = effort.counts.zone_extensions;
    history.yield_warnings = effort.counts.yield_warnings;
    history.mesh_splits = effort.counts.mesh_splits;
    history.full_checks = effort.work.structure_checks_full;
    history.checks_by_bound = effort.work.structure_checks_by_bound;
    return history;
}

inline RunHistory run_analysis(const Case& input, coarse::EquilibriumFactory& factory) {
    return run_analysis(factory, coarse::refined_scene(input));
}

inline RunHistory run_direct(const Case& input, const coarse::Scene& scene) {
    fine::FineModel fine(input);
    coarse::CondensedFactory factory(&fine, input);
    return run_analysis(factory, scene);
}

inline RunHistory run_direct(const Case& input) { return run_direct(input, coarse::refined_scene(input)); }

/// A correction of Newton's method: relative residuals before and after it, and of the iterate that its tangent is of.
struct Correction {
    double before, after, tangent_of;

    /// What consistent tangents leave at most.
    [[nodiscard]] double bound(double C) const { return C * tangent_of * before; }
};

/// Those of an increment once the set of flowing points and the statuses of multipliers stay as they are.
inline std::vector<Correction> settled_corrections(const coarse::Increment& increment) {
    const auto& iterations = increment.newton.iterations;
    const auto same_branches = [](const coarse::Residual& a, const coarse::Residual& b) {
        return a.yielding_points == b.yielding_points && a.closed == b.closed && b.status_changes == 0;
    };
    std::size_t first = iterations.size() - 1;
    while (first > 0 && same_branches(iterations[first - 1].residual, iterations[first].residual)) --first;
    while (first + 1 < iterations.size() && iterations[first].residual.keeps_factor) ++first;
    std::vector<Correction> corrections;
    double tangent_of = 0.0;
    for (std::size_t k = first; k + 1 < iterations.size(); ++k) {
        const coarse::Residual &r = iterations[k].residual, &next = iterations[k + 1].residual;
        if (!r.keeps_factor) tangent_of = r.largest() / r.scale;
        corrections.push_back({r.largest() / r.scale, next.largest() / next.scale, tangent_of});
    }
    return corrections;
}

/// The cycles of a long run, which ends after so many of them; its increments are not kept.
inline std::vector<coarse::CycleResult> run_cycles(const Case& input, std::size_t enough = 1000000) {
    use_one_thread();
    const coarse::Scene scene = coarse::refined_scene(input);
    fine::FineModel fine(input);
    coarse::CondensedFactory factory(&fine, input);
    std::vector<coarse::CycleResult> cycles;
    coarse::Listener listener;
    listener.accepted = [&](const coarse::Increment& increment, const coarse::Structure&) {
        cycles.insert(cycles.end(), increment.cycles.begin(), increment.cycles.end());
    };
    listener.reached = [&](const coarse::LoadStep&) { return cycles.size() < enough; };
    coarse::FatigueAnalysis(scene, factory, listener).run();
    return cycles;
}

}  // namespace stria::test
