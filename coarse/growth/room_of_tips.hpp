// Tips that grow near to an edge, a load, a bend or another tip, until no ring tells their K: said once of each.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "coarse/fracture/structure_rings.hpp"

namespace stria::coarse {

class RoomOfTips {
public:
    /// `known`: those that have been spoken of.
    explicit RoomOfTips(std::vector<int> known = {}) : known_(std::move(known)) {}

    /// What is to be said of tips whose largest ring has become too small (room_warning()), which are known from here
    /// on. `rings`: of a structure, whose scene the tips are of.
    [[nodiscard]] std::vector<std::string> look_at(const StructureRings& rings);

    [[nodiscard]] const std::vector<int>& known() const { return known_; }

private:
    std::vector<int> known_;  // indices of tips
};

}  // namespace stria::coarse
