#include "coarse/growth/modes_of_tip.hpp"

#include <algorithm>
#include <cmath>

#include "coarse/growth/crack_advance.hpp"
#include "common/case/case_questions.hpp"
#include "common/index.hpp"

namespace stria::coarse {

bool is_rough(const CrackSection& crack) { return crack.contact && crack.contact->friction > 0.0; }

TipResult tip_with(const ModesOfTip& modes, const CrackSection& crack) {
    TipResult tip;
    tip.K_I = may_touch(crack) ? std::max(modes.K_I, 0.0) : modes.K_I;
    tip.K_II = modes.K_II;
    return tip;
}

std::vector<TipResult> nominal_under(const LoadFactors& loads, std::vector<TipResult> nominal) {
    for (TipResult& tip : nominal) {
        tip.K_I = K_I_under(tip, loads);
        tip.K_II = K_II_under(tip, loads);
    }
    return nominal;
}

std::vector<double> sizes_of(const std::vector<TipResult>& nominal) {
    std::vector<double> sizes;
    for (const TipResult& tip : nominal) sizes.push_back(std::hypot(tip.K_I, tip.K_II));
    return sizes;
}

std::vector<ModesOfTip> modes_let_through(const Scene& present, const std::vector<TipResult>& nominal,
                                          const LoadFactors& loads, const std::vector<TipResult>& measured) {
    const std::vector<TipResult> all = nominal_under(loads, nominal), told = directing(all, measured, sizes_of(all));
    std::vector<ModesOfTip> modes;
    for (std::size_t t = 0; t < all.size(); ++t) {
        const bool hidden = is_rough(present.input.cracks[at(present.enriched.tips[t].crack)]) &&
                            measured[t].rings_flow && measured[t].contact_length > 0.0;
        modes.push_back({all[t].K_I, hidden ? std::nan("") : told[t].K_II});
    }
    return modes;
}

void lengthen(std::vector<ModesOfTip>& modes, const Scene& longer, const std::vector<TipResult>& nominal,
              const LoadFactors& loads) {
    for (std::size_t t = 0; t < modes.size(); ++t) {
        modes[t].K_I = K_I_under(nominal[t], loads);
        if (!is_rough(longer.input.cracks[at(longer.enriched.tips[t].crack)]))
            modes[t].K_II = K_II_under(nominal[t], loads);
    }
}

}  // namespace stria::coarse
