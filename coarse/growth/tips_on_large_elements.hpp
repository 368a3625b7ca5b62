// Tips that come to elements larger than the case asks for: metal that has flowed is never split (fine.refine).
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "coarse/model/scene.hpp"

namespace stria::coarse {

class TipsOnLargeElements {
public:
    /// `known`: how often an element must have been split at each tip to be as small as asked for, where that has been
    /// said.
    explicit TipsOnLargeElements(std::vector<int> known = {}) : known_(std::move(known)) {}

    /// What is to be said of tips whose elements are larger than has been said before.
    [[nodiscard]] std::vector<std::string> look_at(const Scene& scene);

    [[nodiscard]] const std::vector<int>& known() const { return known_; }

private:
    std::vector<int> known_;  // one per tip; empty: nothing has been said
};

}  // namespace stria::coarse
