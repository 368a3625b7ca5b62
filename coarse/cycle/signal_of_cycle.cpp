#include "coarse/cycle/signal_of_cycle.hpp"

#include <cmath>

namespace stria::coarse {

void SignalOfCycle::note_change(bool closes, double K, double rise) {
    changed = true;
    if (!closes && rise >= 0.0) {
        rising.K_op = K;
        rising.lost = std::isnan(K);
    } else if (closes && rise < 0.0) {
        if (std::isnan(found.K_cl)) found.K_cl = K;
        rising = {};
    }
}

void SignalOfCycle::note_state(bool is_open, double K, double rise) {
    if (is_open && rise < 0.0) rising = {.K_op = K};
    if (is_open && std::isnan(rising.K_op) && !rising.lost) rising.K_op = K;
    if (is_open) was_open = true;
    if (is_open || rise > 0.0) return;
    rising = {};
    if (changed || !was_open) return;
    found.K_cl = K;
    changed = true;
}

void SignalOfCycle::take(OpeningLoads& largest) const {
    largest.K_op = rising.K_op;
    largest.lost = rising.lost;
}

void SignalOfCycle::take_rest() {
    if (!std::isnan(found.K_op) || found.lost) return;
    found.K_op = rest.K_op;
    found.lost = rest.lost;
}

void SignalOfCycle::miss_rest() {
    if (std::isnan(found.K_op)) found.lost = true;
}

OpeningLoads SignalOfCycle::loads(double K_min) const {
    const bool open_all_cycle = !changed && was_open;
    return open_all_cycle ? OpeningLoads{K_min, K_min} : found;
}

}  // namespace stria::coarse
