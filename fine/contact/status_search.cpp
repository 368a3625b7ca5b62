#include "fine/contact/status_search.hpp"

#include <algorithm>

#include "common/index.hpp"

namespace stria::fine {

std::vector<FaceStatus> StatusSearch::next(const std::vector<FaceStatus>& present, std::vector<FaceStatus> wanted,
                                           int worst) {
    if (visited_.contains(wanted)) break_cycle(wanted);
    visited_.insert(wanted);
    if (!one_at_a_time_) return wanted;
    std::vector<FaceStatus> one = present;
    one[at(worst)] = wanted[at(worst)];
    return alone_.insert(one).second ? one : another(present, std::move(one), worst);
}

std::vector<FaceStatus> StatusSearch::another(const std::vector<FaceStatus>& present, std::vector<FaceStatus> one,
                                              int worst) {
    const FaceStatus was = present[at(worst)], wanted = one[at(worst)];
    if (!slides(was) && !slides(wanted)) return one;
    for (const FaceStatus status :
         {FaceStatus::Open, FaceStatus::Stick, FaceStatus::SlipForward, FaceStatus::SlipBack}) {
        one[at(worst)] = status;
        if (status != was && alone_.insert(one).second) return one;
    }
    one[at(worst)] = wanted;
    return one;
}

// Slips of faces that were apart, or that slide now on and now back, say nothing of whether they stick.
void StatusSearch::break_cycle(std::vector<FaceStatus>& wanted) {
    one_at_a_time_ = one_at_a_time_ || tried_to_stick_ || std::ranges::none_of(wanted, slides);
    if (one_at_a_time_) return;
    tried_to_stick_ = true;
    visited_.clear();
    std::ranges::replace_if(wanted, slides, FaceStatus::Stick);
}

}  // namespace stria::fine
