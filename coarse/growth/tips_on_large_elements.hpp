// Tips that grow to elements too large for what is there: than the case asks for, since metal that has flowed is never
// split (fine.refine), than opening loads want, or than J and K want beside another metal. Of the start it is said
// before.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "coarse/model/scene.hpp"

namespace stria::coarse {

/// What has been said.
struct SaidOfElements {
    std::vector<int> missing;   // one per tip: how often its element must have been split to be as small as asked for
    std::vector<int> by_metal;  // one per tip: doubts_of_metal()
    std::vector<int> too_near;  // tips whose distance of closure spans too few elements
};

class TipsOnLargeElements {
public:
    explicit TipsOnLargeElements(SaidOfElements said = {}) : said_(std::move(said)) {}

    /// What is to be said of tips whose elements are larger than has been said before. `distance`: of closure, mm, one
    /// per tip; none where nobody looks at closure.
    [[nodiscard]] std::vector<std::string> look_at(const Scene& scene, const std::vector<double>& distance);

    [[nodiscard]] const SaidOfElements& said() const { return said_; }

private:
    SaidOfElements said_;
};

}  // namespace stria::coarse
