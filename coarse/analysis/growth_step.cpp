// A step of growth: figure 3, and the nominal solution that says how far and where.
#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <utility>

#include "coarse/analysis/fatigue_analysis.hpp"
#include "coarse/analysis/growth_law.hpp"
#include "coarse/structure/gamma.hpp"
#include "coarse/zone/zone_selection.hpp"
#include "common/error.hpp"
#include "common/stopwatch.hpp"

namespace stria::coarse {

// K_1(a): an elastic solution on the coarse mesh with traction-free faces. Beyond the far body, which it shares with
// the structure, it condenses what is near or in the zone.
NominalSolution FatigueAnalysis::solve_nominal_of(const Scene& scene) {
    note_if_large("elastic solution of the whole body");
    const bool known = knows_far_body();
    auto near = std::exchange(factors_.near, nullptr);
    auto body = condense(scene, ElementSet(scene.mesh.elements.size()));
    factors_.near = std::move(near);  // of the structure
    // A far body that was there before: the guard knows how it answers.
    NominalSolution nominal = known ? solve_nominal_near(std::move(body)) : solve_nominal(std::move(body));
    nominal_displacement_ = known ? Eigen::VectorXd() : nominal.displacement;
    nominal_ = nominal.tips;
    return nominal;
}

/// The K of eq. (3), one a tip.
std::vector<double> FatigueAnalysis::largest_nominal_K(const NominalSolution& nominal) {
    const LoadSection& load = scene_->input.load;
    controller_.set_scale(target_of_unit(load, nominal_, grown()));
    return largest_K_I(load, nominal, grown());
}

bool FatigueAnalysis::has_grown_enough() const {
    const GrowthSection& growth = *scene_->input.growth;
    if (!last_cycle_.empty() && fastest_rate(growth, last_cycle_) <= 0.0) {
        listener_.note("nothing drives a tip any more: the crack is arrested");
        return true;
    }
    for (std::size_t t = 0; t < nominal_.size(); ++t) {
        const double K = nominal_[t].K_I * load_factor_;
        if (growth.until && nominal_[t].a >= *growth.until * (1.0 - 1e-9)) {
            listener_.note(fmt::format("tip {}: the crack is {:.6g} mm long (growth.until)", t, nominal_[t].a));
            return true;
        }
        if (growth.toughness && K >= *growth.toughness) {
            listener_.note(fmt::format("tip {}: K = {:.6g} MPa sqrt(mm) (growth.toughness)", t, K));
            return true;
        }
    }
    return false;
}

// (a) The cracks are longer, and nothing else changes: no stress, no displacement, no internal variable; (b) at
// constant load the body finds equilibrium with them.
bool FatigueAnalysis::grow(const LoadStep& reached) {
    auto longer = scene_of_longer_cracks(
        with_longer_cracks(*scene_, nominal_, advances(*scene_->input.growth, last_cycle_, nominal_.size())));
    if (!longer) return false;
    take(std::move(longer));
    LoadStep step;
    step.cycle = reached.cycle;
    step.target = reached.target;
    step.reversal = true;  // what flows while it grows is no part of the half cycles before and after
    NewtonReport report = attempt(step);
    while (report.converged && zone_must_grow(step)) report = attempt(step);
    if (!report.converged) {
        throw NumericalFailure(fmt::format("after the crack has grown in cycle {}: {} at {}", step.cycle,
                                           report.failure, to_text(step.target)));
    }
    accept(step, report, {});
    controller_.forget_increments();
    return true;
}

// Null where a crack leaves the body or meets another one.
std::unique_ptr<Scene> FatigueAnalysis::scene_of_longer_cracks(const Case& input) {
    try {
        auto next = std::make_unique<Scene>(make_scene(input, scene_->mesh));
        if (next->enriched.tips.size() == scene_->enriched.tips.size()) return next;
        listener_.note("the next advance takes a crack out of the body: growth ends here");
    } catch (const CaseError& error) {
        listener_.note(fmt::format("growth ends here: {}", error.what()));
    }
    return nullptr;
}

// Everything that a longer crack changes is near it: the far body serves again.
void FatigueAnalysis::take(std::unique_ptr<Scene> longer) {
    const Stopwatch watch(growth_s_);
    refresh_committed();
    const Scene& before = *scene_;
    const ElementSet in_zone = zone_about(*longer);
    if (longer->input.growth->retain == Retain::All && needs_fine(longer->input)) {
        auto retaining = std::make_unique<Scene>(with_functions_left(*longer, before.enriched));
        if (nominal_displacement_.size() > 0)
            nominal_displacement_ = carry_over(longer->enriched, nominal_displacement_, retaining->enriched,
                                               Eigen::VectorXd::Zero(retaining->enriched.unknowns));
        longer = std::move(retaining);
    }
    committed_ =
        carry_over(before.enriched, committed_, longer->enriched, Eigen::VectorXd::Zero(longer->enriched.unknowns));
    scene_ = longer.get();
    build(in_zone);
    grown_ = std::move(longer);
}

// What a longer crack changes the functions of, and what eq. (3) wants about the tips, is fine before the functions
// change: its state is kept. Without a zone nobody sees what is released.
ElementSet FatigueAnalysis::zone_about(const Scene& longer) {
    const ElementSet now = structure_->in_zone();
    const bool has_zone = !now.none();
    ElementSet in_zone = has_zone ? with_changed_functions(now, scene_->enriched, longer.enriched) : now;
    far_ = far_elements(longer, in_zone, far_);
    NominalSolution nominal = solve_nominal_of(longer);
    in_zone |= select_zone(longer, largest_nominal_K(nominal));
    if (!has_zone) {
        work_.released = std::numeric_limits<double>::quiet_NaN();
        structure_ = std::move(nominal.structure);
    } else if (in_zone != now) {
        factory_.extend_zone(patch_of(in_zone, gamma_of(*scene_, in_zone)));
    }
    return in_zone;
}

}  // namespace stria::coarse
