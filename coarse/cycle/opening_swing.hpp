// Whether opening loads go to and fro from growth to growth, with the place of a tip among its elements.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "coarse/cycle/cycle_result.hpp"
#include "coarse/model/scene.hpp"
#include "common/case/case.hpp"

namespace stria::coarse {

/// What K_op / K_max was, growth after growth. A checkpoint holds it.
struct OpeningSwingMemory {
    struct Tip {
        std::vector<int> cycles;     // the last ones under the level, ascending
        std::vector<double> ratios;  // K_op / K_max in each of them
        int said = 0;                // halvings of its elements that have been advised
    };
    LoadBlock level = {};  // of them: the minimum, and the maximum that loading goes to
    std::vector<Tip> tips;
};

/// Places at which a sequence turns: it goes from each to the next by more than `least`, and back again, but for the
/// first and the last place, which may be on the way. Fewer than two: it does not go as far.
[[nodiscard]] std::vector<std::size_t> places_of_turns(const std::vector<double>& values, double least);

/// Looks at the cycles before each growth. Contact beyond the distance of closure is that of whole multipliers, and the
/// first of them is up to two elements beyond it, as the tip stands (docs/verification/closure.md, K_op from growth to
/// growth). What that does to K_op falls with the first power of the size of elements.
class OpeningSwing {
public:
    /// Of a case whose cracks grow.
    explicit OpeningSwing(const Case& input, OpeningSwingMemory memory = {});

    /// A cycle has ended; one result per tip. One sentence for each tip whose K_op / K_max has turned twice within
    /// eight such cycles of one load, by more than 0.04 each time; once, and once more where it takes finer elements.
    [[nodiscard]] std::vector<std::string> add(int cycle, const std::vector<CycleResult>& cycles, const Scene& present);

    [[nodiscard]] const OpeningSwingMemory& memory() const { return memory_; }

private:
    /// From its minimum on.
    [[nodiscard]] LoadBlock level_of(int cycle) const;

    GrowthSection growth_;
    std::vector<LoadBlock> blocks_;
    bool has_levels_;               // no load case varies beside [load]
    std::vector<int> last_cycles_;  // of the blocks
    OpeningSwingMemory memory_;
};

}  // namespace stria::coarse
