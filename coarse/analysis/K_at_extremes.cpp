#include "coarse/analysis/K_at_extremes.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "coarse/growth/crack_advance.hpp"
#include "coarse/growth/modes_of_tip.hpp"

namespace stria::coarse {
namespace {

bool is_of_one_load(const CrackedBody& body, const ReachedExtremes& reached) {
    return reached.maximum.cases.size() == 0 && !body.scene().initial_stress().any();
}

/// One load alone is largest at its minimum, in size: at its maximum it has gone, or presses less. The load at a
/// controlled displacement of zero is found, and has gone but for rounding.
bool is_largest_at_minimum(const CrackedBody& body, const ReachedExtremes& reached) {
    constexpr double rounding = 1e-9;
    return is_of_one_load(body, reached) && !(reached.maximum.main > rounding * std::abs(reached.minimum.main));
}

/// Faces touch, and all rings about a tip hold flow.
bool hides_a_direction(const std::vector<TipResult>& tips) {
    const auto touches = [](const TipResult& tip) { return tip.contact_length > 0.0; };
    return std::ranges::any_of(tips, touches) && std::ranges::any_of(tips, &TipResult::rings_flow);
}

/// K of the tips under loads. Where all rings hold flow it is that of the nominal body with the tractions that faces
/// bear.
std::vector<TipResult> told(const CrackedBody& body, const LoadFactors& loads, std::vector<TipResult> tips,
                            const FaceTractions& faces) {
    if (faces.s.empty()) return tips;
    const std::vector<TipResult> of_loads = nominal_under(loads, body.nominal()),
                                 of_faces = body.K_of_faces(loads, faces);
    for (std::size_t t = 0; t < tips.size(); ++t) {
        if (!std::exchange(tips[t].rings_flow, false)) continue;
        tips[t].K_I = of_loads[t].K_I + of_faces[t].K_I;
        tips[t].K_II = of_loads[t].K_II + of_faces[t].K_II;
        tips[t].K_I_of_wake = tips[t].K_II_of_wake = 0.0;
    }
    return tips;
}

FaceTractions faces_of(const Increment& reached) {
    return hides_a_direction(reached.tips) ? tractions_of(reached.zone.faces) : FaceTractions();
}

}  // namespace

void note_maximum(ReachedExtremes& extremes, const LoadFactors& loads, const Increment& reached) {
    extremes.maximum = loads;
    extremes.tips = reached.tips;
    extremes.faces = faces_of(reached);
}

void note_minimum(ReachedExtremes& extremes, const LoadFactors& loads, const Increment& reached) {
    extremes.minimum = loads;
    extremes.tips_at_minimum = reached.tips;
    extremes.faces_at_minimum = faces_of(reached);
}

std::vector<TipResult> K_at_maximum(const CrackedBody& body, const ReachedExtremes& reached) {
    if (!is_of_one_load(body, reached)) return nominal_under(reached.maximum, body.nominal());
    const double factor = is_largest_at_minimum(body, reached) ? reached.minimum.main : reached.maximum.main;
    return nominal_under(factor < 0.0 ? -1.0 : 1.0, body.nominal());
}

std::vector<TipResult> K_that_turns(const CrackedBody& body, const ReachedExtremes& reached) {
    std::vector<TipResult> nominal = K_at_maximum(body, reached);
    const bool at_least = is_largest_at_minimum(body, reached);
    const std::vector<TipResult>& tips = at_least ? reached.tips_at_minimum : reached.tips;
    if (tips.empty()) return nominal;
    std::vector<double> largest = sizes_of(nominal_under(reached.maximum, body.nominal()));
    const std::vector<double> at_minimum = sizes_of(nominal_under(reached.minimum, body.nominal()));
    for (std::size_t t = 0; t < largest.size(); ++t) largest[t] = std::max(largest[t], at_minimum[t]);
    const auto& [loads, faces] =
        at_least ? std::tie(reached.minimum, reached.faces_at_minimum) : std::tie(reached.maximum, reached.faces);
    return directing(std::move(nominal), told(body, loads, tips, faces), largest);
}

std::vector<TipResult> K_at_minimum(const CrackedBody& body, const ReachedExtremes& reached) {
    if (is_of_one_load(body, reached)) return std::vector<TipResult>(body.nominal().size());
    return nominal_under(reached.minimum, body.nominal());
}

}  // namespace stria::coarse
