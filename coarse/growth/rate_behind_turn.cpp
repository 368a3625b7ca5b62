#include "coarse/growth/rate_behind_turn.hpp"

#include <cmath>

#include "coarse/fracture/turned_tip.hpp"
#include "coarse/growth/growth_law.hpp"
#include "common/case/case_questions.hpp"

namespace stria::coarse {
namespace {

/// Beside a K_II that slides what is left of K_I presses nothing.
bool is_pressed(const ModesOfTip& modes) { return modes.K_I < -0.01 * std::abs(modes.K_II); }

}  // namespace

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

}  // namespace stria::coarse
