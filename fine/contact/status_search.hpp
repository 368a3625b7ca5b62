// How the statuses of the faces go from one Newton step to the next where the law alone would lead in a circle.
#pragma once

#include <set>
#include <vector>

#include "fine/contact/contact_law.hpp"

namespace stria::fine {

/// Where a set of statuses comes back within one increment, all that slides sticks for a step; where one does again, or
/// nothing slides, only the worst multiplier changes its own from then on (docs/method.md, section 4).
class StatusSearch {
public:
    /// Of an increment.
    void begin() { *this = StatusSearch(); }

    /// The statuses for the next step. `wanted`: by the law, others than the `present` ones; `worst`: the multiplier
    /// that the present ones violate it most at.
    [[nodiscard]] std::vector<FaceStatus> next(const std::vector<FaceStatus>& present, std::vector<FaceStatus> wanted,
                                               int worst);

    [[nodiscard]] bool one_at_a_time() const { return one_at_a_time_; }

private:
    void break_cycle(std::vector<FaceStatus>& wanted);
    /// Instead of `one`, which has been there: what the worst multiplier has not been yet, if it has friction.
    [[nodiscard]] std::vector<FaceStatus> another(const std::vector<FaceStatus>& present, std::vector<FaceStatus> one,
                                                  int worst);

    std::set<std::vector<FaceStatus>> visited_, alone_;  // what was wanted; what came of one at a time
    bool tried_to_stick_ = false, one_at_a_time_ = false;
};

}  // namespace stria::fine
