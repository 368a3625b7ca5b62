#include "coarse/analysis/K_at_extremes.hpp"

#include <algorithm>
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

std::vector<TipAtExtremes> K_at_extremes(const CrackedBody& body, const ReachedExtremes& reached) {
    const Scene& present = body.scene();
    std::vector<TipAtExtremes> K;
    const std::vector<TipResult> maximum = under(reached.maximum, body.nominal()),
                                 minimum = under(reached.minimum, body.nominal());
    for (std::size_t t = 0; t < maximum.size(); ++t) {
        K.push_back({maximum[t], minimum[t]});
        if (!may_touch(present.input.cracks[at(present.enriched.tips[t].crack)])) continue;
        for (TipResult* tip : {&K.back().maximum, &K.back().minimum}) tip->K_I = std::max(tip->K_I, 0.0);
    }
    return K;
}

std::vector<double> K_of_break(const Scene& present, GrowthDirection direction, std::vector<TipResult> nominal,
                               const LoadFactors& loads, const std::vector<TipResult>& measured) {
    nominal = under(loads, std::move(nominal));
    std::vector<double> K;
    for (const TipResult& tip : nominal) K.push_back(tip.K_I);
    if (direction == GrowthDirection::Straight) return K;
    const std::vector<TipResult> turning =
        directing(present.input.cracks, present.enriched.tips, std::move(nominal), measured);
    for (std::size_t t = 0; t < K.size(); ++t) {
        const CrackSection& crack = present.input.cracks[at(present.enriched.tips[t].crack)];
        TipResult tip = turning[t];
        if (may_touch(crack)) tip.K_I = std::max(tip.K_I, 0.0);
        const bool rough = may_touch(crack) && crack.contact->friction > 0.0;
        if (!rough || !measured[t].rings_flow || measured[t].contact_length == 0.0)
            K[t] = std::max(K[t], K_at_break(tip));
    }
    return K;
}

}  // namespace stria::coarse
