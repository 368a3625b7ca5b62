#include "coarse/analysis/K_at_extremes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "coarse/growth/crack_advance.hpp"
#include "common/case/case_questions.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {

bool is_of_one_load(const CrackedBody& body, const ReachedExtremes& reached) {
    return reached.maximum.cases.size() == 0 && !body.scene().initial_stress().any();
}

/// Where a load has gone at its maximum the one of the minimum is left.
double sign_of_load(const ReachedExtremes& reached) {
    const double factor = reached.maximum.main != 0.0 ? reached.maximum.main : reached.minimum.main;
    return factor < 0.0 ? -1.0 : 1.0;
}

bool is_rough(const CrackSection& crack) { return crack.contact && crack.contact->friction > 0.0; }

/// Beside a K_II that slides what is left of K_I presses nothing.
bool is_pressed(const ModesOfTip& modes) { return modes.K_I < -0.01 * std::abs(modes.K_II); }

/// Faces that may touch are not pressed by a K_I below zero.
TipResult tip_with(const ModesOfTip& modes, const CrackSection& crack) {
    TipResult tip;
    tip.K_I = may_touch(crack) ? std::max(modes.K_I, 0.0) : modes.K_I;
    tip.K_II = modes.K_II;
    return tip;
}

std::vector<TipResult> under(const LoadFactors& factors, std::vector<TipResult> nominal) {
    for (TipResult& tip : nominal) {
        tip.K_I = K_I_under(tip, factors);
        tip.K_II = K_II_under(tip, factors);
    }
    return nominal;
}

}  // namespace

std::vector<TipResult> K_at_maximum(const CrackedBody& body, const ReachedExtremes& reached) {
    const bool one_load = is_of_one_load(body, reached);
    std::vector<TipResult> nominal = under(one_load ? sign_of_load(reached) : reached.maximum, body.nominal());
    if (reached.tips.empty()) return nominal;
    const Scene& present = body.scene();
    return directing(present.input.cracks, present.enriched.tips, std::move(nominal), reached.tips);
}

std::vector<TipResult> K_at_minimum(const CrackedBody& body, const ReachedExtremes& reached) {
    if (is_of_one_load(body, reached)) return std::vector<TipResult>(body.nominal().size());
    return under(reached.minimum, body.nominal());
}

std::vector<ModesOfTip> modes_let_through(const Scene& present, const std::vector<TipResult>& nominal,
                                          const LoadFactors& loads, const std::vector<TipResult>& measured) {
    const std::vector<TipResult> all = under(loads, nominal),
                                 told = directing(present.input.cracks, present.enriched.tips, all, measured);
    std::vector<ModesOfTip> modes;
    for (std::size_t t = 0; t < all.size(); ++t) {
        const bool hidden = is_rough(present.input.cracks[at(present.enriched.tips[t].crack)]) &&
                            measured[t].rings_flow && measured[t].contact_length > 0.0;
        modes.push_back({all[t].K_I, hidden ? std::nan("") : told[t].K_II});
    }
    return modes;
}

double rate_behind_turn(const GrowthSection& growth, const CrackSection& crack, const TurningModes& modes,
                        std::size_t tip, double angle) {
    if (growth.law == GrowthLaw::Ctod || (grows_by_opening_loads(growth) && may_touch(crack))) return std::nan("");
    GrowthSection law = growth;
    if (grows_by_opening_loads(growth)) {  // without contact dK_eff is dK
        law.driving = GrowthDriving::Range;
        law.walker = 1.0;
    }
    const std::size_t tips = modes.minimum.size(), cycles = tips > 0 ? modes.cycles.size() / (2 * tips) : 0;
    double sum = 0.0;
    for (std::size_t c = 0; c < cycles; ++c) {
        const ModesOfTip &most = modes.cycles[2 * c * tips + tip], &least = modes.cycles[(2 * c + 1) * tips + tip];
        const TipAtExtremes K{tip_with(most, crack), tip_with(least, crack)};
        const double at_most = K_just_turned(K.maximum, angle), at_least = K_just_turned(K.minimum, angle);
        if (std::isnan(at_most + at_least)) return std::nan("");
        if (is_rough(crack) && is_pressed(at_most > at_least ? most : least)) return std::nan("");
        sum += rate_just_turned(law, K, angle);
    }
    return cycles > 0 ? sum / static_cast<double>(cycles) : std::nan("");
}

std::vector<double> K_of_break(const Scene& present, GrowthDirection direction, const std::vector<ModesOfTip>& modes) {
    std::vector<double> K;
    for (std::size_t t = 0; t < modes.size(); ++t) {
        const CrackSection& crack = present.input.cracks[at(present.enriched.tips[t].crack)];
        const double turned = direction == GrowthDirection::Straight ? 0.0 : K_at_break(tip_with(modes[t], crack));
        K.push_back(std::max(modes[t].K_I, turned));
    }
    return K;
}

}  // namespace stria::coarse
