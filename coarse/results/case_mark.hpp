// Which case a checkpoint is of, and whether a run may go on from it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "coarse/load/load_controller.hpp"
#include "coarse/model/scene.hpp"

namespace stria::coarse {

struct CaseMark {
    std::string text;               // all of the case that must not change on the way, as a case file
    std::vector<LoadBlock> blocks;  // of the load history, which may change where the load has not been yet
    double scale = 1.0;
    int repeat = 1;
    std::size_t legs_before = 0;  // those of the blocks (CaseHistories::legs_before_history)
    std::uint64_t mesh = 0;       // digest of its nodes, elements, materials and boundaries
};

CaseMark mark_of(const Scene& scene);

/// Of the load history of the case.
int cycles_of(const CaseMark& mark);

/// Throws CaseError, naming the first difference, where a run of the case `now` cannot go on from a checkpoint of the
/// case `then` that was written when the load had come as far as `reached`.
void check_same_case(const CaseMark& then, const CaseMark& now, const LoadPosition& reached);

}  // namespace stria::coarse
