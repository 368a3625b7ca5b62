#include "coarse/analysis/K_at_extremes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "coarse/growth/crack_advance.hpp"
#include "coarse/growth/modes_of_tip.hpp"

namespace stria::coarse {
namespace {

bool is_of_one_load(const CrackedBody& body, const ReachedExtremes& reached) {
    return reached.maximum.cases.size() == 0 && !body.scene().initial_stress().any();
}

/// Where a load has gone at its maximum the one of the minimum is left. The load at a controlled displacement of zero
/// is found, and has gone but for rounding.
double sign_of_load(const ReachedExtremes& reached) {
    constexpr double rounding = 1e-9;
    const bool is_loaded = std::abs(reached.maximum.main) > rounding * std::abs(reached.minimum.main);
    const double factor = is_loaded ? reached.maximum.main : reached.minimum.main;
    return factor < 0.0 ? -1.0 : 1.0;
}

/// Faces touch, and all rings about a tip hold flow.
bool hides_a_direction(const std::vector<TipResult>& tips) {
    const auto touches = [](const TipResult& tip) { return tip.contact_length > 0.0; };
    return std::ranges::any_of(tips, touches) && std::ranges::any_of(tips, &TipResult::rings_flow);
}

/// K at the maximum. Where all rings hold flow it is that of the nominal body with the tractions that faces bear.
std::vector<TipResult> told(const CrackedBody& body, const ReachedExtremes& reached) {
    std::vector<TipResult> tips = reached.tips;
    if (reached.faces.s.empty()) return tips;
    const std::vector<TipResult> of_loads = nominal_under(reached.maximum, body.nominal()),
                                 of_faces = body.K_of_faces(reached.maximum, reached.faces);
    for (std::size_t t = 0; t < tips.size(); ++t) {
        if (!std::exchange(tips[t].rings_flow, false)) continue;
        tips[t].K_I = of_loads[t].K_I + of_faces[t].K_I;
        tips[t].K_II = of_loads[t].K_II + of_faces[t].K_II;
        tips[t].K_I_of_wake = tips[t].K_II_of_wake = 0.0;
    }
    return tips;
}

}  // namespace

void note_maximum(ReachedExtremes& extremes, const LoadFactors& loads, const Increment& reached) {
    extremes.maximum = loads;
    extremes.tips = reached.tips;
    extremes.faces = hides_a_direction(reached.tips) ? tractions_of(reached.zone.faces) : FaceTractions();
}

std::vector<TipResult> K_at_maximum(const CrackedBody& body, const ReachedExtremes& reached) {
    const bool one_load = is_of_one_load(body, reached);
    return nominal_under(one_load ? sign_of_load(reached) : reached.maximum, body.nominal());
}

std::vector<TipResult> K_that_turns(const CrackedBody& body, const ReachedExtremes& reached) {
    std::vector<TipResult> nominal = K_at_maximum(body, reached);
    if (reached.tips.empty()) return nominal;
    std::vector<double> largest = sizes_of(nominal_under(reached.maximum, body.nominal()));
    const std::vector<double> at_minimum = sizes_of(nominal_under(reached.minimum, body.nominal()));
    for (std::size_t t = 0; t < largest.size(); ++t) largest[t] = std::max(largest[t], at_minimum[t]);
    return directing(std::move(nominal), told(body, reached), largest);
}

std::vector<TipResult> K_at_minimum(const CrackedBody& body, const ReachedExtremes& reached) {
    if (is_of_one_load(body, reached)) return std::vector<TipResult>(body.nominal().size());
    return nominal_under(reached.minimum, body.nominal());
}

}  // namespace stria::coarse
